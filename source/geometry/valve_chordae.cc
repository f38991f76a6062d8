#include <coapt/base/exceptions.h>
#include <coapt/geometry/valve_generator.h>

#include <algorithm>
#include <cmath>

namespace coapt
{
  using namespace dealii;

  namespace
  {
    /** Where a chorda is meant to hold the leaflet, and from where. */
    struct Site
    {
      std::string id;
      bool primary;
      bool right;
      double angle, height; // rad on its own side; fraction
    };

    /** Papillary tip of one side. */
    Point<3>
    papillary_tip(const ValveParameters &valve, const bool right)
    {
      Point<3> tip = valve.papillary_tip;
      if (!right)
        tip[0] *= -1;
      return tip;
    }

    /** Name of that tip as a held node. */
    std::string
    papillary_name(const bool right)
    {
      return right ? "papillary_right" : "papillary_left";
    }

    std::vector<Site>
    sites(const ValveParameters &valve)
    {
      std::vector<Site> result;
      for (const bool right : {true, false})
        {
          const std::string side = right ? "R-" : "L-";
          for (unsigned int n = 0; n < valve.primary_angles.size(); ++n)
            result.push_back({side + "P" + std::to_string(n + 1),
                              true,
                              right,
                              valve.primary_angles[n],
                              1.});
          for (unsigned int n = 0; n < valve.secondary_angles.size(); ++n)
            result.push_back({side + "S" + std::to_string(n + 1),
                              false,
                              right,
                              valve.secondary_angles[n],
                              valve.secondary_heights[n]});
        }
      return result;
    }

    void
    check_removed(const ValveParameters &valve)
    {
      const std::vector<std::string> ids = chordae_ids(valve);
      for (const std::string &id : valve.removed_chordae)
        if (std::find(ids.begin(), ids.end(), id) == ids.end())
          {
            std::string list;
            for (const std::string &valid : ids)
              list += (list.empty() ? "" : ", ") + valid;
            throw InputError("Chordae/Removed chordae names \"" + id +
                             "\", which does not exist; there are: " + list +
                             ".");
          }
    }

    /**
     * Column of the mesh nearest to a place, in the coordinates of the
     * unrolled leaflet. The angle is rounded on the right side and then
     * mirrored, so that the valve stays symmetric.
     */
    unsigned int
    nearest_column(const ValveParameters &valve, const Site &site)
    {
      const int n = valve.n_circumferential;
      int index   = std::lround(site.angle / (2 * numbers::PI) * n);
      if (!site.right)
        index = std::lround(n / 2. - index);
      const unsigned int i = (index % n + n) % n;
      const unsigned int j =
        valve.n_root_rows + std::lround(site.height * valve.n_radial);
      return i * (valve.n_root_rows + valve.n_radial + 1) + j;
    }

    /** Fills nodes and weights; returns the weighted point of attachment. */
    Point<3>
    attach(const Leaflet &leaflet,
           const std::vector<double> &nodal_mass,
           const Point<3> &center,
           const double radius,
           Chorda &chorda)
    {
      double sum = 0;
      Point<3> attachment;
      for (unsigned int node = 0; node < leaflet.mesh.points.size(); ++node)
        {
          const Point<3> &x = leaflet.mesh.points[node];
          const double w    = nodal_mass[node] *
            (1 - center.distance_square(x) / (radius * radius));
          if (w <= 0)
            continue;
          chorda.nodes.push_back(node);
          chorda.weights.push_back(w);
          attachment += w * x;
          sum += w;
        }
      if (!(sum > 0))
        throw InputError("Chorda " + chorda.id +
                         " is attached to nothing: no node of the leaflet is "
                         "within Chordae/Influence radius = " +
                         std::to_string(radius * 1e3) + " mm of its place.");
      for (double &w : chorda.weights)
        w /= sum;
      return Point<3>(attachment / sum);
    }

    ChordaClass
    chorda_class(const ValveParameters &valve, const Site &site)
    {
      const bool anterior = site.angle >= valve.commissure_angle - 1e-9;
      if (site.primary)
        return anterior ? ChordaClass::anterior_primary
                        : ChordaClass::posterior_primary;
      return anterior ? ChordaClass::anterior_secondary
                      : ChordaClass::posterior_secondary;
    }

    Chorda
    create_chorda(const ValveParameters &valve,
                  const Leaflet &leaflet,
                  const std::vector<double> &nodal_mass,
                  const Site &site)
    {
      Chorda chorda;
      chorda.id           = site.id;
      chorda.chorda_class = chorda_class(valve, site);
      chorda.diameter =
        site.primary ? valve.primary_diameter : valve.secondary_diameter;
      chorda.modulus = valve.chordae_modulus;
      chorda.tip     = papillary_tip(valve, site.right);
      const auto tip = leaflet.held_sets.find(papillary_name(site.right));
      if (tip != leaflet.held_sets.end())
        chorda.origin_node = tip->second.front();

      const unsigned int column = nearest_column(valve, site);
      const auto place          = leaflet.column_coordinates[column];
      const auto &nodes         = leaflet.columns[column];
      const Point<3> center     = leaflet.mesh.points[nodes.front()] +
        0.5 *
          (leaflet.mesh.points[nodes.back()] -
           leaflet.mesh.points[nodes.front()]);
      const Point<3> attachment =
        attach(leaflet, nodal_mass, center, valve.influence_radius, chorda);

      const double factor = site.primary ? valve.primary_length_factor
                                         : valve.secondary_length_factor;
      const double closed_length =
        closed_position(valve, place[0], place[1]).distance(chorda.tip);
      chorda.open_length = attachment.distance(chorda.tip);
      chorda.rest_length =
        std::max(factor * closed_length / 1.02, 0.98 * chorda.open_length);
      return chorda;
    }
  } // namespace



  void
  add_papillary_nodes(const ValveParameters &valve, Leaflet &leaflet)
  {
    for (const bool right : {true, false})
      {
        leaflet.held_sets[papillary_name(right)] = {
          static_cast<unsigned int>(leaflet.mesh.points.size())};
        leaflet.mesh.points.push_back(papillary_tip(valve, right));
        leaflet.pinned.push_back(true);
        leaflet.chordae_mass.push_back(0.);
      }
  }



  std::vector<std::string>
  chordae_ids(const ValveParameters &valve)
  {
    std::vector<std::string> ids;
    for (const Site &site : sites(valve))
      ids.push_back(site.id);
    return ids;
  }



  std::vector<Chorda>
  generate_chordae(const ValveParameters &valve,
                   const Leaflet &leaflet,
                   const std::vector<double> &nodal_mass)
  {
    check_removed(valve);
    const auto &removed = valve.removed_chordae;
    std::vector<Chorda> chordae;
    for (const Site &site : sites(valve))
      if (std::find(removed.begin(), removed.end(), site.id) == removed.end())
        chordae.push_back(create_chorda(valve, leaflet, nodal_mass, site));
    return chordae;
  }
} // namespace coapt
