#!/usr/bin/env bash
# Installs what is missing, builds, and runs every test. Arguments go to ctest.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/cmake/setup.sh"
say "testing"
exec ctest --preset release --parallel "$(nproc)" --output-on-failure "$@"
