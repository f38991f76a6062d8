#ifndef coapt_coupled_model_parameters_h
#define coapt_coupled_model_parameters_h

#include <coapt/chordae/chordae_parameters.h>
#include <coapt/contact/contact_parameters.h>
#include <coapt/coupled/film_parameters.h>
#include <coapt/coupled/mesh_parameters.h>
#include <coapt/coupled/prescribed_motion.h>
#include <coapt/fluid/fluid_parameters.h>
#include <coapt/geometry/lumen.h>
#include <coapt/geometry/valve_parameters.h>
#include <coapt/immersion/immersion_parameters.h>
#include <coapt/import/import_parameters.h>
#include <coapt/solid/solid_parameters.h>

#include <string>

namespace coapt
{
  /** The two ends of the lumen (subsection "Ends"). */
  struct EndParameters
  {
    /** File with the ventricular pressure over time, and its unit. */
    std::string pressure_table = "tables/systolic_pressure.csv";
    std::string pressure_unit  = "from file";

    /** Impedances of the two ends (Pa s/m). */
    double ventricular_impedance = 12000.;
    double atrial_impedance      = 12000.;

    /** Declares the parameters. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Reads them. */
    void
    parse_parameters(dealii::ParameterHandler &prm);
  };

  /** Parameters of a valve in blood: everything but time and output. */
  struct ModelParameters
  {
    MeshParameters mesh;
    FluidParameters fluid;
    LumenParameters lumen;
    EndParameters ends;
    ValveParameters valve;
    ImportParameters import;
    ChordaeParameters chordae;
    SolidParameters solid;
    ImmersionParameters coupling;
    ContactParameters contact;
    FilmParameters film;
    MotionParameters motion;

    /** Folder of the parameter file, where the files that it names are. */
    std::string folder;

    /** Declares all of them. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Reads all of them; throws InputError. */
    void
    parse_parameters(dealii::ParameterHandler &prm);
  };
} // namespace coapt

#endif
