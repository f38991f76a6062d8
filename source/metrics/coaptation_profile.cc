#include <coapt/metrics/coaptation_profile.h>

#include <algorithm>

namespace coapt
{
  using dealii::Point;

  namespace
  {
    /** Length of those parts of a line that the marked columns stand for. */
    double
    marked_length(const std::vector<unsigned int> &line,
                  const std::vector<bool> &marked,
                  const std::vector<Point<3>> &points)
    {
      double length = 0;
      for (unsigned int i = 1; i < line.size(); ++i)
        length += 0.5 * (int(marked[line[i - 1]]) + int(marked[line[i]])) *
          points[line[i - 1]].distance(points[line[i]]);
      return length;
    }
  } // namespace



  std::vector<LineCoaptation>
  coaptation_profile(const LeafletLines::Lines &lines,
                     const std::vector<double> &height,
                     const std::vector<bool> &coapts,
                     const std::vector<bool> &apposed,
                     const std::vector<double> &traction,
                     const std::vector<Point<3>> &reference,
                     const std::vector<Point<3>> &current)
  {
    std::vector<LineCoaptation> result(lines.size());
    double attachment = 0;
    for (unsigned int i = 0; i < lines.size(); ++i)
      {
        LineCoaptation &line = result[i];
        if (i > 0)
          attachment += reference[lines[i - 1].front()].distance(
            reference[lines[i].front()]);
        line.position = attachment;
        for (const unsigned int column : lines[i])
          if (coapts[column])
            {
              line.contact_height += height[column];
              line.max_traction = std::max(line.max_traction, traction[column]);
            }
        line.apposition = marked_length(lines[i], apposed, current);
      }
    if (attachment > 0)
      for (LineCoaptation &line : result)
        line.position /= attachment;
    return result;
  }



  std::vector<SegmentCoaptation>
  coaptation_by_segment(const std::vector<LineCoaptation> &profile,
                        const char letter)
  {
    std::vector<SegmentCoaptation> result(3);
    std::array<unsigned int, 3> count{};
    for (unsigned int i = 0; i < 3; ++i)
      result[i].name = letter + std::to_string(i + 1);
    for (const LineCoaptation &line : profile)
      {
        const unsigned int i       = std::min(2u, unsigned(3 * line.position));
        SegmentCoaptation &segment = result[i];
        segment.min_contact_height = count[i] == 0
          ? line.contact_height
          : std::min(segment.min_contact_height, line.contact_height);
        segment.contact_height += line.contact_height;
        segment.apposition += line.apposition;
        ++count[i];
      }
    for (unsigned int i = 0; i < 3; ++i)
      if (count[i] > 0)
        {
          result[i].contact_height /= count[i];
          result[i].apposition /= count[i];
        }
    return result;
  }
} // namespace coapt
