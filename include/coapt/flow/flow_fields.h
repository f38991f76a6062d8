#ifndef coapt_flow_flow_fields_h
#define coapt_flow_flow_fields_h

#include <string>
#include <utility>
#include <vector>

namespace coapt
{
  template <int dim>
  class FlowModel;

  /** Writes the fields of a flow for ParaView: a file fluid_NUMBER.pvtu at
   * each time and a collection fluid.pvd of all times so far. */
  template <int dim>
  class FlowFields
  {
  public:
    /** Writes into the existing folder @p folder. */
    FlowFields(const FlowModel<dim> &model, const std::string &folder);

    /** Velocity (nodes; m/s), pressure (cells; Pa), level, and the errors of
     * both where an exact solution is given. Collective. */
    void
    write(const double time, const double *y);

    /** Saves or restores which files there are. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &entries;
    }

  private:
    const FlowModel<dim> &model;
    const std::string folder;
    std::vector<std::pair<double, std::string>> entries;
  };
} // namespace coapt

#endif
