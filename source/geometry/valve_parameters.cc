#include <coapt/base/exceptions.h>
#include <coapt/geometry/valve_parameters.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <sstream>

namespace coapt
{
  using namespace dealii;

  namespace
  {
    constexpr double mm     = 1e-3;
    constexpr double degree = ValveParameters::degree;

    struct RealEntry
    {
      const char *name;
      double ValveParameters::*member;
      double unit, smallest, largest;
      const char *documentation;
    };

    struct IntegerEntry
    {
      const char *name;
      unsigned int ValveParameters::*member;
      int smallest, largest;
      const char *documentation;
    };

    using P = ValveParameters;

    const RealEntry shape_entries[] = {
      {"Annulus semi-axis x",
       &P::annulus_semi_axis_x,
       mm,
       1,
       100,
       "Half the extent of the annulus between the commissures (mm)."},
      {"Annulus semi-axis y",
       &P::annulus_semi_axis_y,
       mm,
       1,
       100,
       "Half the antero-posterior extent of the annulus (mm)."},
      {"Saddle height",
       &P::saddle_height,
       mm,
       0,
       50,
       "Height of the annulus's saddle, from its lowest to its highest points "
       "(mm): z = -height/2 cos 2t."},
      {"Anterior height",
       &P::anterior_height,
       mm,
       0.5,
       100,
       "Height of the leaflet at mid-anterior, from the annulus to the free "
       "edge (mm)."},
      {"Posterior height",
       &P::posterior_height,
       mm,
       0.5,
       100,
       "Height at mid-posterior (mm)."},
      {"Commissure height",
       &P::commissure_height,
       mm,
       0.5,
       100,
       "Height at the commissures (mm)."},
      {"Anterior profile exponent",
       &P::anterior_exponent,
       1,
       0.2,
       10,
       "Exponent q of the anterior height's profile, cos^2(pi/2 |xi|^q) with "
       "xi = -1..1 between the commissures: larger is fuller (-)."},
      {"Posterior profile exponent",
       &P::posterior_exponent,
       1,
       0.2,
       10,
       "The same for the posterior leaflet (-)."},
      {"Commissure angle",
       &P::commissure_angle,
       degree,
       -60,
       60,
       "Angle of the right commissure from the x axis towards the anterior "
       "side (degrees); the left one mirrors it."},
      {"Commissure half width",
       &P::commissure_half_width,
       degree,
       0,
       30,
       "Half the angle around a commissure that is labelled as commissure, "
       "for results by region (degrees)."},
      {"Anterior cone angle",
       &P::anterior_cone_angle,
       degree,
       -30,
       80,
       "Inclination of the open anterior leaflet towards the axis, from the "
       "downward direction (degrees)."},
      {"Posterior cone angle",
       &P::posterior_cone_angle,
       degree,
       -30,
       80,
       "The same for the posterior leaflet (degrees)."},
      {"Commissure cone angle",
       &P::commissure_cone_angle,
       degree,
       -30,
       80,
       "The same at the commissures (degrees)."},
      {"Thickness",
       &P::thickness,
       mm,
       0.05,
       5,
       "Thickness of the leaflets (mm)."},
      {"Circumferential prestretch",
       &P::circumferential_prestretch,
       1,
       0.8,
       1.5,
       "Stretch of the open leaflet along its rows against its stress-free "
       "state (-); 1 is none. The thickness is such that the volume does not "
       "change."},
      {"Radial prestretch",
       &P::radial_prestretch,
       1,
       0.8,
       1.5,
       "The same from annulus to free edge (-)."},
      {"Root length",
       &P::root_length,
       mm,
       0.1,
       10,
       "Length of the strip beyond the annulus line that is buried in the wall "
       "(mm)."}};

    const IntegerEntry mesh_entries[] = {
      {"Elements around",
       &P::n_circumferential,
       8,
       2000,
       "Number of elements around the valve (-), even; a multiple of 8 with "
       "elements of ten nodes."},
      {"Elements along the height",
       &P::n_radial,
       2,
       500,
       "Number of elements from the annulus to the free edge (-)."},
      {"Layers",
       &P::n_layers,
       1,
       16,
       "Number of elements through the thickness; two, for elements of ten "
       "nodes one whole one, bend as they should."},
      {"Root rows",
       &P::n_root_rows,
       1,
       20,
       "Number of elements along the root (-)."}};

