#ifndef coapt_chordae_attachment_h
#define coapt_chordae_attachment_h

#include <coapt/chordae/chorda.h>

#include <deal.II/base/point.h>

#include <vector>

namespace coapt
{
  /**
   * Attaches @p chorda to all @p nodes (m) nearer to @p target than @p radius
   * (m), its sphere of influence: sets its nodes and their weights
   *   w = m (1 - d^2/r^2) / sum
   * of sum one, with the distance d and the @p nodal_mass m (kg), without
   * which light nodes at corners would be torn off. The force acts on the
   * weighted mean of the nodes, as a ball joint.
   *
   * @throws InputError if the sphere holds no node.
   */
  void
  attach(Chorda &chorda,
         const std::vector<dealii::Point<3>> &nodes,
         const std::vector<double> &nodal_mass,
         const dealii::Point<3> target,
         const double radius);
} // namespace coapt

#endif
