#!/usr/bin/env bash
# tools/write_parameters.sh: writes doc/parameters.md anew, after building coapt.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

build_targets coapt
"$build/coapt" --write-defaults | awk -f "$root/tools/parameters.awk" >"$root/doc/parameters.md"
