#ifndef coapt_laboratory_biaxial_test_h
#define coapt_laboratory_biaxial_test_h

#include <coapt/laboratory/biaxial_protocol.h>
#include <coapt/laboratory/sheet.h>
#include <coapt/laboratory/solid_newton.h>
#include <coapt/solid/sheet_state.h>

#include <array>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace coapt
{
  /** The sheet and how it is computed: the subsections "Biaxial" and "Solid".
   */
  struct BiaxialParameters
  {
    std::string protocol_file = "tables/biaxial_protocol.csv";
    double side               = 10e-3; ///< (m)
    double thickness          = 1e-3;  ///< (m)
    unsigned int n_elements   = 6;
    unsigned int n_layers     = 1;
    double fibre_angle        = 0; ///< to side 1 (rad)
    bool quasi_static         = true;
    bool dynamic              = true;
    double ramp_time          = 10e-3; ///< (s)
    SolidParameters solid;

    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Reads them. @throws InputError as SolidParameters. */
    void
    parse_parameters(dealii::ParameterHandler &prm);
  };

  /** A state of the sheet as measured in a test. */
  struct BiaxialResult
  {
    std::array<double, 2> stretch;

    /** Force at the pulled sides over their area at rest (Pa). */
    std::array<double, 2> stress;

    /** Iterations of Newton's method, or explicit steps. */
    unsigned int n_steps;
  };

  /**
   * The biaxial test of a square sheet of finite elements. Its sides stay plane
   * and glide on what pulls them, so that the state is homogeneous if fibres
   * are along a side; a tension is a dead load.
   */
  class BiaxialTest
  {
  public:
    /**
     * @throws InputError if the protocol leaves the range in which the
     * material can be used: beyond the limit of its exponential, where no
     * homogeneous state balances the tensions, where nearly incompressible
     * material has half or twice its volume, and where a plane wave has a
     * negative modulus, or one a million times that at rest.
     */
    BiaxialTest(const BiaxialParameters &parameters,
                const BiaxialProtocol &protocol);

    /**
     * Brings the sheet to rest in the next @p state by Newton's method, in
     * smaller parts where it does not converge.
     *
     * @throws NumericalError if that does not help, InputError as the
     * constructor for tensions.
     */
    BiaxialResult
    equilibrium(const BiaxialProtocol::State &state);

    /**
     * The same by explicit dynamics (central differences): sides or loads go
     * there within the ramp time, and damping proportional to the mass brings
     * the sheet to rest, critical for the motion at the moment (Underwood,
     * 1983). Rest: no force above 1e-6 of the largest one.
     *
     * @throws NumericalError if it does not come to rest.
     */
    BiaxialResult
    settle(const BiaxialProtocol::State &state);

    /** Back to the sheet at rest. */
    void
    reset();

    /** The homogeneous state at these stretches. */
    SheetState
    homogeneous(const std::array<double, 2> &stretch) const;

  private:
    /** Puts the pulled sides or the load to where the protocol says. */
    void
    impose(const std::array<double, 2> &values);

    /** Stretches and stresses as they are. */
    BiaxialResult
    measure(const unsigned int n_steps) const;

    /** Internal forces and load (N). */
    std::vector<double>
    forces() const;

    /** Stretches of the homogeneous sheet in each state of a protocol. */
    std::vector<std::array<double, 2>>
    stretches_of(const BiaxialProtocol &protocol) const;

    /** Changes the @p stretch of the homogeneous sheet so that it balances the
     * stresses @p end instead of @p begin, in small parts if necessary; false
     * if it cannot. */
    bool
    follow_load(const std::array<double, 2> &begin,
                const std::array<double, 2> &end,
                std::array<double, 2> &stretch) const;

    /** What is wrong with the material at these stretches; empty: nothing. */
    std::string
    out_of_range(const std::array<double, 2> &stretch) const;

    void
    check_range(const std::array<double, 2> &stretch,
                const std::string &place) const;

    const BiaxialParameters parameters;
    const bool has_tensions;
    Material material;
    std::array<double, 9> directions;
    Sheet sheet;
    SolidOperator<3> solid;
    std::vector<bool> is_fixed;
    SolidNewton newton;
    std::vector<double> X, load;
    std::array<double, 2> current; ///< values of the protocol
  };
} // namespace coapt

#endif
