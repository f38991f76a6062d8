#ifndef coapt_solid_materials_material_h
#define coapt_solid_materials_material_h

#include <coapt/solid/materials/fung.h>
#include <coapt/solid/materials/holzapfel_gasser_ogden.h>
#include <coapt/solid/materials/may_newman_yin.h>
#include <coapt/solid/materials/neo_hookean.h>
#include <coapt/solid/materials/ogden.h>
#include <coapt/solid/materials/saint_venant_kirchhoff.h>
#include <coapt/solid/materials/tense_fibres.h>

#include <variant>

namespace coapt
{
  /** One of the materials; std::visit takes its type out of inner loops. */
  using Material = std::variant<HolzapfelGasserOgden,
                                Ogden,
                                NeoHookean,
                                Fung,
                                MayNewmanYin,
                                SaintVenantKirchhoff,
                                TenseFibres>;

  /** Every material with its parameters; one of them is chosen by name. */
  struct Materials
  {
    HolzapfelGasserOgden holzapfel_gasser_ogden;
    Ogden ogden;
    NeoHookean neo_hookean;
    Fung fung;
    MayNewmanYin may_newman_yin;
    SaintVenantKirchhoff saint_venant_kirchhoff;
    TenseFibres tense_fibres;

    /** Calls @p f with every material of @p materials. */
    template <typename Self, typename Function>
    static void
    for_each(Self &materials, const Function &f)
    {
      f(materials.holzapfel_gasser_ogden);
      f(materials.ogden);
      f(materials.neo_hookean);
      f(materials.fung);
      f(materials.may_newman_yin);
      f(materials.saint_venant_kirchhoff);
      f(materials.tense_fibres);
    }
  };
} // namespace coapt

#endif
