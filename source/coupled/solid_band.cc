#include <coapt/base/exceptions.h>
#include <coapt/base/units.h>
#include <coapt/coupled/solid_band.h>

#include <cmath>

namespace coapt
{
  using dealii::Point;

  void
  MeshParameters::declare_parameters(dealii::ParameterHandler &prm)
  {
    using dealii::Patterns::Double;
    using dealii::Patterns::Integer;
    prm.enter_subsection("Mesh");
    prm.declare_entry("Coarse cell",
                      "5",
                      Double(1e-3, 1e3),
                      "Edge of a cell of the coarse mesh (mm).");
    prm.declare_entry("Lumen level",
                      "2",
                      Integer(0, 10),
                      "Refinements of the lumen away from the leaflet (-).");
    prm.declare_entry("Leaflet level",
                      "3",
                      Integer(0, 12),
                      "Refinements around the leaflet (-); at least the "
                      "lumen's.");
    prm.declare_entry("Band",
                      "2.5",
                      Double(2., 100.),
                      "Half width of the refined band around the leaflet, in "
                      "cells of the finest level (-).");
    prm.leave_subsection();
  }



  void
  MeshParameters::parse_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Mesh");
    coarse_cell   = prm.get_double("Coarse cell") * units::millimetre;
    lumen_level   = prm.get_integer("Lumen level");
    leaflet_level = prm.get_integer("Leaflet level");
    band          = prm.get_double("Band");
    prm.leave_subsection();
    if (leaflet_level < lumen_level)
      throw InputError(
        "Mesh: Leaflet level is " + std::to_string(leaflet_level) +
        ", but must be at least Lumen level, " + std::to_string(lumen_level));
  }



  template <int dim>
  SolidBand<dim>::SolidBand(
    const MeshParameters &parameters,
    const std::function<double(const Point<dim> &)> &lumen)
    : parameters(parameters), lumen(lumen)
  {
  }



  template <int dim>
  void
  SolidBand<dim>::place(const std::vector<Point<dim>> &x)
  {
    placed = x;
    tree   = dealii::pack_rtree(x);
  }



  template <int dim>
  unsigned int
  SolidBand<dim>::wanted_level(const Point<dim> &center,
                               const double size) const
  {
    const double half_diagonal = 0.5 * std::sqrt(double(dim)) * size;
    if (!placed.empty())
      {
        std::vector<Point<dim>> nearest;
        tree.query(boost::geometry::index::nearest(center, 1),
                   std::back_inserter(nearest));
        // A larger cell is refined if one of its parts may lie in the band.
        const double margin =
          half_diagonal * (1 - parameters.finest_cell() / size);
        if (center.distance(nearest[0]) <
            parameters.band * parameters.finest_cell() + margin)
          return parameters.leaflet_level;
      }
    if (lumen && lumen(center) > half_diagonal)
      return 0;
    return parameters.lumen_level;
  }



  template <int dim>
  bool
  SolidBand<dim>::is_used_up(const std::vector<Point<dim>> &x) const
  {
    // What remains is the half diagonal of the cell that a point lies in, and
    // half a cell.
    const double allowed =
      (parameters.band - 0.5 - 0.5 * std::sqrt(double(dim))) *
      parameters.finest_cell();
    for (unsigned int q = 0; q < x.size(); ++q)
      if (x[q].distance_square(placed[q]) > allowed * allowed)
        return true;
    return false;
  }



  template class SolidBand<2>;
  template class SolidBand<3>;
} // namespace coapt
