#ifndef coapt_import_import_parameters_h
#define coapt_import_import_parameters_h

#include <coapt/geometry/leaflet.h>

#include <deal.II/base/parameter_handler.h>

#include <map>
#include <string>

namespace coapt
{
  /** A valve that is read from files: subsection "Import", and Valve/Source. */
  struct ImportParameters
  {
    /** Whether the valve is read from files, or else generated. */
    bool is_wanted = false;

    /** Files of the mid-surface, of the held nodes, and, unless empty, of
     * chordae and fibres. */
    std::string mesh, held_nodes, chordae, fibres;

    /** Length in these files (m). */
    double unit = 1e-3;

    /** What the labels of the mesh mean. */
    std::map<int, Region> regions;

    /** Lengths at which chordae begin to pull, over those in the file. */
    double length_factor = 1;

    /** Declares the parameters. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Reads them. @throws InputError if a file that is needed is not named, or
     * if labels are not of the form number:region. */
    void
    parse_parameters(dealii::ParameterHandler &prm);
  };
} // namespace coapt

#endif
