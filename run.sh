#!/usr/bin/env bash
# Installs what is missing, builds, runs the quick study and prints the path of its report.
# With arguments: passes them to gibench instead.
if [ $# -eq 0 ] && ! { mkdir -p out/quick && [ -w out/quick ]; } 2>/dev/null; then
  printf 'gibench: %s cannot be written: call run.sh from a folder that can, the results go to out/quick there\n' "$PWD/out/quick" >&2
  exit 2
fi
source "$(dirname "${BASH_SOURCE[0]}")/cmake/setup.sh"
gibench=$build/bin/gibench
cd "$invoked_from"

if [ $# -gt 0 ]; then
  exec "$gibench" "$@"
fi

status=0
"$gibench" study "$build/share/gibench/scenes/studies/quick.study.json" --out out/quick || status=$?
if [ "$status" -ne 0 ] && [ "$status" -ne 4 ]; then exit "$status"; fi  # with 4 runs failed, and the report shows which
"$gibench" report out/quick
printf '\nThe report: %s\n' "$PWD/out/quick/report/index.html"
exit "$status"
