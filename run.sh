#!/usr/bin/env bash
# ./run.sh [FILE.prm]: runs a parameter file (the quick start by default) on all
# cores, after installing and building what is missing, and writes the report of
# a valve; its path is the last line. COAPT_RANKS sets the number of MPI ranks,
# COAPT_BUILD the build folder.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/tools/setup.sh"

file=${1:-$root/parameter-files/quickstart.prm}
install_packages
build_targets coapt
mpirun -np "${COAPT_RANKS:-$cores}" "$build/coapt" "$file"

# Flows, bodies in boxes and sheets have no report. The exit code is that of the run: a
# report that cannot be made, for want of fields, says why.
if ! grep -Eq '^ *set +Task *= *(flow|immersed|biaxial|fit)' "$file"; then
  "$root/tools/coapt-report" "$file" ||
    echo "run.sh: the run is complete, but its report could not be made" >&2
fi
