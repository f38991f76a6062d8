#include <coapt/base/exceptions.h>
#include <coapt/solid/sheet_state.h>
#include <coapt/solid/tangent.h>

#include <cmath>
#include <sstream>

namespace coapt
{
  std::array<double, 9>
  sheet_directions(const double fibre_angle)
  {
    const double c = std::cos(fibre_angle), s = std::sin(fibre_angle);
    return {{c, s, 0, -s, c, 0, 0, 0, 1}};
  }

  SheetState
  stretched_sheet(const Material &material,
                  const double stretch_1,
                  const double stretch_2,
                  const std::array<double, 9> &directions)
  {
    std::ostringstream name;
    name << "A sheet stretched by " << stretch_1 << " and " << stretch_2;
    if (!(stretch_1 > 0 && stretch_2 > 0))
      throw InputError(name.str() + ": stretches must be positive.");

    SheetState state{};
    state.F[0][0] = stretch_1;
    state.F[1][1] = stretch_2;
    double &l     = state.F[2][2];
    l             = 1 / (stretch_1 * stretch_2);
    for (unsigned int i = 0; i < 100; ++i)
      {
        double slope = 0;
        std::visit(
          [&](const auto &law) {
            state.P = law.first_piola(state.F, directions.data());
            slope   = material_tangent(law, state.F, directions.data())[8][8];
          },
          material);
        const double change = state.P[2][2] / slope;
        if (!(slope > 0))
          break;
        if (std::abs(change) < 1e-14 * l)
          return state;
        l = change < 0.5 * l ? l - change : 0.5 * l;
      }
    throw NumericalError(name.str() +
                         " has no thickness at which the stress across it "
                         "vanishes.");
  }
} // namespace coapt
