#!/usr/bin/env bash
# tidy.sh BUILD_FOLDER [FILE...]: clang-tidy with the checks of .clang-tidy on source files of the build. Without files:
# those that differ from GIBENCH_BASE (default: the last commit's parent); all of them with GIBENCH_TIDY=all. About ten
# seconds a file and core.
build=$(realpath "$1")
shift
source "$(dirname "${BASH_SOURCE[0]}")/files.sh"

compiled_files() {  # of the project, as the build compiles them
  sed -nE "s|^ *\"file\": \"$PWD/(.*)\",?$|\1|p" "$build/compile_commands.json" | sort -u
}

# A header that changed is looked at through the sources that include it.
changed_files() {
  git diff --name-only --diff-filter=d "${GIBENCH_BASE:-HEAD~1}" -- '*.cpp' '*.h' | while read -r file; do
    case $file in
      *.cpp) echo "$file" ;;
      *.h) grep -rlF "\"$file\"" --include='*.cpp' bench common methods reports scenes tests | head -n 1 || true ;;
    esac
  done
}

chosen_files() {
  if [ "${GIBENCH_TIDY:-}" = all ]; then compiled_files; else comm -12 <(changed_files | sort -u) <(compiled_files); fi
}

if [ $# -gt 0 ]; then files=$(printf '%s\n' "$@"); else files=$(chosen_files); fi
printf '%s\n' "$files" >&2
# The compiler is g++: what clang does not know about its options is no fault.
printf '%s\n' "$files" | tr '\n' '\0' | xargs -0 -r -n 1 -P "$(nproc)" clang-tidy --quiet -p "$build" \
  --extra-arg=-Wno-unknown-warning-option --extra-arg=-Wno-error
echo "no faults"
