#!/usr/bin/env bash
# tools/write_parameters.sh: writes doc/parameters.md anew, after building coapt.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

build_targets coapt
for task in valve flow immersed biaxial fit; do
  "$build/coapt" --write-defaults "$task"
done | awk -f "$root/tools/parameters.awk" >"$root/doc/parameters.md"
