#include <coapt/base/exceptions.h>
#include <coapt/metrics/coaptation.h>

#include <algorithm>

namespace coapt
{
  using dealii::Point;

  Coaptation::Coaptation(const Leaflet &leaflet,
                         const CoaptationSettings &settings)
    : settings(settings), lines(leaflet), graph(leaflet)
  {
    for (unsigned int c = 0; c < leaflet.columns.size(); ++c)
      reference.push_back(middle_of_column(leaflet, c));
    around_value = columns_within(settings.filter_radius);
    around_belt  = columns_within(settings.belt_radius);
  }



  Coaptation::Neighbourhoods
  Coaptation::columns_within(const double radius) const
  {
    const unsigned int n = reference.size();
    Neighbourhoods result(n);
    for (unsigned int c = 0; c < n; ++c)
      for (unsigned int other = 0; other < n; ++other)
        if (other == c ||
            reference[c].distance_square(reference[other]) <= radius * radius)
          result[c].push_back(other);
    return result;
  }



  std::vector<double>
  Coaptation::average(const std::vector<double> &values,
                      const std::vector<double> &gap,
                      const std::vector<double> &area) const
  {
    return average(around_value, values, gap, area);
  }



  std::vector<double>
  Coaptation::average(const Neighbourhoods &around,
                      const std::vector<double> &values,
                      const std::vector<double> &gap,
                      const std::vector<double> &area) const
  {
    const std::vector<bool> beside = apposed(gap);
    std::vector<double> result(values.size(), 0.);
    for (unsigned int c = 0; c < values.size(); ++c)
      {
        if (!beside[c])
          continue;
        double sum = 0, weight = 0;
        for (const unsigned int other : around[c])
          if (beside[other])
            {
              sum += area[other] * values[other];
              weight += area[other];
            }
        result[c] = weight > 0 ? sum / weight : values[c];
      }
    return result;
  }



  LeafletCoaptation
  Coaptation::belt(const LeafletLines::Lines &of_leaflet,
                   const std::vector<bool> &coapts) const
  {
    LeafletCoaptation result;
    if (of_leaflet.empty())
      return result;
    unsigned int gap = 0;
    for (const auto &line : of_leaflet)
      {
        double line_height = 0;
        bool touches       = false;
        for (const unsigned int column : line)
          if (coapts[column])
            {
              touches = true;
              line_height += lines.height[column];
            }
        gap                = touches ? 0 : gap + 1;
        result.longest_gap = std::max(result.longest_gap, gap);
        result.mean_height += line_height / of_leaflet.size();
      }
    const std::vector<unsigned int> way =
      graph.way(of_leaflet, coapts, reference);
    for (const unsigned int column : way)
      result.missing_columns += coapts[column] ? 0 : 1;
    result.continuous = !way.empty() && result.missing_columns == 0;
    return result;
  }



  CoaptationResult
  Coaptation::evaluate(const std::vector<double> &gap,
                       const std::vector<double> &contact_pressure,
                       const std::vector<double> &total_traction,
                       const std::vector<double> &area) const
  {
    const std::vector<double> traction = average(total_traction, gap, area);
    const std::vector<bool> coapts     = coapting(gap, total_traction, area);
    CoaptationResult result;
    for (unsigned int c = 0; c < gap.size(); ++c)
      {
        if (!coapts[c])
          continue;
        result.area += 0.5 * area[c];
        result.force += 0.5 * area[c] * total_traction[c];
        result.contact_force += 0.5 * area[c] * contact_pressure[c];
        result.max_traction = std::max(result.max_traction, traction[c]);
      }
    if (result.force > 0)
      result.contact_fraction = result.contact_force / result.force;
    result.anterior  = belt(lines.anterior, coapts);
    result.posterior = belt(lines.posterior, coapts);
    result.continuous =
      result.anterior.continuous && result.posterior.continuous;
    result.longest_gap =
      std::max(result.anterior.longest_gap, result.posterior.longest_gap);
    return result;
  }



  std::vector<bool>
  Coaptation::coapting(const std::vector<double> &gap,
                       const std::vector<double> &total_traction,
                       const std::vector<double> &area) const
  {
    const std::vector<double> traction =
      average(around_belt, total_traction, gap, area);
    std::vector<bool> result(gap.size());
    for (unsigned int c = 0; c < gap.size(); ++c)
      result[c] =
        gap[c] <= settings.gap_limit && traction[c] >= settings.least_traction;
    return result;
  }



  std::vector<bool>
  Coaptation::apposed(const std::vector<double> &gap) const
  {
    std::vector<bool> result(gap.size());
    for (unsigned int c = 0; c < gap.size(); ++c)
      result[c] = gap[c] <= settings.gap_limit;
    return result;
  }



  std::array<std::vector<LineCoaptation>, 2>
  Coaptation::profile(const std::vector<double> &gap,
                      const std::vector<double> &total_traction,
                      const std::vector<double> &area,
                      const std::vector<Point<3>> &points) const
  {
    const std::vector<bool> coapts     = coapting(gap, total_traction, area);
    const std::vector<double> traction = average(total_traction, gap, area);
    const auto of = [&](const LeafletLines::Lines &of_leaflet) {
      return coaptation_profile(of_leaflet,
                                lines.height,
                                coapts,
                                apposed(gap),
                                traction,
                                reference,
                                points);
    };
    return {{of(lines.anterior), of(lines.posterior)}};
  }



  std::array<std::vector<BeltGap>, 2>
  Coaptation::gaps(const std::vector<double> &gap,
                   const std::vector<double> &total_traction,
                   const std::vector<double> &area,
                   const std::vector<Point<3>> &points) const
  {
    const std::vector<bool> coapts = coapting(gap, total_traction, area);
    return {{graph.gaps(lines.anterior, coapts, points),
             graph.gaps(lines.posterior, coapts, points)}};
  }
} // namespace coapt
