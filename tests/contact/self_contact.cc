// A body that touches itself: the legs of a U. The sides of the corners of an L
// never do.

#include "blocks.h"
#include "tests.h"

using dealii::Point;
using dealii::Tensor;

namespace
{
  // The width of the legs is the depth of the floor. The lowest row of the slot
  // is what bends when the legs move.
  constexpr double leg = 0.2, slot = 0.2, height = 1, row = 0.1;

  /** What remains of a block of @p boxes between the corners 0 and @p size
   * without the cells about whose centres @p removed is true. */
  template <int dim>
  coapt::SimplexMesh<dim>
  carve(const std::array<unsigned int, dim> &boxes,
        const Point<dim> &size,
        const std::function<bool(const Point<dim> &)> &removed)
  {
    Blocks<dim> block;
    block.add(boxes, [&](Point<dim> p) {
      for (unsigned int d = 0; d < dim; ++d)
        p[d] *= size[d];
      return p;
    });
    coapt::SimplexMesh<dim> mesh;
    std::vector<unsigned int> number(block.mesh.points.size(), -1);
    for (auto cell : block.mesh.cells)
      {
        Point<dim> centre;
        for (const unsigned int node : cell)
          centre += block.mesh.points[node] / (dim + 1.);
        if (removed(centre))
          continue;
        for (unsigned int &node : cell)
          {
            if (number[node] == static_cast<unsigned int>(-1))
              {
                number[node] = mesh.points.size();
                mesh.points.push_back(block.mesh.points[node]);
              }
            node = number[node];
          }
        mesh.cells.push_back(cell);
      }
    return mesh;
  }

  template <int dim>
  coapt::SimplexMesh<dim>
  u_shape()
  {
    std::array<unsigned int, dim> boxes;
    Point<dim> size;
    boxes.fill(4);
    boxes[0] = 6;
    boxes[1] = 10;
    for (unsigned int d = 0; d < dim; ++d)
      size[d] = 0.4;
    size[0]   = 2 * leg + slot;
    size[1]   = height;
    auto mesh = carve<dim>(boxes, size, [](const Point<dim> &p) {
      return p[0] > leg && p[0] < leg + slot && p[1] > leg;
    });
    // so that the facets of one leg are not those of the other
    for (auto &p : mesh.points)
      if (p[0] > leg + 1e-9 && p[1] > leg + row)
        p[1] +=
          0.04 * std::sin(M_PI * (p[1] - leg - row) / (height - leg - row));
    return mesh;
  }

  template <int dim>
  coapt::SimplexMesh<dim>
  l_shape()
  {
    std::array<unsigned int, dim> boxes;
    boxes.fill(4);
    boxes[0] = boxes[1] = 20;
    Point<dim> size;
    size[dim - 1] = 0.4;
    size[0] = size[1] = height;
    return carve<dim>(boxes, size, [](const Point<dim> &p) {
      return p[0] > leg && p[1] > leg;
    });
  }

  constexpr double stiffness = 1e6, time_step = 1e-4;

  /** A body and its contact; the stiffness is the given one. */
  template <int dim>
  struct Body
  {
    Body(const coapt::SimplexMesh<dim> &mesh, const double clearance)
      : mesh(mesh)
    {
      coapt::ContactParameters parameters;
      parameters.clearance     = clearance;
      parameters.friction      = 0;
      parameters.max_stiffness = stiffness;
      parameters.search_margin = 0.03;
      const unsigned int n     = mesh.points.size();
      contact                  = std::make_unique<coapt::FacetContact<dim>>(
        mesh,
        coapt::outer_facets(mesh),
        std::vector<double>(n, 1.), // kg
        std::vector<bool>(n, false),
        parameters,
        0.5 * leg,
        MPI_COMM_WORLD);
    }

    /** What contact does to the body at rest in the shape given by the new
     * positions of the nodes. */
    typename coapt::FacetContact<dim>::Result
    put(const std::function<Point<dim>(const Point<dim> &)> &shape)
    {
      X.clear();
      for (const auto &p : mesh.points)
        {
          const Point<dim> q = shape(p);
          for (unsigned int d = 0; d < dim; ++d)
            X.push_back(q[d]);
        }
      V.assign(X.size(), 0.);
      return contact->apply_impulse(X.data(), V.data(), time_step);
    }

