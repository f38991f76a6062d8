// The traction of coaptation of a piece of leaflet with known pressures on both
// sides, whatever the sign of its normal and however oblique its partner.

#include <coapt/metrics/coaptation_traction.h>

#include "tests.h"

using namespace coapt;
using dealii::Tensor;

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const double p_contact = 3e3, p_film = 5e3, p_ventricle = 16e3;
  const double area = 0.4e-6;
  Tensor<1, 3> to_film({1., -2., 0.5}), along({2., 1., 0.});
  to_film /= to_film.norm();
  along /= along.norm();
  // The blood pushes towards the film, and drags along the surface.
  const Tensor<1, 3> force =
    area * ((p_ventricle - p_film) * to_film + 2e3 * along);
  // 60 degrees off the normal
  const Tensor<1, 3> oblique = 0.5 * to_film + std::sqrt(0.75) * along;

  for (const double sign : {1., -1.})
    check_relative(
      sign > 0 ? "contact and film" : "the same for the opposite normal",
      coaptation_traction(
        p_contact, p_ventricle, force, sign * to_film, oblique, area),
      p_contact + p_film,
      1e-12);

  // A film at the ventricular pressure carries all of it, one at the atrial
  // pressure none: then only contact is left.
  check_relative(
    "a film that does not drain",
    coaptation_traction(0, p_ventricle, Tensor<1, 3>(), to_film, to_film, area),
    p_ventricle,
    1e-12);
  check_relative("a film that has drained",
                 coaptation_traction(p_contact,
                                     p_ventricle,
                                     area * p_ventricle * to_film,
                                     to_film,
                                     to_film,
                                     area),
                 p_contact,
                 1e-12);

  // In a fold with the film on the other side of the surface the blood pushes
  // the other way.
  check_relative("a film on the other side",
                 coaptation_traction(p_contact,
                                     p_ventricle,
                                     -area * (p_ventricle - p_film) * to_film,
                                     to_film,
                                     -1. * oblique,
                                     area),
                 p_contact + p_film,
                 1e-12);
}
