#include <deal.II/base/mpi.h>

#include <coapt/coupled/valve_model.h>

#include <algorithm>
#include <cmath>
#include <sstream>

// The parts of ValveModel that say where a state is not finite.
namespace coapt
{
  using dealii::Point;

  unsigned int
  ValveModel::cell_of_node(const unsigned int node) const
  {
    for (unsigned int c = 0; c < fluid->n_owned_cells(); ++c)
      for (const unsigned int n : fluid->cell(c).nodes)
        if (n == node)
          return c;
    return 0;
  }



  std::string
  ValveModel::name_of_entry(const std::size_t i) const
  {
    const auto &at         = system->layout();
    const auto coordinates = [](const Point<3> &x) {
      std::ostringstream text;
      text << "at (" << 1e3 * x[0] << ", " << 1e3 * x[1] << ", " << 1e3 * x[2]
           << ") mm";
      return text.str();
    };
    if (i < at.position())
      {
        const auto &cell = fluid->cell(i < at.pressure() ? cell_of_node(i / 3)
                                                         : i - at.pressure());
        std::ostringstream size;
        size << 1e3 * cell.size;
        return "fluid cell of " + size.str() + " mm " + coordinates(cell.lower);
      }
    if (i < at.multiplier())
      return "node of the leaflet, in the beginning " +
        coordinates(
               leaflet.mesh.points[system->first_owned_node() +
                                   (i - at.position()) / 3 % at.n_solid_nodes]);
    return "multiplier of a coupling point";
  }



  std::string
  ValveModel::name_not_finite(const std::vector<double> &y) const
  {
    // Larger than anything in a valve, so that its powers soon overflow.
    const double absurd = 1e15;
    const auto bad = std::find_if(y.begin(), y.end(), [=](const double value) {
      return !(std::abs(value) < absurd);
    });
    const std::string name =
      bad == y.end() ? "" : name_of_entry(bad - y.begin());
    for (const std::string &found :
         dealii::Utilities::MPI::all_gather(communicator, name))
      if (!found.empty())
        return found;
    return "all values are finite";
  }
} // namespace coapt