    const RealEntry chordae_entries[] = {
      {"Coaptation depth",
       &P::coaptation_depth,
       mm,
       0,
       50,
       "Closed design, from which the chordae are cut to length: depth of the "
       "top of coaptation below the annulus plane, in the middle (mm)."},
      {"Coaptation y",
       &P::coaptation_y,
       mm,
       -50,
       50,
       "Closed design: y of the coaptation line in the middle (mm)."},
      {"Coaptation end drop",
       &P::coaptation_end_drop,
       mm,
       0,
       20,
       "Closed design: depth of the ends of the coaptation line below the "
       "annulus at the commissures (mm)."},
      {"Coaptation half width",
       &P::coaptation_half_width,
       1,
       0.1,
       1,
       "Closed design: x of the ends of the coaptation line as a fraction of "
       "that of the commissures (-)."},
      {"Closed stretch",
       &P::closed_stretch,
       1,
       1,
       2,
       "Closed design: radial stretch of the leaflets (-)."},
      {"Primary diameter",
       &P::primary_diameter,
       mm,
       0.01,
       5,
       "Diameter of the primary chordae (mm)."},
      {"Secondary diameter",
       &P::secondary_diameter,
       mm,
       0.01,
       5,
       "Diameter of the secondary chordae (mm)."},
      {"Modulus",
       &P::chordae_modulus,
       1e6,
       1e-3,
       1e4,
       "Young's modulus of the chordae (MPa)."},
      {"Primary length factor",
       &P::primary_length_factor,
       1,
       0.5,
       2,
       "Factor on the rest lengths of the primary chordae that the closed "
       "design gives (-)."},
      {"Secondary length factor",
       &P::secondary_length_factor,
       1,
       0.5,
       2,
       "The same for the secondary chordae (-)."},
      {"Influence radius",
       &P::influence_radius,
       mm,
       0.01,
       10,
       "Radius of the sphere around an attachment in which a chorda acts on "
       "the leaflet (mm)."}};

    template <typename Number>
    std::string
    text(const Number value)
    {
      std::ostringstream out;
      out << value;
      return out.str();
    }

    std::string
    list_text(const std::vector<double> &values, const double unit)
    {
      std::string out;
      for (const double value : values)
        out += (out.empty() ? "" : ", ") + text(value / unit);
      return out;
    }

    void
    declare_real(ParameterHandler &prm, const RealEntry &entry)
    {
      prm.declare_entry(entry.name,
                        text(P().*entry.member / entry.unit),
                        Patterns::Double(entry.smallest, entry.largest),
                        entry.documentation);
    }

    std::vector<double>
    get_list(ParameterHandler &prm, const std::string &name, const double unit)
    {
      std::vector<double> values = Utilities::string_to_double(
        Utilities::split_string_list(prm.get(name)));
      for (double &value : values)
        value *= unit;
      return values;
    }

    void
    declare_valve(ParameterHandler &prm)
    {
      for (const RealEntry &entry : shape_entries)
        declare_real(prm, entry);
      for (const IntegerEntry &entry : mesh_entries)
        prm.declare_entry(entry.name,
                          text(P().*entry.member),
                          Patterns::Integer(entry.smallest, entry.largest),
                          entry.documentation);
      prm.declare_entry(
        "Element",
        P().quadratic ? "P2" : "P1",
        Patterns::Selection("P1|P2"),
        "Tetrahedra of ten nodes (P2) or of four (P1), which bend 2.5 times "
        "too stiffly. The numbers of elements given here are those between "
        "neighbouring nodes: an element of ten nodes is as large as two of "
        "them in each direction. They must be even for P2, around the valve a "
        "multiple of eight. For generated valves: imported ones have four "
        "nodes.");
      prm.declare_entry(
        "Annulus",
        "straps",
        Patterns::Selection("straps|hinge|clamped"),
        "What is held: the mid-surface nodes of the annulus line and of the "
        "root's outer rim (straps), those of the annulus line only (hinge), or "
        "all nodes of the annulus line and of the root (clamped).");
      prm.declare_entry(
        "Fibres",
        "parallel",
        Patterns::Selection("parallel|circumferential"),
        "Direction of the fibres: parallel to the annulus plane, or along the "
        "rows of the mesh (circumferential).");
    }

