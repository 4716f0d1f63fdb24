#!/usr/bin/env bash
# Installs what is missing, builds, runs the quick study and prints the path of its report.
# With arguments: passes them to gibench instead.
set -euo pipefail
from=$PWD
source "$(dirname "${BASH_SOURCE[0]}")/cmake/setup.sh"
gibench=$PWD/build/release/bin/gibench

if [ $# -gt 0 ]; then
  cd "$from"
  exec "$gibench" "$@"
fi

"$gibench" study scenes/studies/quick.study.json --out out/quick
"$gibench" report out/quick
printf '\nThe report: %s\n' "$PWD/out/quick/report/index.html"
