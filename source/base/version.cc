#include <coapt/base/revision.h>
#include <coapt/base/version.h>

#include <deal.II/base/config.h>

#include <metis.h>
#include <mpi.h>

#include <vector>

namespace coapt
{
  namespace
  {
    std::string
    join(const std::vector<int> &numbers)
    {
      std::string text;
      for (const int number : numbers)
        text += (text.empty() ? "" : ".") + std::to_string(number);
      return text;
    }

    /** "Open MPI v4.1.4" of the long text that the library gives. */
    std::string
    mpi_version()
    {
      char text[MPI_MAX_LIBRARY_VERSION_STRING];
      int length;
      MPI_Get_library_version(text, &length);
      const std::string all(text, length);
      return all.substr(0, all.find_first_of(",\n"));
    }
  } // namespace

  std::string
  version()
  {
    return COAPT_VERSION;
  }



  std::string
  revision()
  {
    return COAPT_REVISION;
  }



  std::string
  library_versions()
  {
    return "deal.II " DEAL_II_PACKAGE_VERSION ", p4est " +
      join({DEAL_II_P4EST_VERSION_MAJOR,
            DEAL_II_P4EST_VERSION_MINOR,
            DEAL_II_P4EST_VERSION_SUBMINOR}) +
      ", Trilinos " +
      join({DEAL_II_TRILINOS_VERSION_MAJOR,
            DEAL_II_TRILINOS_VERSION_MINOR,
            DEAL_II_TRILINOS_VERSION_SUBMINOR}) +
      ", SUNDIALS " +
      join({DEAL_II_SUNDIALS_VERSION_MAJOR,
            DEAL_II_SUNDIALS_VERSION_MINOR,
            DEAL_II_SUNDIALS_VERSION_PATCH}) +
      ", METIS " +
      join({METIS_VER_MAJOR, METIS_VER_MINOR, METIS_VER_SUBMINOR}) + ", " +
      mpi_version() + ", GCC " __VERSION__;
  }



  std::string
  parameter_files_folder()
  {
    return COAPT_PARAMETER_FILES;
  }
} // namespace coapt
