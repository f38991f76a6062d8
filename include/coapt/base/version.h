#ifndef coapt_base_version_h
#define coapt_base_version_h

#include <string>

namespace coapt
{
  /** "0.1.0". */
  std::string
  version();

  /** Revision of the sources, with "-dirty" if they had been changed, or
   * "unknown" if they were not under version control. */
  std::string
  revision();

  /** The libraries in use and the compiler, with versions, on one line. */
  std::string
  library_versions();

  /** Folder of the parameter files that come with the sources. */
  std::string
  parameter_files_folder();
} // namespace coapt

#endif
