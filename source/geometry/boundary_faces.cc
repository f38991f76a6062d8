#include <coapt/geometry/boundary_faces.h>

#include <algorithm>
#include <map>

namespace coapt
{
  template <int dim>
  std::vector<BoundaryFace<dim>>
  boundary_faces(const std::vector<std::array<unsigned int, dim + 1>> &cells)
  {
    struct Candidate
    {
      BoundaryFace<dim> face;
      unsigned int n_cells = 0;
    };
    std::map<std::array<unsigned int, dim>, Candidate> candidates;
    for (unsigned int cell = 0; cell < cells.size(); ++cell)
      for (unsigned int opposite = 0; opposite <= dim; ++opposite)
        {
          BoundaryFace<dim> face;
          face.cell = cell;
          for (unsigned int i = 0; i < dim; ++i)
            {
              face.vertices[i] = i < opposite ? i : i + 1;
              face.nodes[i]    = cells[cell][face.vertices[i]];
            }
          std::sort(face.nodes.begin(), face.nodes.end());
          Candidate &candidate = candidates[face.nodes];
          candidate.face       = face;
          ++candidate.n_cells;
        }
    std::vector<BoundaryFace<dim>> result;
    for (const auto &[nodes, candidate] : candidates)
      if (candidate.n_cells == 1)
        result.push_back(candidate.face);
    return result;
  }

  template std::vector<BoundaryFace<2>>
  boundary_faces<2>(const std::vector<std::array<unsigned int, 3>> &);
  template std::vector<BoundaryFace<3>>
  boundary_faces<3>(const std::vector<std::array<unsigned int, 4>> &);
} // namespace coapt
