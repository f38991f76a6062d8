#include <coapt/base/exceptions.h>
#include <coapt/chordae/attachment.h>

#include <sstream>

namespace coapt
{
  void
  attach(Chorda &chorda,
         const std::vector<dealii::Point<3>> &nodes,
         const std::vector<double> &nodal_mass,
         const dealii::Point<3> target,
         const double radius)
  {
    chorda.nodes.clear();
    chorda.weights.clear();
    double sum = 0;
    for (unsigned int i = 0; i < nodes.size(); ++i)
      {
        const double distance = target.distance(nodes[i]) / radius;
        if (!(distance < 1))
          continue;
        chorda.nodes.push_back(i);
        chorda.weights.push_back(nodal_mass[i] * (1 - distance * distance));
        sum += chorda.weights.back();
      }
    if (!(sum > 0))
      {
        std::ostringstream message;
        message << "chorda " << chorda.id << " attached to nothing: no node "
                << "within " << radius * 1e3 << " mm of (" << target * 1e3
                << ") mm.";
        throw InputError(message.str());
      }
    for (double &weight : chorda.weights)
      weight /= sum;
  }
} // namespace coapt
