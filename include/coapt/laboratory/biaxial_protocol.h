#ifndef coapt_laboratory_biaxial_protocol_h
#define coapt_laboratory_biaxial_protocol_h

#include <array>
#include <string>
#include <vector>

namespace coapt
{
  /** What is done to a sheet, state after state: its stretches, or the tensions
   * of its sides. */
  struct BiaxialProtocol
  {
    /** A state, and where the file says so. */
    struct State
    {
      int protocol;
      std::array<double, 2> values; ///< stretches, or N/m
      std::string place;
    };

    bool has_tensions = false;
    std::vector<State> states;

    /**
     * From a table with the columns protocol, stretch1, stretch2 or protocol,
     * tension1_N_per_m, tension2_N_per_m (force over the length of the side at
     * rest); without a line of names, stretches.
     *
     * @throws InputError if the table cannot be read (NumberTable), or a
     * stretch is not positive.
     */
    static BiaxialProtocol
    from_file(const std::string &file);
  };
} // namespace coapt

#endif
