# Sourced by run.sh and test.sh: installs what is missing, configures and
# builds. Sets root (the source tree), build (the build folder) and cores.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${COAPT_BUILD:-$root/build}

# One rank a physical core: a second thread on a core does not help.
cores=$(lscpu -p=CORE,SOCKET 2>/dev/null | grep -v '^#' | sort -u | wc -l)
available=$(nproc)
if [ "$cores" -lt 1 ] || [ "$cores" -gt "$available" ]; then
  cores=$available
fi

# Open MPI refuses to start as root, and binds two runs to the same core,
# unless told otherwise.
if [ "$(id -u)" -eq 0 ]; then
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
fi
export OMPI_MCA_hwloc_base_binding_policy=none
export OMPI_MCA_rmaps_base_oversubscribe=1
# Large pages for what malloc hands out: the integrator runs 1.25 times as fast.
export GLIBC_TUNABLES=${GLIBC_TUNABLES:-glibc.malloc.hugetlb=1}

# install_packages [PACKAGE...]: what is needed to build, run and report, and
# these packages besides.
install_packages()
{
  command -v dpkg-query >/dev/null || return 0
  local package missing=() administrator=()
  for package in g++ cmake ninja-build numdiff git mpi-default-bin \
    libdeal.ii-dev libsundials-dev libmetis-dev libceres-dev python3-vtk9 \
    python3-matplotlib xvfb xauth "$@"; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null |
      grep -q 'install ok installed' || missing+=("$package")
  done
  [ ${#missing[@]} -gt 0 ] || return 0

  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "These packages are missing, please have them installed:" \
        "${missing[*]}" >&2
      return 1
    fi
    administrator=(sudo)
  fi
  echo "Installing ${missing[*]}"
  "${administrator[@]}" apt-get update -qq
  "${administrator[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

# A compiler process that includes deal.II needs up to 1.5 GB.
build_jobs()
{
  local memory
  memory=$(awk '/MemAvailable/ {print int($2 / 1500000)}' /proc/meminfo)
  [ "$memory" -ge 1 ] || memory=1
  echo $((memory < available ? memory : available))
}

# build_targets TARGET...: builds these targets, all if none is named.
build_targets()
{
  if [ ! -f "$build/build.ninja" ]; then
    cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
      ${CI:+-DCOAPT_WERROR=ON}
  fi
  ninja -C "$build" -j "$(build_jobs)" "$@"
}
