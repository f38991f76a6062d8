#include <coapt/base/first_rank.h>
#include <coapt/flow/flow_fields.h>
#include <coapt/flow/flow_model.h>
#include <coapt/io/fluid_piece.h>

namespace coapt
{
  template <int dim>
  FlowFields<dim>::FlowFields(const FlowModel<dim> &model,
                              const std::string &folder)
    : model(model), folder(folder)
  {
  }



  template <int dim>
  void
  FlowFields<dim>::write(const double time, const double *y)
  {
    const std::vector<double> u = model.local_velocity(y);
    const double *p             = model.pressure(y);
    const FluidPiece<dim> piece(model.fluid());
    VtuFile file = piece.file(u.data());

    std::vector<double> pressure, velocity_error, pressure_error;
    for (const unsigned int i : piece.cells)
      {
        dealii::Point<dim> center = model.fluid().cell(i).lower;
        for (unsigned int d = 0; d < dim; ++d)
          center[d] += model.fluid().cell(i).size / 2;
        pressure.push_back(p[i]);
        if (model.exact_pressure)
          pressure_error.push_back(p[i] - model.exact_pressure(center, time));
      }
    for (unsigned int k = 0; k < piece.points.size() && model.exact_velocity;
         ++k)
      {
        dealii::Point<dim> x;
        for (unsigned int d = 0; d < dim; ++d)
          x[d] = piece.points[k][d];
        const auto exact = model.exact_velocity(x, time);
        for (unsigned int d = 0; d < 3; ++d)
          velocity_error.push_back(
            d < dim ? u[dim * piece.nodes[k] + d] - exact[d % dim] : 0.);
      }
    file.add_cell_data("pressure", 1, pressure);
    file.add_cell_data("level", 1, piece.levels(model.grid(), model.fluid()));
    if (model.exact_pressure)
      file.add_cell_data("pressure_error", 1, pressure_error);
    if (model.exact_velocity)
      file.add_point_data("velocity_error", 3, velocity_error);

    const std::string name = numbered("fluid", entries.size());
    entries.emplace_back(
      time, write_distributed(file, folder, name, model.communicator));
    if (is_first_rank(model.communicator))
      write_collection(folder + "/fluid.pvd", entries);
  }

  template class FlowFields<2>;
  template class FlowFields<3>;
} // namespace coapt
