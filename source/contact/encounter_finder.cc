#include <coapt/contact/encounter_finder.h>

#include <algorithm>
#include <limits>

namespace coapt
{
  using dealii::Point;

  namespace
  {
    /** Two directions are opposite if their cosine is below this. */
    constexpr double opposite = -0.2;
  } // namespace



  EncounterFinder::EncounterFinder(
    const std::vector<Point<3>> &reference,
    const std::vector<std::array<unsigned int, 3>> &triangles,
    const FacingRule &rule,
    const std::vector<unsigned int> &columns,
    const ContactParameters &parameters,
    const double onset,
    const double reach)
    : parameters(parameters)
    , onset(onset)
    , reach(reach)
    , rule(rule)
    , columns(columns)
    , search(reference,
             triangles,
             parameters.exclusion_distance + parameters.clearance,
             columns)
    , least_distance(columns.size())
  {
  }



  void
  EncounterFinder::restore(const Phase &phase)
  {
    steps_since_check = phase.steps;
    search.find(phase.points, onset + parameters.search_margin);
  }



  // Two columns approach by twice their displacement at most. Candidates are
  // complete for all gaps to be reported while this is below half the margin;
  // renewal before that only makes them fewer to look at.
  void
  EncounterFinder::begin_step(const std::vector<Point<3>> &points)
  {
    this->points          = &points;
    displacement          = search.displacement(points);
    const double approach = 2 * displacement / parameters.search_margin;
    measure_all           = ++steps_since_check >= parameters.search_interval;
    if (approach > 0.5 || (measure_all && approach > 0.1))
      {
        search.find(points, onset + parameters.search_margin);
        displacement = 0;
        measure_all  = true;
      }
    if (measure_all)
      steps_since_check = 0;
  }



  unsigned int
  EncounterFinder::find(const unsigned int i,
                        const bool measure,
                        Encounter (&encounters)[2])
  {
    if (measure)
      return find_within(i, onset + 0.5 * parameters.search_margin, encounters);
    if (least_distance[i] - 2 * displacement <= reach)
      return find_within(i, reach, encounters);
    return 0;
  }



  // Measured distances sharpen the bounds of the candidates, and the nearest
  // one moves to the front, so that in the next step few others have to be
  // measured.
  unsigned int
  EncounterFinder::find_within(const unsigned int i,
                               const double distance,
                               Encounter (&encounters)[2])
  {
    const unsigned int column = columns[i];
    auto &list                = search.candidates(i);
    const double approach     = 2 * displacement;

    near.clear(); // any of these may turn out to be the opposite one
    unsigned int n = 0;
    double nearest = distance;
    double least   = std::numeric_limits<double>::max();
    for (auto &candidate : list)
      {
        const bool measure =
          candidate.least_distance - approach <= std::max(nearest, reach);
        Encounter other;
        if (measure)
          {
            other = rule.encounter(*points, column, candidate.triangle);
            candidate.least_distance =
              std::max(candidate.least_distance, other.distance - approach);
          }
        least = std::min(least, candidate.least_distance);
        if (measure && other.distance < reach)
          near.push_back(other);
        if (measure && other.distance <= nearest &&
            rule.faces(*points, column, other))
          {
            nearest       = other.distance;
            encounters[0] = other;
            n             = 1;
            std::swap(candidate, list.front());
          }
      }
    least_distance[i] = least;
    nearest           = reach;
    for (const Encounter &other : near)
      if (other.distance < nearest &&
          other.normal * encounters[0].normal < opposite &&
          rule.faces(*points, column, other))
        {
          nearest       = other.distance;
          encounters[1] = other;
          n             = 2;
        }
    return n;
  }
} // namespace coapt
