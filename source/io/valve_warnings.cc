#include <coapt/base/exceptions.h>
#include <coapt/io/valve_warnings.h>

#include <cstdio>

namespace coapt
{
  namespace
  {
    std::string
    text(const double value, const std::string &unit)
    {
      char buffer[64];
      std::snprintf(buffer, sizeof(buffer), "%.3g %s", value, unit.c_str());
      return buffer;
    }
  } // namespace



  std::vector<ValveWarning>
  valve_warnings(const ValveSample &sample,
                 const double thickness,
                 const double finest_cell)
  {
    const std::string apart = "coupling points are " +
      text(sample.point_spacing, "cells") + " apart in the stretched leaflet ";
    // Replicated positions: all ranks stop alike.
    if (sample.point_spacing >= 1.4)
      throw NumericalError(apart + "(1.4 and more is unstable)");

    std::vector<ValveWarning> result;
    if (sample.min_gap < -0.5 * thickness)
      result.push_back({"penetration",
                        "the leaflet penetrates itself by " +
                          text(-1e3 * sample.min_gap, "mm") +
                          ", more than half its thickness"});
    if (sample.point_spacing > 0.9)
      result.push_back({"stretched points", apart + "(above 0.9 it leaks)"});
    if (sample.path_width >= 0.5 * finest_cell)
      return result;

    if (sample.checkerboard_rms > 10)
      result.push_back({"checkerboard",
                        "alternating pressures away from the leaflet reach " +
                          text(sample.checkerboard_rms, "Pa") +
                          " (rms; above 10 Pa)"});
    if (sample.hourglass_rms > 1e-3)
      result.push_back({"hourglass",
                        "alternating velocities away from the leaflet reach " +
                          text(1e3 * sample.hourglass_rms, "mm/s") +
                          " (rms; above 1 mm/s)"});
    if (sample.largest_velocity > 1)
      result.push_back({"jet",
                        "velocities reach " +
                          text(sample.largest_velocity, "m/s") +
                          " in a valve that is shut: a gap at an edge or "
                          "hinge?"});
    return result;
  }
} // namespace coapt
