#ifndef coapt_solid_materials_material_defaults_h
#define coapt_solid_materials_material_defaults_h

#include <coapt/solid/small_matrix.h>

namespace coapt
{
  /** What most materials answer; a material that differs hides it. */
  struct MaterialDefaults
  {
    /** Whether it exists in 3D only. */
    static constexpr bool is_spatial = false;

    /** Whether it needs a fibre in every cell. */
    static constexpr bool has_fibres = false;

    /** Whether it needs the normal of the leaflet in every cell, too: fibres
     * then consist of nine numbers, the fibre, the direction across it and
     * the normal. */
    bool
    needs_normal() const
    {
      return false;
    }

    /** Strain over the limit up to which the published formula is used; beyond
     * one it is continued in some other manner. Zero: without limit. */
    template <int dim>
    double
    strain_ratio(const SmallMatrix<dim, double> &, const double *) const
    {
      return 0;
    }
  };
} // namespace coapt

#endif
