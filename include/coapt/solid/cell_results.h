#ifndef coapt_solid_cell_results_h
#define coapt_solid_cell_results_h

#include <vector>

namespace coapt
{
  /** State of each cell of a solid; all vectors empty or as long as there are
   * cells. */
  struct CellResults
  {
    /** Von Mises norm of the elastic Cauchy stress (Pa). */
    std::vector<double> von_mises;

    /** Largest principal value of the elastic Cauchy stress (Pa). */
    std::vector<double> principal_stress;

    /** Largest logarithmic strain relative to the mesh, without prestretch. */
    std::vector<double> largest_strain;

    /** Smallest principal stretch relative to the mesh, without prestretch. */
    std::vector<double> smallest_stretch;

    /** Volume over that in the mesh. */
    std::vector<double> volume_ratio;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &von_mises &principal_stress &largest_strain &smallest_stretch;
      archive &volume_ratio;
    }
  };
} // namespace coapt

#endif
