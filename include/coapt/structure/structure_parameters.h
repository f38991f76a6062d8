#ifndef coapt_structure_structure_parameters_h
#define coapt_structure_structure_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace coapt
{
  /** A valve without fluid: subsection "Structure". */
  struct StructureParameters
  {
    /** Whether the leaflets move in blood. */
    bool in_blood = true;

    /** Whether the load is the ventricular pressure, or else read from a
     * file. */
    bool uniform_pressure = true;

    /** File with the load on the mid-surface over time. */
    std::string load_file;

    /** Mass of blood that moves with the leaflets, over theirs (-). */
    double added_mass = 8;

    /** Drag in proportion to the leaflets' own mass, in the place of the blood
     * (1/s). */
    double mass_damping = 1000;

    /** Rate at which the drag slows down the leaflets with the blood that moves
     * with them (1/s). */
    double
    damping_rate() const;

    /** Declares the subsection. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Reads it. @throws InputError if a file is needed and not named. */
    void
    parse_parameters(dealii::ParameterHandler &prm);
  };
} // namespace coapt

#endif
