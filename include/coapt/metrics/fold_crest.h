#ifndef coapt_metrics_fold_crest_h
#define coapt_metrics_fold_crest_h

#include <deal.II/base/point.h>

#include <vector>

namespace coapt
{
  /**
   * The @p gap (m) of each column, with the crests of folds that are shut.
   *
   * Where a leaflet is folded, at the commissures above all, its two sides face
   * each other, but the columns in the crest between them face nothing and have
   * no gap. If the fold is shut, nothing can pass there: a column whose gap is
   * above @p limit lies in such a crest if two columns with opposite @p normals
   * (to what they face, at least 120 degrees apart) and gaps below the limit
   * are nearer to it and to each other than thickness plus limit. It is given
   * the larger of their gaps. @p points (m) are those of the mid-surface.
   */
  std::vector<double>
  gaps_with_fold_crests(const std::vector<double> &gap,
                        const std::vector<dealii::Tensor<1, 3>> &normals,
                        const std::vector<dealii::Point<3>> &points,
                        const double thickness,
                        const double limit);
} // namespace coapt

#endif
