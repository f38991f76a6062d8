#!/usr/bin/env bash
# ./test.sh [CTEST OPTIONS]: builds everything and runs the tests, all of them
# or those that the options select, such as -R contact.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/tools/setup.sh"

# The report is looked at in a browser.
install_packages chromium chromium-driver python3-selenium fonts-dejavu-core
build_targets
# Built here, together: inside ctest every test would be compiled on its own.
build_targets test_programs
cd "$build"
exec ctest --output-on-failure -j "$cores" "$@"
