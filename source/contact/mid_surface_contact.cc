#include <coapt/contact/mid_surface_contact.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <limits>
#include <numeric>

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
      couple             = 12, // vector, of tangential impulses
      n_slots            = 15
    };

    /** Two directions are opposite if their cosine is below this. */
    constexpr double opposite = -0.2;

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
    , search(reference_positions(surface, leaflet),
             surface.triangles(),
             parameters.exclusion_distance + parameters.clearance,
             own_columns)
    , rule(surface.triangles(), surface.n_columns())
    , points(reference_positions(surface, leaflet))
  {
    const unsigned int n = surface.n_columns();
    surface.areas(points, columns.reference_area);
    columns.current_area = columns.reference_area;
    columns.gap.assign(n, no_gap);
    columns.pressure_impulse.assign(n, 0.);
    columns.normals.resize(n);
    columns.partner.assign(n, no_partner);
    least_distance.resize(own_columns.size());
    histories.resize(own_columns.size());

    const double spacing =
      std::sqrt(std::accumulate(columns.reference_area.begin(),
                                columns.reference_area.end(),
                                0.) /
                std::max(n, 1u));
    areal_mass = density * std::min(thickness, spacing);
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



  // Two columns approach by twice their displacement at most. Candidates are
  // complete for all gaps to be reported while this is below half the margin;
  // renewal before that only makes them fewer to look at.
  void
  MidSurfaceContact::renew_candidates()
  {
    displacement          = search.displacement(points);
    const double approach = 2 * displacement / parameters.search_margin;
    measure_all           = ++steps_since_check >= parameters.search_interval;
    if (approach > 0.5 || (measure_all && approach > 0.1))
      {
        search.find(points,
                    thickness + parameters.clearance +
                      parameters.search_margin);
        displacement = 0;
        measure_all  = true;
      }
    if (measure_all)
      steps_since_check = 0;
  }



  // The nearest triangle that faces the column, and the nearest one in the
  // opposite direction if it is in contact, both within the distance given.
  // Returns how many there are.
  // Measured distances sharpen the bounds of the candidates, and the nearest
  // one moves to the front, so that in the next step few others have to be
  // measured.
  unsigned int
  MidSurfaceContact::find_encounters(const unsigned int i,
                                     const double within,
                                     Encounter (&encounters)[2])
  {
    const double onset        = thickness + parameters.clearance;
    const unsigned int column = own_columns[i];
    auto &list                = search.candidates(i);
    const double approach     = 2 * displacement;

    touching.clear(); // any of these may turn out to be the opposite one
    unsigned int n = 0;
    double nearest = within;
    double least   = std::numeric_limits<double>::max();
    for (auto &candidate : list)
      {
        const bool measure =
          candidate.least_distance - approach <= std::max(nearest, onset);
        Encounter other;
        if (measure)
          {
            other = rule.encounter(points, column, candidate.triangle);
            candidate.least_distance =
              std::max(candidate.least_distance, other.distance - approach);
          }
        least = std::min(least, candidate.least_distance);
        if (measure && other.distance < onset)
          touching.push_back(other);
        if (measure && other.distance <= nearest &&
            rule.faces(points, column, other))
          {
            nearest       = other.distance;
            encounters[0] = other;
            n             = 1;
            std::swap(candidate, list.front());
          }
      }
    least_distance[i] = least;
    nearest           = onset;
    for (const Encounter &other : touching)
      if (other.distance < nearest &&
          other.normal * encounters[0].normal < opposite &&
          rule.faces(points, column, other))
        {
          nearest       = other.distance;
          encounters[1] = other;
          n             = 2;
        }
    return n;
  }



  // The reduced mass is that of the two points, or that of the sheets under the
  // column's area if this is less: a coarse sheet under a fine one is pushed by
  // several columns at once. The same goes for how a couple turns them.
  void
  MidSurfaceContact::find_masses(Pair &pair)
  {
    const auto &area = columns.current_area;
    double mass = 0, mass_by_area = 0, inertia = 0, inertia_by_area = 0;
    for (unsigned int v = 0; v < 3; ++v)
      {
        const unsigned int c = pair.corner[v];
        const double w       = pair.encounter.weights[v];
        const double share   = w * area[c] / area[pair.column];
        mass += w * w * surface.inverse_mass(c);
        mass_by_area += share * surface.inverse_mass(c);
        inertia += w * w * rotation.inverse_inertia(c);
        inertia_by_area += share * rotation.inverse_inertia(c);
      }
    pair.inverse_mass =
      surface.inverse_mass(pair.column) + std::max(mass, mass_by_area);
    pair.inverse_mass_along = pair.inverse_mass +
      pair.arm.norm_square() *
        (rotation.inverse_inertia(pair.column) +
         std::max(inertia, inertia_by_area));
  }



  void
  MidSurfaceContact::find_velocities(Pair &pair)
  {
    Tensor<1, 3> spin;
    pair.velocity = -rotation.velocity(pair.column);
    for (unsigned int v = 0; v < 3; ++v)
      {
        const double w = pair.encounter.weights[v];
        pair.velocity += w * rotation.velocity(pair.corner[v]);
        spin += w * rotation.spin(pair.corner[v]);
      }
    pair.spin    = 0.5 * (spin + rotation.spin(pair.column));
    pair.opening = pair.velocity * pair.encounter.normal;
    pair.sliding = pair.velocity - pair.opening * pair.encounter.normal -
      2 * cross_product_3d(pair.spin, pair.arm);
  }



  bool
  MidSurfaceContact::add_impulse(const unsigned int column,
                                 const Encounter &encounter,
                                 const double stiffness,
                                 const double dt,
                                 ElasticSlip<3> &history)
  {
    Pair pair;
    pair.column       = column;
    pair.encounter    = encounter;
    pair.corner       = surface.triangles()[encounter.triangle];
    pair.arm          = 0.5 * encounter.distance * encounter.normal;
    const double area = columns.current_area[column];
    if (!(area > 0))
      return false;
    find_masses(pair);
    if (!(pair.inverse_mass > 0))
      return false;
    find_velocities(pair);

    const auto response = contact_pressure(encounter.distance - thickness,
                                           pair.opening,
                                           1 / (pair.inverse_mass * area),
                                           parameters,
                                           law,
                                           stiffness,
                                           0.5 * thickness,
                                           dt);
    history.spin(dt * pair.spin);
    const Tensor<1, 3> shear =
      contact_shear<3>(response,
                       encounter.normal,
                       pair.sliding,
                       1 / (pair.inverse_mass_along * area),
                       parameters,
                       dt,
                       history);
    if (response.pressure == 0)
      return false;

    // Each of the two passes has half of the weight.
    distribute(pair,
               0.5 * area * response.pressure * dt,
               -0.5 * area * dt * shear);
    return true;
  }



  // Normal impulses act on the line through column and partner, and need no
  // couple to balance. Those along the surface act in the middle of the gap.
  void
  MidSurfaceContact::distribute(const Pair &pair,
                                const double impulse,
                                const Tensor<1, 3> &along)
  {
    const Tensor<1, 3> moment = cross_product_3d(pair.arm, along);
    const auto add_to         = [&](const unsigned int c, const double weight) {
      double *sum = &sums[n_slots * c];
      add(sum + normal_impulse, weight * impulse, pair.encounter.normal);
      add(sum + tangential_impulse, weight, along);
      sum[pressure] += std::abs(weight) * impulse;
    };
    add_to(pair.column, -1.);
    add(&sums[n_slots * pair.column + couple], -1., moment);
    for (unsigned int v = 0; v < 3; ++v)
      {
        const double weight = pair.encounter.weights[v];
        add_to(pair.corner[v], weight);
        add(&sums[n_slots * pair.corner[v] + couple], -weight, moment);
      }
  }



  void
  MidSurfaceContact::treat_column(const unsigned int i,
                                  const double stiffness,
                                  const double dt)
  {
    const unsigned int c = own_columns[i];
    double *sum          = &sums[n_slots * c];
    const double onset   = thickness + parameters.clearance;
    // A gap that was in contact is known until it is found to be wider.
    const bool measure = measure_all || columns.gap[c] < parameters.clearance;
    Encounter encounters[2];
    unsigned int n = 0;
    if (measure || least_distance[i] - 2 * displacement <= onset)
      n = find_encounters(i,
                          measure ? onset + 0.5 * parameters.search_margin
                                  : onset,
                          encounters);
    if (n == 0 && !measure)
      {
        sum[gap]     = columns.gap[c];
        sum[partner] = columns.partner[c];
        add(sum + direction, 1., columns.normals[c]);
        histories[i] = {};
        return;
      }
    sum[gap]     = n > 0 ? encounters[0].distance - thickness : no_gap;
    sum[partner] = n > 0 ? encounters[0].triangle : no_partner;
    if (n > 0)
      add(sum + direction, 1., encounters[0].normal);
    std::array<ElasticSlip<3>, 2> now;
    for (unsigned int e = 0; e < n; ++e)
      if (encounters[e].distance < onset)
        {
          now[e] = history_of(i, encounters[e].normal);
          sums.back() += add_impulse(c, encounters[e], stiffness, dt, now[e]);
        }
    histories[i] = now;
  }



  // The nearest partner and the opposite one may change places.
  ElasticSlip<3>
  MidSurfaceContact::history_of(const unsigned int i,
                                const Tensor<1, 3> &normal) const
  {
    for (const ElasticSlip<3> &history : histories[i])
      if (history.normal * normal > 0)
        return history;
    return ElasticSlip<3>();
  }



  MidSurfaceContact::Result
  MidSurfaceContact::apply_impulse(const double *X, double *V, const double dt)
  {
    surface.positions(X, points);
    rotation.set_state(points, V);
    renew_candidates();
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
    for (unsigned int c = 0; c < surface.n_columns(); ++c)
      {
        const Tensor<1, 3> sum = vector_at(&sums[n_slots * c + couple]);
        if (sum.norm_square() > 0)
          rotation.add_couple(c, sum);
      }
    for (const auto &part : rotation.fetch_impulses())
      add(&sums[n_slots * part.column + tangential_impulse], 1., part.impulse);
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