    void
    declare_chordae(ParameterHandler &prm)
    {
      const P defaults;
      for (const RealEntry &entry : chordae_entries)
        declare_real(prm, entry);
      const Patterns::List angles(Patterns::Double(-90, 90), 0, 100);
      prm.declare_entry(
        "Papillary tip",
        list_text({&defaults.papillary_tip[0], &defaults.papillary_tip[0] + 3},
                  mm),
        Patterns::List(Patterns::Double(-100, 100), 3, 3),
        "Right papillary tip x, y, z (mm); the left one mirrors it in x.");
      prm.declare_entry(
        "Primary angles",
        list_text(defaults.primary_angles, degree),
        angles,
        "Angles at which the primary chordae of the right side hold the free "
        "edge (degrees; 90 mid-anterior, -90 mid-posterior). They are named "
        "R-P1, R-P2, ... in this order, those of the left side L-P1, ...");
      prm.declare_entry(
        "Secondary angles",
        list_text(defaults.secondary_angles, degree),
        angles,
        "The same for the secondary chordae, R-S1, ... (degrees).");
      prm.declare_entry(
        "Secondary heights",
        list_text(defaults.secondary_heights, 1),
        Patterns::List(Patterns::Double(0.05, 1), 0, 100),
        "Where the secondary chordae hold the leaflet: fraction of its height "
        "from the annulus, one for each of the angles (-).");
      prm.declare_entry("Removed chordae",
                        "",
                        Patterns::List(Patterns::Anything(), 0, 1000),
                        "Names of chordae that are left out, for example "
                        "R-P2, R-P3, R-P4.");
    }
  } // namespace



  void
  ValveParameters::declare_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Valve");
    declare_valve(prm);
    prm.leave_subsection();
    prm.enter_subsection("Chordae");
    declare_chordae(prm);
    prm.leave_subsection();
  }



  void
  ValveParameters::parse_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Valve");
    for (const RealEntry &entry : shape_entries)
      this->*entry.member = prm.get_double(entry.name) * entry.unit;
    for (const IntegerEntry &entry : mesh_entries)
      this->*entry.member = prm.get_integer(entry.name);
    const std::string hold = prm.get("Annulus");
    annulus_hold           = hold == "straps" ? AnnulusHold::straps
                : hold == "hinge"             ? AnnulusHold::hinge
                                              : AnnulusHold::clamped;
    quadratic              = prm.get("Element") == "P2";
    fibre_rule = prm.get("Fibres") == "parallel" ? FibreRule::parallel
                                                 : FibreRule::circumferential;
    prm.leave_subsection();

    prm.enter_subsection("Chordae");
    for (const RealEntry &entry : chordae_entries)
      this->*entry.member = prm.get_double(entry.name) * entry.unit;
    const std::vector<double> tip = get_list(prm, "Papillary tip", mm);
    papillary_tip                 = Point<3>(tip[0], tip[1], tip[2]);
    primary_angles                = get_list(prm, "Primary angles", degree);
    secondary_angles              = get_list(prm, "Secondary angles", degree);
    secondary_heights             = get_list(prm, "Secondary heights", 1);
    removed_chordae = Utilities::split_string_list(prm.get("Removed chordae"));
    prm.leave_subsection();
  }



  void
  ValveParameters::check() const
  {
    if (n_circumferential % 2 != 0)
      throw InputError("Valve/Elements around is " + text(n_circumferential) +
                       ", but must be even, so that the tetrahedra fit at the "
                       "seam.");
    if (n_circumferential < 8 || n_radial < 2 || n_layers < 1 ||
        n_root_rows < 1)
      throw InputError(
        "Valve: a mesh needs at least 8 elements around, 2 along "
        "the height, 1 layer and 1 root row.");
    for (const IntegerEntry &entry : mesh_entries)
      {
        // Around the valve, each quarter begins with an element.
        const unsigned int divisor =
          entry.member == &P::n_circumferential ? 8 : 2;
        if (quadratic && this->*entry.member % divisor != 0)
          throw InputError(std::string("Valve/") + entry.name + " is " +
                           text(this->*entry.member) +
                           ", but must be a multiple of " + text(divisor) +
                           " where Valve/Element is P2.");
      }
    for (const RealEntry &entry : shape_entries)
      if (!(this->*entry.member >= entry.smallest * entry.unit * (1 - 1e-9)) &&
          entry.smallest > 0)
        throw InputError(std::string("Valve/") + entry.name + " is " +
                         text(this->*entry.member / entry.unit) +
                         ", but must be at least " + text(entry.smallest) +
                         ".");
    if (secondary_angles.size() != secondary_heights.size())
      throw InputError("Chordae/Secondary heights has " +
                       text(secondary_heights.size()) +
                       " entries, but there "
                       "are " +
                       text(secondary_angles.size()) +
                       " Secondary angles: one for each is needed.");
  }
} // namespace coapt
