#include <coapt/base/csv_table.h>
#include <coapt/base/exceptions.h>
#include <coapt/base/units.h>
#include <coapt/coupled/prescribed_motion.h>

#include <algorithm>
#include <map>

namespace coapt
{
  using dealii::Tensor;

  void
  MotionParameters::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Motion");
    prm.declare_entry("File",
                      "",
                      dealii::Patterns::Anything(),
                      "File with the displacement over time of nodes that are "
                      "held, sought beside the parameter file: a CSV with the "
                      "columns node (name of a set, such as annulus, or number "
                      "of a column), time_s, ux_mm, uy_mm, uz_mm. Empty: "
                      "nothing that is held moves.");
    prm.leave_subsection();
  }



  void
  MotionParameters::parse_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Motion");
    file = prm.get("File");
    prm.leave_subsection();
  }



  namespace
  {
    /** The rows of one entry. */
    struct Rows
    {
      unsigned int first; // for messages
      std::vector<double> times;
      std::vector<Tensor<1, 3>> displacements;
    };

    std::map<std::string, Rows>
    rows_by_node(const CsvTable &table)
    {
      const auto node = table.texts("node");
      const auto time = table.numbers("time_s");
      std::array<std::vector<double>, 3> u;
      for (unsigned int d = 0; d < 3; ++d)
        u[d] = table.numbers(std::string("u") + "xyz"[d] + "_mm");

      std::map<std::string, Rows> result;
      for (unsigned int i = 0; i < table.n_rows(); ++i)
        {
          Rows &rows =
            result.try_emplace(node[i], Rows{i, {}, {}}).first->second;
          if (!rows.times.empty() && !(time[i] > rows.times.back()))
            throw InputError(table.place(i) + ": the times of " + node[i] +
                             " must increase");
          rows.times.push_back(time[i]);
          rows.displacements.push_back(
            units::millimetre * Tensor<1, 3>({u[0][i], u[1][i], u[2][i]}));
        }
      return result;
    }

    /** The held nodes that an entry means; @p place is for messages. */
    std::vector<unsigned int>
    nodes_of(const std::string &name,
             const Leaflet &leaflet,
             const std::string &place)
    {
      const auto set = leaflet.held_sets.find(name);
      if (set != leaflet.held_sets.end())
        return set->second;

      std::string known;
      for (const auto &[other, nodes] : leaflet.held_sets)
        known += (known.empty() ? "" : ", ") + other;
      const bool is_number = !name.empty() && name.size() < 10 &&
        name.find_first_not_of("0123456789") == std::string::npos;
      const unsigned long column = is_number ? std::stoul(name) : 0;
      if (!is_number || column >= leaflet.columns.size())
        throw InputError(place + ": there is no node '" + name +
                         "'; there are the sets " + known +
                         " and columns from 0 to " +
                         std::to_string(leaflet.columns.size() - 1));
      std::vector<unsigned int> nodes;
      for (const unsigned int node : leaflet.columns[column])
        if (leaflet.pinned[node])
          nodes.push_back(node);
      if (nodes.empty())
        throw InputError(place + ": no node of column " + name +
                         " is held, so that it cannot be moved");
      return nodes;
    }
  } // namespace



  PrescribedMotion::PrescribedMotion(const std::string &file,
                                     const Leaflet &leaflet)
    : reference(leaflet.mesh.points)
  {
    const CsvTable table(file);
    std::vector<bool> is_named(reference.size(), false);
    for (const auto &[name, rows] : rows_by_node(table))
      {
        const std::string place = table.place(rows.first);
        groups.push_back(
          {{rows.times, rows.displacements}, nodes_of(name, leaflet, place)});
        const double jump = groups.back().history.displacement(0.).norm();
        if (jump > 1e-9)
          throw InputError(place + ": the displacement of " + name + " is " +
                           std::to_string(jump / units::millimetre) +
                           " mm at time zero, where it must be zero");
        for (const unsigned int node : groups.back().nodes)
          {
            if (is_named[node])
              throw InputError(place + ": a node of " + name +
                               " belongs to another entry, too");
            is_named[node] = true;
            moving.push_back(node);
          }
      }
  }



  void
  PrescribedMotion::apply(const double t, double *X, double *V) const
  {
    for (const Group &group : groups)
      {
        const Tensor<1, 3> u = group.history.displacement(t),
                           v = group.history.velocity(t);
        for (const unsigned int node : group.nodes)
          for (unsigned int d = 0; d < 3; ++d)
            {
              X[3 * node + d] = reference[node][d] + u[d];
              if (V != nullptr)
                V[3 * node + d] = v[d];
            }
      }
  }
} // namespace coapt
