#ifndef coapt_solid_materials_material_h
#define coapt_solid_materials_material_h

#include <coapt/solid/materials/holzapfel_gasser_ogden.h>
#include <coapt/solid/materials/neo_hookean.h>
#include <coapt/solid/materials/ogden.h>
#include <coapt/solid/materials/saint_venant_kirchhoff.h>
#include <coapt/solid/materials/tense_fibres.h>

#include <type_traits>
#include <variant>

namespace coapt
{
  /** One of the materials; std::visit takes its type out of inner loops. */
  using Material = std::variant<HolzapfelGasserOgden,
                                Ogden,
                                NeoHookean,
                                SaintVenantKirchhoff,
                                TenseFibres>;

  /** Whether a material exists in 3D only. */
  template <typename Law>
  constexpr bool is_spatial = std::is_same<Law, HolzapfelGasserOgden>::value ||
    std::is_same<Law, Ogden>::value;

  /** Whether a material needs a fibre in every cell. */
  template <typename Law>
  constexpr bool has_fibres = std::is_same<Law, HolzapfelGasserOgden>::value ||
    std::is_same<Law, TenseFibres>::value;
} // namespace coapt

#endif
