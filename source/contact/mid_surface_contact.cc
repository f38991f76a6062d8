#include <coapt/contact/mid_surface_contact.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace coapt
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    /** Where a column's sums over the ranks are kept. */
    enum Slot : unsigned int
    {
      normal_impulse     = 0, // vector
      tangential_impulse = 3, // vector
      pressure           = 6, // sum of the magnitudes of normal impulses
      gap                = 7,
      direction          = 8,  // vector
      partner            = 11, // number of a triangle, exact as a double
      normal_couple      = 12, // vectors
      tangential_couple  = 15,
      n_slots            = 18
    };

    /** Means over tributary areas are taken anew when a column has slid by this
     * part of the spacing of columns. */
    constexpr double renewed_after = 0.02;

    std::vector<unsigned int>
    columns_of_rank(const unsigned int n_columns, MPI_Comm communicator)
    {
      // Cyclic, since only part of the leaflet is in contact.
      std::vector<unsigned int> columns;
      const unsigned int n_ranks =
        dealii::Utilities::MPI::n_mpi_processes(communicator);
      for (unsigned int c =
             dealii::Utilities::MPI::this_mpi_process(communicator);
           c < n_columns;
           c += n_ranks)
        columns.push_back(c);
      return columns;
    }

    std::vector<Point<3>>
    reference_positions(const MidSurface &surface, const Leaflet &leaflet)
    {
      std::vector<double> X;
      for (const auto &point : leaflet.mesh.points)
        for (unsigned int d = 0; d < 3; ++d)
          X.push_back(point[d]);
      std::vector<Point<3>> points(surface.n_columns());
      surface.positions(X.data(), points);
      return points;
    }

    double
    mean_spacing(const MidSurface &surface, const std::vector<Point<3>> &points)
    {
      std::vector<double> areas;
      surface.areas(points, areas);
      return std::sqrt(std::accumulate(areas.begin(), areas.end(), 0.) /
                       std::max(surface.n_columns(), 1u));
    }

    // Part of the tributary area touches if the column is less than a spacing
    // beyond a free edge.
    double
    reach_of(const double onset,
             const double spacing,
             const ContactParameters &parameters)
    {
      return std::min(std::hypot(onset, spacing),
                      onset + 0.5 * parameters.search_margin);
    }

    void
    add(double *sum, const double factor, const Tensor<1, 3> &vector)
    {
      for (unsigned int d = 0; d < 3; ++d)
        sum[d] += factor * vector[d];
    }

    Tensor<1, 3>
    vector_at(const double *sum)
    {
      return Point<3>(sum[0], sum[1], sum[2]);
    }
  } // namespace



  MidSurfaceContact::MidSurfaceContact(const Leaflet &leaflet,
                                       const std::vector<double> &nodal_mass,
                                       const double density,
                                       const ContactParameters &parameters,
                                       MPI_Comm communicator)
    : parameters(parameters)
    , thickness(leaflet.thickness)
    , communicator(communicator)
    , law(parameters)
    , surface(leaflet, nodal_mass)
    , rotation(surface)
    , own_columns(columns_of_rank(surface.n_columns(), communicator))
    , points(reference_positions(surface, leaflet))
    , spacing(mean_spacing(surface, points))
    , areal_mass(density * std::min(thickness, spacing))
    , reach(reach_of(thickness + parameters.clearance, spacing, parameters))
    , rule(surface.triangles(), surface.n_columns())
    , finder(points,
             surface.triangles(),
             rule,
             own_columns,
             parameters,
             thickness + parameters.clearance,
             reach)
    , patches(surface, rule)
  {
    const unsigned int n = surface.n_columns();
    surface.areas(points, columns.reference_area);
    columns.current_area = columns.reference_area;
    columns.gap.assign(n, no_gap);
    columns.pressure_impulse.assign(n, 0.);
    columns.normals.resize(n);
    columns.partner.assign(n, no_partner);
    memories.resize(own_columns.size());
  }



  double
  MidSurfaceContact::stiffness(const double dt) const
  {
    return std::min(parameters.max_stiffness,
                    parameters.stiffness_factor * areal_mass / (dt * dt));
  }



  const MidSurfaceContact::ColumnState &
  MidSurfaceContact::state() const
  {
    return columns;
  }



  void
  MidSurfaceContact::clear_accumulators()
  {
    columns.pressure_impulse.assign(surface.n_columns(), 0.);
    time = 0;
  }



  double
  MidSurfaceContact::accumulated_time() const
  {
    return time;
  }



  MidSurfaceContact::Pair
  MidSurfaceContact::pair_up(const unsigned int i,
                             const Encounter &encounter,
                             TributaryPatch &patch)
  {
    const unsigned int column = own_columns[i];
    const double area         = columns.current_area[column];
    TributaryPatches::Offset offset{{}, 0.};
    bool is_current = patch.triangle != TributaryPatch::none;
    if (is_current)
      {
        // nearer than what the means are of, there may be another part now
        const double tolerance = renewed_after * std::sqrt(area);
        offset                 = patches.offset(patch, points, column);
        is_current             = offset.slid.norm() < tolerance &&
          offset.distance < encounter.distance + tolerance;
      }
    if (!is_current)
      {
        offset.slid = Tensor<1, 3>();
        patches.update(patch, points, column, encounter, finder.neighbours(i));
      }

    Tensor<1, 3> way;
    for (const auto &part : patch.own)
      way -= part.weight * points[part.column];
    for (const auto &part : patch.partner)
      way += part.weight * points[part.column];
    Pair pair;
    pair.patch  = &patch;
    pair.area   = patch.fraction * area;
    pair.arm    = 0.5 * way;
    pair.normal = way + offset.slid;
    if (pair.area > 0 && pair.normal.norm_square() > 0)
      pair.normal /= pair.normal.norm();
    else
      pair.normal = encounter.normal;
    pair.distance = way * pair.normal;
    return pair;
  }



  // The reduced mass is that of what is pushed, or that of the sheets under the
  // area if this is less: a coarse sheet under a fine one is pushed by several
  // columns at once. The same goes for how a couple turns them.
  void
  MidSurfaceContact::find_masses(Pair &pair)
  {
    double mass = 0, inertia = 0;
    for (const auto *side : {&pair.patch->own, &pair.patch->partner})
      {
        double mass_at_once = 0, mass_by_area = 0, inertia_at_once = 0,
               inertia_by_area = 0;
        for (const auto &part : *side)
          {
            const double w = part.weight;
            const double share =
              w * columns.current_area[part.column] / pair.area;
            const double m = surface.inverse_mass(part.column);
            const double j = rotation.inverse_inertia(part.column);
            mass_at_once += w * w * m;
            mass_by_area += share * m;
            inertia_at_once += w * w * j;
            inertia_by_area += share * j;
          }
        mass += std::max(mass_at_once, mass_by_area);
        inertia += std::max(inertia_at_once, inertia_by_area);
      }
    pair.inverse_mass       = mass;
    pair.inverse_mass_along = mass + pair.arm.norm_square() * inertia;
  }



  void
  MidSurfaceContact::find_velocities(Pair &pair)
  {
    Tensor<1, 3> velocity; // of the partner as seen from the column
    pair.spin           = Tensor<1, 3>();
    const auto add_side = [&](const std::vector<TributaryPatch::Part> &side,
                              const double sign) {
      for (const auto &part : side)
        {
          velocity += sign * part.weight * rotation.velocity(part.column);
          pair.spin += 0.5 * part.weight * rotation.spin(part.column);
        }
    };
    add_side(pair.patch->own, -1.);
    add_side(pair.patch->partner, 1.);
    const Tensor<1, 3> facing =
      velocity - 2 * cross_product_3d(pair.spin, pair.arm);
    pair.opening = facing * pair.normal;
    pair.sliding = facing - pair.opening * pair.normal;
  }



  bool
  MidSurfaceContact::add_impulse(Pair &pair,
                                 const double stiffness,
                                 const double dt,
                                 ElasticSlip<3> &history)
  {
    const bool touches =
      pair.area > 0 && pair.distance < thickness + parameters.clearance;
    if (touches)
      find_masses(pair);
    if (!touches || !(pair.inverse_mass > 0))
      {
        history        = ElasticSlip<3>();
        history.normal = pair.normal;
        return false;
      }
    find_velocities(pair);

    const auto response = contact_pressure(pair.distance - thickness,
                                           pair.opening,
                                           1 / (pair.inverse_mass * pair.area),
                                           parameters,
                                           law,
                                           stiffness,
                                           0.5 * thickness,
                                           dt);
    history.spin(dt * pair.spin);
    const Tensor<1, 3> shear =
      contact_shear<3>(response,
                       pair.normal,
                       pair.sliding,
                       1 / (pair.inverse_mass_along * pair.area),
                       parameters,
                       dt,
                       history);
    if (response.pressure == 0)
      return false;

    // Each of the two passes has half of the weight.
    distribute(pair,
               0.5 * pair.area * response.pressure * dt,
               -0.5 * pair.area * dt * shear);
    return true;
  }



  // Both sides meet in the middle between the means.
  void
  MidSurfaceContact::distribute(const Pair &pair,
                                const double impulse,
                                const Tensor<1, 3> &along)
  {
    const Tensor<1, 3> normal        = impulse * pair.normal;
    const Tensor<1, 3> normal_moment = cross_product_3d(pair.arm, normal);
    const Tensor<1, 3> moment        = cross_product_3d(pair.arm, along);
    const auto add_side = [&](const std::vector<TributaryPatch::Part> &side,
                              const double sign) {
      for (const auto &part : side)
        {
          double *sum         = &sums[n_slots * part.column];
          const double weight = sign * part.weight;
          add(sum + normal_impulse, weight, normal);
          add(sum + tangential_impulse, weight, along);
          add(sum + normal_couple, -part.weight, normal_moment);
          add(sum + tangential_couple, -part.weight, moment);
          sum[pressure] += part.weight * impulse;
        }
    };
    add_side(pair.patch->own, -1.);
    add_side(pair.patch->partner, 1.);
  }



  void
  MidSurfaceContact::treat_column(const unsigned int i,
                                  const double stiffness,
                                  const double dt)
  {
    const unsigned int c = own_columns[i];
    double *sum          = &sums[n_slots * c];
    // A gap within reach is known until it is found to be wider.
    const bool measure =
      finder.measures_all() || columns.gap[c] < reach - thickness;
    Encounter encounters[2];
    unsigned int n = finder.find(i, measure, encounters);
    if (n == 0 && !measure)
      {
        sum[gap]     = columns.gap[c];
        sum[partner] = columns.partner[c];
        add(sum + direction, 1., columns.normals[c]);
        memories[i] = {};
        return;
      }
    sum[gap]     = n > 0 ? encounters[0].distance - thickness : no_gap;
    sum[partner] = n > 0 ? encounters[0].triangle : no_partner;
    if (n > 0)
      add(sum + direction, 1., encounters[0].normal);
    if (n > 0 && encounters[0].distance >= reach)
      n = 0; // the second one is farther
    sort_memories(i, encounters, n);
    for (unsigned int e = 0; e < n; ++e)
      {
        Memory &memory = memories[i][e];
        Pair pair      = pair_up(i, encounters[e], memory.patch);
        sums.back() += add_impulse(pair, stiffness, dt, memory.history);
      }
  }



  // The nearest partner and the opposite one may change places.
  void
  MidSurfaceContact::sort_memories(const unsigned int i,
                                   const Encounter *encounters,
                                   const unsigned int n)
  {
    auto &memory         = memories[i];
    const auto continues = [&](const unsigned int m, const unsigned int e) {
      return memory[m].history.normal * encounters[e].normal > 0;
    };
    if (n > 0 && !continues(0, 0) &&
        (continues(1, 0) || (n == 2 && continues(0, 1))))
      std::swap(memory[0], memory[1]);
    for (unsigned int e = 0; e < 2; ++e)
      if (e >= n || !continues(e, e))
        memory[e] = Memory();
  }



  std::vector<Tensor<1, 3>>
  MidSurfaceContact::spins(const std::vector<Point<3>> &points,
                           const double *V) const
  {
    MidSurfaceSpin rotation(surface);
    rotation.set_state(points, V);
    std::vector<Tensor<1, 3>> result;
    for (unsigned int c = 0; c < surface.n_columns(); ++c)
      result.push_back(rotation.spin(c));
    return result;
  }



  MidSurfaceContact::Result
  MidSurfaceContact::apply_impulse(const double *X, double *V, const double dt)
  {
    surface.positions(X, points);
    rotation.set_state(points, V);
    finder.begin_step(points);
    surface.areas(points, columns.current_area);

    sums.assign(n_slots * surface.n_columns() + 1, 0.);
    const double k = stiffness(dt);
    for (unsigned int i = 0; i < own_columns.size(); ++i)
      treat_column(i, k, dt);
    MPI_Allreduce(MPI_IN_PLACE,
                  sums.data(),
                  sums.size(),
                  MPI_DOUBLE,
                  MPI_SUM,
                  communicator);
    time += dt;
    spread_couples();
    return apply_sums(V, dt);
  }



  void
  MidSurfaceContact::spread_couples()
  {
    for (const auto &slots :
         {std::make_pair(normal_couple, normal_impulse),
          std::make_pair(tangential_couple, tangential_impulse)})
      {
        for (unsigned int c = 0; c < surface.n_columns(); ++c)
          {
            const Tensor<1, 3> couple =
              vector_at(&sums[n_slots * c + slots.first]);
            if (couple.norm_square() > 0)
              rotation.add_couple(c, couple);
          }
        for (const auto &part : rotation.fetch_impulses())
          add(&sums[n_slots * part.column + slots.second], 1., part.impulse);
      }
  }



  MidSurfaceContact::Result
  MidSurfaceContact::apply_sums(double *V, const double dt)
  {
    Result result;
    for (unsigned int c = 0; c < surface.n_columns(); ++c)
      {
        const double *sum  = &sums[n_slots * c];
        columns.gap[c]     = sum[gap];
        columns.normals[c] = vector_at(sum + direction);
        columns.partner[c] = static_cast<unsigned int>(sum[partner]);
        result.min_gap     = std::min(result.min_gap, sum[gap]);
        if (sum[pressure] > 0)
          {
            columns.pressure_impulse[c] +=
              sum[pressure] / columns.current_area[c];
            result.normal_force += 0.5 * sum[pressure] / dt;
          }
        const Tensor<1, 3> normal     = vector_at(sum + normal_impulse);
        const Tensor<1, 3> tangential = vector_at(sum + tangential_impulse);
        if (normal.norm_square() + tangential.norm_square() == 0)
          continue;
        const auto work = surface.apply_impulse(c, normal, tangential, V);
        result.normal_power += work[0] / dt;
        result.friction_power += work[1] / dt;
      }
    result.pairs = static_cast<unsigned int>(sums.back());
    return result;
  }
} // namespace coapt
