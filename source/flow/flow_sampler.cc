#include <coapt/base/exceptions.h>
#include <coapt/flow/flow_model.h>
#include <coapt/flow/flow_sampler.h>
#include <coapt/fluid/cell_interpolation.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace coapt
{
  using dealii::Point;

  namespace
  {
    /** Mean pressure of the cells around each local node, in the first of dim
     * entries a node. */
    template <int dim>
    std::vector<double>
    nodal_pressure(const FlowModel<dim> &model, const double *y)
    {
      const FluidOperator<dim> &fluid = model.fluid();
      const double *pressure          = model.pressure(y);
      // pressure times volume, and volume, as if they were forces
      std::vector<double> sums(dim * fluid.n_local_nodes(), 0.);
      for (unsigned int c = 0; c < fluid.n_owned_cells(); ++c)
        if (fluid.is_active_cell(c))
          for (const unsigned int node : fluid.cell(c).nodes)
            {
              const double volume = std::pow(fluid.cell(c).size, dim);
              sums[dim * node] += volume * pressure[c];
              sums[dim * node + 1] += volume;
            }
      fluid.sum_forces(sums.data());
      std::vector<double> owned(dim * fluid.n_owned_nodes(), 0.);
      for (unsigned int i = 0; i < fluid.n_owned_nodes(); ++i)
        if (sums[dim * i + 1] > 0)
          owned[dim * i] = sums[dim * i] / sums[dim * i + 1];
      std::vector<double> result(sums.size());
      fluid.gather(owned.data(), result.data());
      return result;
    }

    template <int dim>
    [[noreturn]] void
    refuse(const Point<dim> &point)
    {
      std::ostringstream text;
      text << "the point (" << point
           << ") m, at which the flow is wanted, is outside of the box";
      throw InputError(text.str());
    }

    /** The point moved off the upper sides, since cells are half-open. */
    template <int dim>
    Point<dim>
    inside(const FluidGrid<dim> &grid, Point<dim> point)
    {
      const Point<dim> given = point;
      for (unsigned int d = 0; d < dim; ++d)
        point[d] = std::min(point[d],
                            grid.upper()[d] -
                              1e-9 * (grid.upper()[d] - grid.lower()[d]));
      if (given.distance(point) > 1e-6 * grid.lower().distance(grid.upper()))
        refuse(given);
      return point;
    }
  } // namespace



  template <int dim>
  FlowSamples<dim>
  sample_flow(const FlowModel<dim> &model,
              const double *y,
              const std::vector<Point<dim>> &points)
  {
    const FluidOperator<dim> &fluid = model.fluid();
    const std::vector<double> u     = model.local_velocity(y);
    const std::vector<double> p     = nodal_pressure(model, y);
    // velocity, pressure, and 1 from the rank that owns the cell
    std::vector<double> values((dim + 2) * points.size(), 0.);
    for (unsigned int k = 0; k < points.size(); ++k)
      {
        const Point<dim> x = inside(model.grid(), points[k]);
        const int c        = fluid.locate(x);
        if (c < 0 || c >= static_cast<int>(fluid.n_owned_cells()))
          continue;
        const auto &cell = fluid.cell(c);
        double *value    = &values[(dim + 2) * k];
        const Point<dim> unit_point((x - cell.lower) / cell.size);
        const auto velocity = interpolate<dim>(cell, unit_point, u);
        std::copy_n(velocity.begin_raw(), dim, value);
        value[dim]     = interpolate<dim>(cell, unit_point, p)[0];
        value[dim + 1] = 1;
      }
    std::vector<double> all(values.size());
    dealii::Utilities::MPI::sum(values, model.communicator, all);

    FlowSamples<dim> result;
    for (unsigned int k = 0; k < points.size(); ++k)
      {
        const double *value = &all[(dim + 2) * k];
        if (value[dim + 1] == 0)
          refuse(points[k]);
        result.velocity.emplace_back(
          dealii::ArrayView<const double>(value, dim));
        result.pressure.push_back(value[dim]);
      }
    return result;
  }



  template <int dim>
  std::vector<ReferenceValue<dim>>
  read_reference_values(const std::string &file)
  {
    std::ifstream stream(file);
    if (!stream)
      throw InputError(file + ": cannot be opened (Flow/Reference values)");
    std::vector<ReferenceValue<dim>> result;
    unsigned int number = 0;
    for (std::string line; std::getline(stream, line);)
      {
        ++number;
        if (line.empty() || line[0] == '#')
          continue;
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream words(line);
        std::vector<double> row;
        for (double word; words >> word;)
          row.push_back(word);
        if (row.size() != dim + 2 || !words.eof() || row[dim] < 0 ||
            row[dim] >= dim || row[dim] != std::floor(row[dim]))
          throw InputError(file + ", line " + std::to_string(number) +
                           ": expected are " + std::to_string(dim) +
                           " coordinates, a component from 0 and a value");
        ReferenceValue<dim> value;
        for (unsigned int d = 0; d < dim; ++d)
          value.point[d] = row[d];
        value.component = static_cast<unsigned int>(row[dim]);
        value.value     = row[dim + 1];
        result.push_back(value);
      }
    if (result.empty())
      throw InputError(file + ": no values (Flow/Reference values)");
    return result;
  }

  template FlowSamples<2>
  sample_flow(const FlowModel<2> &,
              const double *,
              const std::vector<Point<2>> &);
  template FlowSamples<3>
  sample_flow(const FlowModel<3> &,
              const double *,
              const std::vector<Point<3>> &);
  template std::vector<ReferenceValue<2>>
  read_reference_values<2>(const std::string &);
  template std::vector<ReferenceValue<3>>
  read_reference_values<3>(const std::string &);
} // namespace coapt
