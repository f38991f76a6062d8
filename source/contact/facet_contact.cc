#include <coapt/base/exceptions.h>
#include <coapt/contact/facet_contact.h>
#include <coapt/geometry/boundary_faces.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace coapt
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    /** Facets whose normals have a greater cosine do not face each other. */
    constexpr double facing = -0.1;

    /** Neighbours are at most this times the depth apart through the solid.
     * Half a thickness is the depth; some more, since thin parts get thinner.
     */
    constexpr double thicknesses = 2.5;

    /** And this times the clearance c along the surface: the sides of a corner
     * of the angle a are c apart at c/tan(a/2) along both, so that they stay
     * neighbours down to 45 degrees. */
    constexpr double clearances = 2.5;

    std::vector<unsigned int>
    facets_of_rank(const unsigned int n_facets, MPI_Comm communicator)
    {
      // Cyclic, since only part of the surface is in contact.
      std::vector<unsigned int> own;
      for (unsigned int f =
             dealii::Utilities::MPI::this_mpi_process(communicator);
           f < n_facets;
           f += dealii::Utilities::MPI::n_mpi_processes(communicator))
        own.push_back(f);
      return own;
    }
  } // namespace



  template <int dim>
  std::vector<std::array<unsigned int, dim>>
  outer_facets(const SimplexMesh<dim> &mesh)
  {
    std::vector<std::array<unsigned int, dim>> facets;
    for (const BoundaryFace<dim> &face : boundary_faces<dim>(mesh.cells))
      {
        auto facet = face.nodes;
        std::array<Point<dim>, dim> corners;
        for (unsigned int i = 0; i < dim; ++i)
          corners[i] = mesh.points[facet[i]];
        Tensor<1, dim> inwards; // to the cell's centroid, times dim + 1
        for (const unsigned int node : mesh.cells[face.cell])
          inwards += mesh.points[node] - corners[0];
        if (area_normal<dim>(corners) * inwards > 0)
          std::swap(facet[0], facet[1]);
        facets.push_back(facet);
      }
    return facets;
  }



  template <int dim>
  FacetContact<dim>::FacetContact(
    const SimplexMesh<dim> &mesh,
    const std::vector<std::array<unsigned int, dim>> &facets,
    const std::vector<double> &nodal_mass,
    const std::vector<bool> &held,
    const ContactParameters &parameters,
    const double depth,
    MPI_Comm communicator)
    : parameters(parameters)
    , depth(depth)
    , communicator(communicator)
    , law(parameters)
    , facets(facets)
    , inverse_mass(mesh.points.size())
    , own(facets_of_rank(facets.size(), communicator))
    , search(facets, own)
    , neighbours(mesh,
                 facets,
                 thicknesses * depth,
                 clearances * parameters.clearance)
    , points(mesh.points)
    , sums(mesh.points.size())
    , histories(mesh.points.size())
    , shear(mesh.points.size())
    , nodal_pressure(mesh.points.size())
  {
    if (nodal_mass.size() != points.size() || held.size() != points.size())
      throw InputError("Contact: there must be one mass for each node");
    std::vector<double> area(points.size());
    for (unsigned int f = 0; f < facets.size(); ++f)
      for (const unsigned int node : facets[f])
        area[node] += area_normal<dim>(corners(f)).norm() / dim;
    for (unsigned int n = 0; n < points.size(); ++n)
      inverse_mass[n] = held[n] ? 0. : 1 / nodal_mass[n];
    areal_mass = std::numeric_limits<double>::infinity();
    for (unsigned int n = 0; n < points.size(); ++n)
      if (!held[n] && area[n] > 0)
        areal_mass = std::min(areal_mass, 0.5 * nodal_mass[n] / area[n]);
  }



  template <int dim>
  const std::vector<double> &
  FacetContact<dim>::pressure() const
  {
    return nodal_pressure;
  }



  template <int dim>
  std::array<Point<dim>, dim>
  FacetContact<dim>::corners(const unsigned int facet) const
  {
    std::array<Point<dim>, dim> result;
    for (unsigned int i = 0; i < dim; ++i)
      result[i] = points[facets[facet][i]];
    return result;
  }



  template <int dim>
  typename FacetContact<dim>::Vector
  FacetContact<dim>::velocity(const unsigned int facet,
                              const std::array<double, dim> &weights,
                              const double *V) const
  {
    Vector result;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int d = 0; d < dim; ++d)
        result[d] += weights[i] * V[dim * facets[facet][i] + d];
    return result;
  }



  template <int dim>
  typename FacetContact<dim>::Result
  FacetContact<dim>::apply_impulse(const double *X, double *V, const double dt)
  {
    for (unsigned int n = 0; n < points.size(); ++n)
      for (unsigned int d = 0; d < dim; ++d)
        points[n][d] = X[dim * n + d];
    // Two nodes approach by twice their displacement at most.
    if (!(2 * search.displacement(points) < parameters.search_margin))
      search.find(points,
                  std::max(parameters.clearance, depth) +
                    parameters.search_margin);
    find_touches(V, dt);
    find_shear(dt);
    return apply(V, dt);
  }



  template <int dim>
  void
  FacetContact<dim>::find_touches(const double *V, const double dt)
  {
    touches.clear();
    n_pairs = 0;
    sums.assign(points.size(), NodeSums());
    for (unsigned int i = 0; i < own.size(); ++i)
      {
        unsigned int n_partners = 0;
        for (const unsigned int partner : search.candidates(i))
          n_partners += touch(own[i], partner, V, dt);
        n_pairs += n_partners;
        if (n_partners > 0)
          for (const unsigned int node : facets[own[i]])
            sums[node].share += area_normal<dim>(corners(own[i])).norm() / dim;
      }
  }



  template <int dim>
  typename FacetContact<dim>::Vector
  FacetContact<dim>::find_overlap(const unsigned int facet,
                                  const unsigned int partner)
  {
    const auto here     = corners(facet);
    const auto there    = corners(partner);
    const Vector normal = area_normal<dim>(here);
    const Vector behind = area_normal<dim>(there);
    overlap.clear();
    if (normal * behind < facing * normal.norm() * behind.norm())
      add_overlap<dim>(here, there, overlap);
    return normal / normal.norm();
  }



  template <int dim>
  bool
  FacetContact<dim>::touch(const unsigned int facet,
                           const unsigned int partner,
                           const double *V,
                           const double dt)
  {
    const Vector normal  = find_overlap(facet, partner);
    const auto is_beyond = [&](const OverlapPoint<dim> &point) {
      return point.gap >= parameters.clearance || point.gap < -depth;
    };
    overlap.erase(std::remove_if(overlap.begin(), overlap.end(), is_beyond),
                  overlap.end());
    if (overlap.empty() || neighbours(facet, partner))
      return false;
    for (const OverlapPoint<dim> &point : overlap)
      {
        const Vector sliding =
          velocity(partner, point.partner, V) - velocity(facet, point.own, V);
        const auto response = contact_pressure(point.gap,
                                               sliding * normal,
                                               areal_mass,
                                               parameters,
                                               law,
                                               parameters.max_stiffness,
                                               depth,
                                               dt);
        touches.push_back({facet, partner, point, normal, response.pressure});
        for (unsigned int i = 0; i < dim; ++i)
          {
            const double area = point.area * point.own[i];
            NodeSums &node    = sums[facets[facet][i]];
            node.area += area;
            node.pressure += area * response.pressure;
            node.slope += area * response.slope;
            node.normal += area * normal;
            node.sliding += area * sliding;
          }
      }
    return true;
  }



  // The tractions of the nodes, the same on all ranks.
  template <int dim>
  void
  FacetContact<dim>::find_shear(const double dt)
  {
    static_assert(sizeof(NodeSums) == NodeSums::n_numbers * sizeof(double));
    MPI_Allreduce(MPI_IN_PLACE,
                  sums.data(),
                  NodeSums::n_numbers * sums.size(),
                  MPI_DOUBLE,
                  MPI_SUM,
                  communicator);
    for (unsigned int n = 0; n < sums.size(); ++n)
      {
        const NodeSums &node = sums[n];
        shear[n]             = Vector();
        nodal_pressure[n]    = 0;
        if (!(node.area > 0) || !(node.normal.norm() > 0))
          {
            histories[n] = ElasticSlip<dim>();
            continue;
          }
        nodal_pressure[n]   = node.pressure / node.share;
        const Vector normal = node.normal / node.normal.norm();
        Vector sliding      = node.sliding / node.area;
        sliding -= (sliding * normal) * normal;
        shear[n] = contact_shear<dim>({node.pressure / node.area,
                                       node.slope / node.area},
                                      normal,
                                      sliding,
                                      areal_mass,
                                      parameters,
                                      dt,
                                      histories[n]);
      }
  }



  template <int dim>
  typename FacetContact<dim>::Result
  FacetContact<dim>::apply(double *V, const double dt)
  {
    // Normal and tangential impulse of each node, and two numbers of the rank.
    std::vector<double> impulses(2 * dim * points.size() + 2);
    for (const Touch &touch : touches)
      {
        // Each of the two passes has half of the weight.
        const double weight = 0.5 * touch.point.area * dt;
        Vector traction;
        for (unsigned int i = 0; i < dim; ++i)
          traction += touch.point.own[i] * shear[facets[touch.facet][i]];
        const auto add = [&](const unsigned int node, const double share) {
          for (unsigned int d = 0; d < dim; ++d)
            {
              impulses[2 * dim * node + d] +=
                share * weight * touch.pressure * touch.normal[d];
              impulses[2 * dim * node + dim + d] -=
                share * weight * traction[d];
            }
        };
        for (unsigned int i = 0; i < dim; ++i)
          {
            add(facets[touch.facet][i], -touch.point.own[i]);
            add(facets[touch.partner][i], touch.point.partner[i]);
          }
        impulses[impulses.size() - 2] += weight * touch.pressure;
      }
    impulses.back() = n_pairs;
    MPI_Allreduce(MPI_IN_PLACE,
                  impulses.data(),
                  impulses.size(),
                  MPI_DOUBLE,
                  MPI_SUM,
                  communicator);

    Result result;
    for (unsigned int n = 0; n < points.size(); ++n)
      for (unsigned int d = 0; d < dim; ++d)
        {
          const double normal     = impulses[2 * dim * n + d];
          const double tangential = impulses[2 * dim * n + dim + d];
          double &v               = V[dim * n + d];
          const double change     = (normal + tangential) * inverse_mass[n];
          if (change == 0)
            continue;
          // with the mean velocity the sum is the change of kinetic energy
          result.normal_power += normal * (v + 0.5 * change) / dt;
          result.friction_power += tangential * (v + 0.5 * change) / dt;
          v += change;
        }
    result.normal_force = impulses[impulses.size() - 2] / dt;
    result.pairs        = static_cast<unsigned int>(impulses.back());
    return result;
  }



  template std::vector<std::array<unsigned int, 2>>
  outer_facets<2>(const SimplexMesh<2> &);
  template std::vector<std::array<unsigned int, 3>>
  outer_facets<3>(const SimplexMesh<3> &);
  template class FacetContact<2>;
  template class FacetContact<3>;
} // namespace coapt
