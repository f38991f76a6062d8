#ifndef coapt_tests_structure_small_valve_h
#define coapt_tests_structure_small_valve_h

#include <coapt/coupled/model_parameters.h>

#include <fstream>
#include <string>

/** A coarse valve under the pressures of the @p table, lines of time (s) and
 * pressure (Pa), which is written as a file beside the test's output. */
inline coapt::ModelParameters
small_valve(const std::string &table)
{
  coapt::ModelParameters parameters;
  parameters.valve.n_circumferential = 24;
  parameters.valve.n_radial          = 4;
  parameters.ends.pressure_table     = "small_pressure.csv";
  std::ofstream(parameters.ends.pressure_table) << "time_s,pressure_Pa\n"
                                                << table;
  return parameters;
}

#endif
