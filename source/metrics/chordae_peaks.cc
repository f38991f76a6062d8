#include <coapt/base/exceptions.h>
#include <coapt/metrics/chordae_peaks.h>

namespace coapt
{
  ChordaePeaks::ChordaePeaks(const std::vector<Chorda> &chordae)
  {
    for (const Chorda &chorda : chordae)
      {
        ids.push_back(chorda.id);
        classes.push_back(chorda.chorda_class);
      }
  }



  void
  ChordaePeaks::update(const double time, const std::vector<double> &tensions)
  {
    if (tensions.size() != ids.size())
      throw InputError("Chordae peaks: " + std::to_string(tensions.size()) +
                       " tensions were given for " +
                       std::to_string(ids.size()) + " chordae.");
    for (unsigned int i = 0; i < ids.size(); ++i)
      {
        Peak &peak = peaks[static_cast<unsigned int>(classes[i])];
        if (tensions[i] > peak.tension)
          peak = {tensions[i], time, ids[i]};
      }
  }



  const ChordaePeaks::Peak &
  ChordaePeaks::peak(const ChordaClass chorda_class) const
  {
    return peaks[static_cast<unsigned int>(chorda_class)];
  }



  std::array<double, ChordaePeaks::n_classes>
  ChordaePeaks::class_tensions(const std::vector<double> &tensions) const
  {
    std::array<double, n_classes> sums{};
    for (unsigned int i = 0; i < ids.size(); ++i)
      sums[static_cast<unsigned int>(classes[i])] += tensions[i];
    return sums;
  }



  std::string
  name_of(const ChordaClass chorda_class)
  {
    switch (chorda_class)
      {
        case ChordaClass::anterior_primary:
          return "anterior_primary";
        case ChordaClass::anterior_secondary:
          return "anterior_secondary";
        case ChordaClass::posterior_primary:
          return "posterior_primary";
        case ChordaClass::posterior_secondary:
          return "posterior_secondary";
      }
    throw InputError("Chordae peaks: unknown class of chordae.");
  }
} // namespace coapt
