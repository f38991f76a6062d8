#ifndef coapt_metrics_chordae_peaks_h
#define coapt_metrics_chordae_peaks_h

#include <coapt/chordae/chorda.h>

#include <array>
#include <vector>

namespace coapt
{
  /** Remembers the largest tension of a single chorda in each class. */
  class ChordaePeaks
  {
  public:
    static constexpr unsigned int n_classes = 4;

    /** The largest tension of a class so far. */
    struct Peak
    {
      double tension = 0; // N
      double time    = 0; // s
      std::string id;     // of the chorda; empty if none was taut

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &tension &time &id;
      }
    };

    ChordaePeaks(const std::vector<Chorda> &chordae);

    /** Takes the @p tensions (N) of all chordae at @p time (s) into account.
     * Throws InputError if there are not as many of them as chordae. */
    void
    update(const double time, const std::vector<double> &tensions);

    /** The peak of a class. */
    const Peak &
    peak(const ChordaClass chorda_class) const;

    /** Sum of the @p tensions (N) in each class, indexed by ChordaClass. */
    std::array<double, n_classes>
    class_tensions(const std::vector<double> &tensions) const;

    /** Saves or restores the peaks so far. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &peaks;
    }

  private:
    std::vector<std::string> ids;
    std::vector<ChordaClass> classes;
    std::array<Peak, n_classes> peaks;
  };

  /** "anterior_primary" and so on. */
  std::string
  name_of(const ChordaClass chorda_class);
} // namespace coapt

#endif
