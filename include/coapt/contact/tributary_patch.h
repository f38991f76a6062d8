#ifndef coapt_contact_tributary_patch_h
#define coapt_contact_tributary_patch_h

#include <coapt/contact/facing_rule.h>
#include <coapt/contact/mid_surface.h>

#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace coapt
{
  /**
   * The part of a surface that belongs to a column, and what it touches there:
   * means over the tributary area of the column, of the points of the surface
   * and of the points of the other part that are closest to them, each as
   * weights of columns with the sum one.
   *
   * Where sheets with different meshes touch, single points give some columns
   * more of the reaction than their share; with means over tributary areas all
   * get theirs, as with mortar integrals (Puso and Laursen 2004). Samples count
   * for equal parts of a quadrilateral, so this is exact for parallelograms.
   */
  struct TributaryPatch
  {
    struct Part
    {
      unsigned int column;
      double weight;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &column &weight;
      }
    };

    std::vector<Part> own, partner;

    /** How much of the area faces the other part; zero before the first
     * update. */
    double fraction = 0;

    static constexpr unsigned int none = -1;

    /** Triangle of the closest point to the column when the means were taken,
     * and what lies on the column's normal on it: its coordinates along the
     * sides from the first corner. */
    unsigned int triangle = none;
    std::array<double, 2> foot{};

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &own &partner &fraction &triangle &foot;
    }
  };



  /** Keeps tributary patches up to date. */
  class TributaryPatches
  {
  public:
    /** Of @p surface with the @p rule of its triangles; both must outlive
     * this. */
    TributaryPatches(const MidSurface &surface, const FacingRule &rule);

    /** Where a column is now, as seen from the part that it faced when the
     * means were taken. */
    struct Offset
    {
      dealii::Tensor<1, 3> slid; // along the surface since then, m
      double distance;           // along its normal, m
    };

    /** That of the @p column, of which @p patch is. */
    Offset
    offset(const TributaryPatch &patch,
           const std::vector<dealii::Point<3>> &points,
           const unsigned int column) const;

    /** Takes the means for the @p column and what faces it around
     * @p encounter, but no triangles that are its @p neighbours. */
    void
    update(TributaryPatch &patch,
           const std::vector<dealii::Point<3>> &points,
           const unsigned int column,
           const Encounter &encounter,
           const std::vector<unsigned int> &neighbours);

  private:
    struct Frame
    {
      dealii::Point<3> origin;
      dealii::Tensor<1, 3> u, v, normal;
    };

    Frame
    frame_of(const std::vector<dealii::Point<3>> &points,
             const unsigned int triangle) const;

    /** A weighted sum of columns. */
    struct Sum
    {
      void
      add(const unsigned int column, const double weight);

      /** Moves it, with the sum of weights @p total, to @p parts. */
      void
      fetch(const double total, std::vector<TributaryPatch::Part> &parts);

      std::vector<double> weights; // of all columns
      std::vector<unsigned int> columns;
    };

    void
    sample(const std::vector<dealii::Point<3>> &points,
           const unsigned int q,
           const unsigned int corner,
           const Encounter &start);

    const MidSurface &surface;
    const FacingRule &rule;

    // scratch of update()
    std::vector<bool> is_neighbour; // by triangle
    Sum own, partner;
    double area = 0, area_that_faces = 0;
  };
} // namespace coapt

#endif
