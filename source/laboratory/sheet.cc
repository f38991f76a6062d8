#include <coapt/laboratory/sheet.h>

#include <algorithm>
#include <map>

namespace coapt
{
  Sheet::Sheet(const double side,
               const double thickness,
               const unsigned int n_elements,
               const unsigned int n_layers)
    : side(side), thickness(thickness)
  {
    const unsigned int n = n_elements;
    const auto node      = [&](const std::array<unsigned int, 3> &i) {
      return (i[2] * (n + 1) + i[1]) * (n + 1) + i[0];
    };
    for (unsigned int z = 0; z <= n_layers; ++z)
      for (unsigned int y = 0; y <= n; ++y)
        for (unsigned int x = 0; x <= n; ++x)
          {
            const unsigned int number = mesh.points.size();
            mesh.points.emplace_back(side * x / n,
                                     side * y / n,
                                     thickness * z / n_layers);
            if (x == 0)
              held[0].push_back(number);
            if (y == 0)
              held[1].push_back(number);
            if (z == 0)
              held[2].push_back(number);
          }

    for (unsigned int z = 0; z < n_layers; ++z)
      for (unsigned int y = 0; y < n; ++y)
        for (unsigned int x = 0; x < n; ++x)
          {
            // From corner to opposite corner along the axes in every order.
            std::array<int, 3> order = {{0, 1, 2}};
            do
              {
                std::array<unsigned int, 3> corner = {{x, y, z}};
                std::array<unsigned int, 4> cell;
                cell[0] = node(corner);
                for (int k = 0; k < 3; ++k)
                  {
                    ++corner[order[k]];
                    cell[k + 1] = node(corner);
                  }
                const bool even = (order[1] - order[0] + 3) % 3 == 1;
                if (!even)
                  std::swap(cell[1], cell[2]);
                mesh.cells.push_back(cell);
            } while (std::next_permutation(order.begin(), order.end()));
          }

    for (int d = 0; d < 2; ++d)
      {
        // Two triangles a box, a third of each for each of its nodes.
        const double third = side_area() / (n * n_layers) / 6;
        std::map<unsigned int, double> areas;
        for (const auto &cell : mesh.cells)
          {
            std::vector<unsigned int> corners;
            for (const unsigned int v : cell)
              if (mesh.points[v][d] > side * (1 - 1e-9))
                corners.push_back(v);
            if (corners.size() == 3)
              for (const unsigned int v : corners)
                areas[v] += third;
          }
        for (const auto &entry : areas)
          {
            pulled[d].push_back(entry.first);
            pulled_area[d].push_back(entry.second);
          }
      }
  }
} // namespace coapt
