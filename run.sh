#!/usr/bin/env bash
# Installs what is missing, builds, runs the quick study and prints the path of its report.
# With arguments: passes them to gibench instead.
source "$(dirname "${BASH_SOURCE[0]}")/cmake/setup.sh"
gibench=$build/bin/gibench
cd "$invoked_from"

if [ $# -gt 0 ]; then
  exec "$gibench" "$@"
fi

"$gibench" study "$build/share/gibench/scenes/studies/quick.study.json" --out out/quick
"$gibench" report out/quick
printf '\nThe report: %s\n' "$PWD/out/quick/report/index.html"
