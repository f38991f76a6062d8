#ifndef coapt_contact_encounter_finder_h
#define coapt_contact_encounter_finder_h

#include <coapt/contact/candidate_search.h>
#include <coapt/contact/contact_parameters.h>
#include <coapt/contact/facing_rule.h>

#include <array>
#include <vector>

namespace coapt
{
  /**
   * Finds what faces the columns of a mid-surface in motion, and looks only at
   * what may have come near since it was measured last.
   */
  class EncounterFinder
  {
  public:
    /**
     * For the given @p columns of a surface with @p triangles, all of whose
     * columns are at @p reference (m) at first; @p rule is theirs and must
     * outlive this. What is nearer than @p reach (m) is always found, what is
     * farther, up to half of the search margin beyond @p onset (m), every
     * "search interval" steps.
     */
    EncounterFinder(const std::vector<dealii::Point<3>> &reference,
                    const std::vector<std::array<unsigned int, 3>> &triangles,
                    const FacingRule &rule,
                    const std::vector<unsigned int> &columns,
                    const ContactParameters &parameters,
                    const double onset,
                    const double reach);

    /** Begins a step with all columns at @p points (m), which must stay as
     * they are. Throws NumericalError if one is not finite. */
    void
    begin_step(const std::vector<dealii::Point<3>> &points);

    /** Whether everything is to be measured in this step. */
    bool
    measures_all() const
    {
      return measure_all;
    }

    /**
     * Finds the nearest triangle that faces the i-th of the columns, and the
     * nearest one in the opposite direction within reach. Returns how many
     * there are. The first one may be beyond reach if @p measure is true.
     */
    unsigned int
    find(const unsigned int i, const bool measure, Encounter (&encounters)[2]);

    /** Triangles that are never found for the i-th of the columns. */
    const std::vector<unsigned int> &
    neighbours(const unsigned int i) const
    {
      return search.neighbours(i);
    }

    /** When and where was searched: the same on all ranks. */
    struct Phase
    {
      unsigned int steps = 0;               // since all was measured
      std::vector<dealii::Point<3>> points; // in the last search, m

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &steps &points;
      }
    };

    Phase
    phase() const
    {
      return {steps_since_check, search.searched_points()};
    }

    /** Goes on from the @p phase of an earlier run. */
    void
    restore(const Phase &phase);

  private:
    unsigned int
    find_within(const unsigned int i,
                const double distance,
                Encounter (&encounters)[2]);

    const ContactParameters parameters;
    const double onset, reach;
    const FacingRule &rule;
    std::vector<unsigned int> columns;
    CandidateSearch search;

    const std::vector<dealii::Point<3>> *points = nullptr;
    double displacement                         = 0; // since the last search
    bool measure_all                            = true;
    unsigned int steps_since_check              = 0;
    std::vector<double> least_distance; // lower bound, by column
    std::vector<Encounter> near;        // scratch
  };
} // namespace coapt

#endif
