#!/usr/bin/env bash
# Installs what is missing, builds, and runs every test. Arguments go to ctest.
source "$(dirname "${BASH_SOURCE[0]}")/cmake/setup.sh"
say "testing"
exec ctest --test-dir "$build" --parallel "$(test_jobs)" --output-on-failure "$@"
