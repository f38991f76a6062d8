#!/usr/bin/env bash
# ./run.sh [FILE.prm]: runs a parameter file (the quick start by default) on all
# cores, after installing and building what is missing. COAPT_RANKS sets the
# number of MPI ranks, COAPT_BUILD the build folder.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/tools/setup.sh"

file=${1:-$root/parameter-files/quickstart.prm}
install_packages
build_targets coapt
exec mpirun -np "${COAPT_RANKS:-$cores}" "$build/coapt" "$file"
