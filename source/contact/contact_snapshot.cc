#include <deal.II/base/mpi.h>

#include <coapt/base/serialization.h>
#include <coapt/contact/mid_surface_contact.h>

#include <map>

// What of MidSurfaceContact a run needs that goes on from a checkpoint.
namespace coapt
{
  MidSurfaceContact::Snapshot
  MidSurfaceContact::snapshot() const
  {
    using Entry = std::pair<unsigned int, Memories>;
    std::vector<Entry> own;
    for (unsigned int i = 0; i < own_columns.size(); ++i)
      own.emplace_back(own_columns[i], memories[i]);
    Snapshot result{columns, time, finder.phase(), {}};
    for (const std::vector<Entry> &of_rank :
         dealii::Utilities::MPI::gather(communicator, own))
      result.memories.insert(result.memories.end(),
                             of_rank.begin(),
                             of_rank.end());
    return result;
  }



  void
  MidSurfaceContact::restore(const Snapshot &snapshot)
  {
    columns = snapshot.columns;
    time    = snapshot.time;
    finder.restore(snapshot.search);
    std::map<unsigned int, Memories> by_column(snapshot.memories.begin(),
                                               snapshot.memories.end());
    for (unsigned int i = 0; i < own_columns.size(); ++i)
      memories[i] = by_column[own_columns[i]];
  }
} // namespace coapt
