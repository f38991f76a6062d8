#include <deal.II/base/exceptions.h>

#include <coapt/immersion/fluid_within.h>

#include <cmath>

namespace coapt
{
  using dealii::Tensor;

  template <int dim>
  FluidWithin<dim>::FluidWithin(const SimplexMesh<dim> &mesh,
                                const CouplingPoints<dim> &points)
    : mesh(mesh), points(points), volumes(mesh.cells.size(), 0.)
  {
    // Points that stand for groups would count twice.
    AssertThrow(points.n_points() == points.samples().size(),
                dealii::ExcInternalError());
    for (const SamplePoint<dim> &sample : points.samples())
      volumes[sample.cell] += sample.volume;
  }



  template <int dim>
  std::array<Tensor<1, dim>, dim + 1>
  FluidWithin<dim>::volume_slopes(const unsigned int number,
                                  const double *X) const
  {
    const auto &corners = mesh.cells[number];
    Tensor<2, dim> edges;
    for (unsigned int a = 0; a < dim; ++a)
      for (unsigned int d = 0; d < dim; ++d)
        edges[a][d] = X[dim * corners[a + 1] + d] - X[dim * corners[0] + d];
    const Tensor<2, dim> gradients = invert(edges); // a column for each edge
    const double volume            = determinant(edges) / (dim == 2 ? 2 : 6);
    std::array<Tensor<1, dim>, dim + 1> slopes;
    for (unsigned int a = 0; a < dim; ++a)
      for (unsigned int d = 0; d < dim; ++d)
        {
          slopes[a + 1][d] = volume * gradients[d][a];
          slopes[0][d] -= volume * gradients[d][a];
        }
    return slopes;
  }



  template <int dim>
  bool
  FluidWithin<dim>::update(const FluidOperator<dim> &fluid, const double *X)
  {
    std::vector<int> cells(points.n_points(), -1);
    for (unsigned int q = 0; q < points.n_owned(); ++q)
      cells[points.id(q)] = points.coupled_cell(q);
    elements.clear();
    parts.clear();
    bool owns_all = true;
    for (unsigned int id = 0; id < cells.size(); ++id)
      if (cells[id] >= static_cast<int>(fluid.n_owned_cells()))
        owns_all = false;
      else if (cells[id] >= 0)
        append(id, cells[id], fluid, X);
    return owns_all;
  }



  template <int dim>
  void
  FluidWithin<dim>::append(const unsigned int id,
                           const unsigned int cell,
                           const FluidOperator<dim> &fluid,
                           const double *X)
  {
    // samples have the order of the elements
    const SamplePoint<dim> &sample = points.samples()[id];
    const unsigned int number      = sample.cell;
    const unsigned int end         = parts.size();
    if (elements.empty() || elements.back().number != number)
      elements.push_back({number, volume_slopes(number, X), end, end});
    Element &element = elements.back();
    if (element.begin == element.end || parts.back().cell != cell)
      {
        const auto &fluid_parameters = fluid.parameters();
        const double c               = fluid_parameters.sound_speed;
        parts.push_back({cell,
                         0,
                         fluid_parameters.density * c * c /
                           std::pow(fluid.cell(cell).size, dim)});
      }
    parts.back().fraction += sample.volume / volumes[number];
    element.end = parts.size();
  }



  template <int dim>
  void
  FluidWithin<dim>::add(const double *pressure,
                        const double *V,
                        double *F,
                        double *pressure_rate) const
  {
    for (const Element &element : elements)
      {
        const auto &nodes  = mesh.cells[element.number];
        double volume_rate = 0, mean_pressure = 0;
        for (unsigned int a = 0; a <= dim; ++a)
          for (unsigned int d = 0; d < dim; ++d)
            volume_rate += element.slopes[a][d] * V[dim * nodes[a] + d];
        for (unsigned int i = element.begin; i < element.end; ++i)
          {
            const Part &part = parts[i];
            mean_pressure += part.fraction * pressure[part.cell];
            pressure_rate[part.cell] +=
              part.fraction * part.modulus_per_volume * volume_rate;
          }
        for (unsigned int a = 0; a <= dim; ++a)
          for (unsigned int d = 0; d < dim; ++d)
            F[dim * nodes[a] + d] -= mean_pressure * element.slopes[a][d];
      }
  }

  template class FluidWithin<2>;
  template class FluidWithin<3>;
} // namespace coapt