    /** Momentum and its moment about the origin, over the sum of the
     * magnitudes. */
    double
    imbalance() const
    {
      Tensor<1, 3> momentum, moment;
      double sum = 0;
      for (unsigned int n = 0; n < mesh.points.size(); ++n)
        {
          Tensor<1, 3> x, v;
          for (unsigned int d = 0; d < dim; ++d)
            {
              x[d] = X[dim * n + d];
              v[d] = V[dim * n + d];
            }
          momentum += v;
          moment += cross_product_3d(x, v);
          sum += v.norm();
        }
      return (momentum.norm() + moment.norm()) / sum;
    }

    const coapt::SimplexMesh<dim> mesh;
    std::unique_ptr<coapt::FacetContact<dim>> contact;
    std::vector<double> X, V;
  };

  /** Moves the legs of the U towards each other, by this much together. */
  template <int dim>
  std::function<Point<dim>(const Point<dim> &)>
  closed_by(const double distance)
  {
    return [=](Point<dim> p) {
      if (p[1] > leg + 1e-9)
        p[0] += (p[0] < leg + 0.5 * slot ? 0.5 : -0.5) * distance;
      return p;
    };
  }

  template <int dim>
  void
  legs(const std::string &name)
  {
    const auto mesh      = u_shape<dim>();
    const double overlap = 1e-3, clearance = 0.02;
    const double area = (height - leg - row) * (dim == 3 ? 0.4 : 1);
    Body<dim> body(mesh, 0), with_clearance(mesh, clearance);
    unsigned int pairs = 0;
    for (const double distance : {-0.4, -0.1, 0., 0.5 * slot, 0.99 * slot})
      pairs += body.put(closed_by<dim>(distance)).pairs;
    for (const double distance : {-0.1, 0., slot - 1.1 * clearance})
      pairs += with_clearance.put(closed_by<dim>(distance)).pairs;
    check(name + ", open: no pairs", pairs == 0, pairs);

    const auto closed  = body.put(closed_by<dim>(slot + overlap));
    const double force = closed.normal_force;
    check_relative(name + ", closed: force",
                   force,
                   stiffness * overlap * area,
                   2e-3);
    check(name + ": momentum and moment",
          body.imbalance() < 1e-12,
          body.imbalance());
    check_relative(name + ": force within the clearance",
                   with_clearance
                     .put(closed_by<dim>(slot - clearance + overlap))
                     .normal_force,
                   stiffness * overlap * area,
                   2e-3);

    // Candidates that are renewed on the way
    Body<dim> slowly(mesh, 0);
    typename coapt::FacetContact<dim>::Result last;
    for (unsigned int step = 0; step <= 50; ++step)
      last = slowly.put(closed_by<dim>((slot + overlap) * step / 50.));
    check_relative(name + ", closed step by step",
                   last.normal_force,
                   force,
                   1e-9);

    // The nodes are where the mesh already has them.
    auto pressed = mesh;
    for (auto &p : pressed.points)
      p = closed_by<dim>(slot + overlap)(p);
    Body<dim> from_the_start(pressed, 0);
    check_relative(
      name + ", closed from the start",
      from_the_start.put([](const Point<dim> &p) { return p; }).normal_force,
      force,
      1e-9);
  }

  // Only corners deform: nothing may touch. One leg of an L leans by shear, so
  // that its end has an acute edge, too.
  template <int dim>
  void
  corners(const std::string &name)
  {
    const auto mesh = l_shape<dim>();
    for (const double clearance : {0., 0.02, 0.06})
      {
        Body<dim> body(mesh, clearance);
        unsigned int pairs = 0;
        for (const double degrees : {45., 60., 75., 85., 90., 105., 120., 135.})
          {
            const double angle = degrees * M_PI / 180;
            const auto result  = body.put([=](Point<dim> p) {
              if (p[1] > leg)
                {
                  p[0] += (p[1] - leg) * std::cos(angle);
                  p[1] = leg + (p[1] - leg) * std::sin(angle);
                }
              return p;
            });
            pairs += result.pairs;
          }
        check(name + ": no pairs from 45 to 135 degrees, clearance " +
                std::to_string(clearance).substr(0, 4),
              pairs == 0,
              pairs);
      }
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  legs<2>("U of triangles");
  legs<3>("U of tetrahedra");
  corners<2>("L of triangles");
  corners<3>("L of tetrahedra");
}
