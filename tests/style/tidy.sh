#!/usr/bin/env bash
# tidy.sh BUILD_FOLDER [FILE...]: clang-tidy with the checks of .clang-tidy on source files of the build.
# Without files: those that differ from the last commit's parent (the first 24), and every tenth of the others, another
# tenth each commit: about ten seconds a file and core, every file seen again and again. All of them with GIBENCH_TIDY=all.
build=$(realpath "$1")
shift
source "$(dirname "${BASH_SOURCE[0]}")/files.sh"
slices=10

compiled_files() {  # of the project, as the build compiles them
  sed -nE "s|^ *\"file\": \"$PWD/(.*)\",?$|\1|p" "$build/compile_commands.json" | sort -u
}

changed_files() {
  git diff --name-only --diff-filter=d HEAD~1 2>/dev/null | grep '\.cpp$' || true
}

chosen_files() {
  if [ "${GIBENCH_TIDY:-}" = all ]; then
    compiled_files
    return
  fi
  local commits
  commits=$(git rev-list --count HEAD 2>/dev/null || echo 0)
  {
    compiled_files | awk -v slices=$slices -v turn=$((commits % slices)) 'NR % slices == turn'
    comm -12 <(changed_files | sort -u) <(compiled_files) | awk 'NR <= 24'
  } | sort -u
}

if [ $# -gt 0 ]; then files=$(printf '%s\n' "$@"); else files=$(chosen_files); fi
printf '%s\n' "$files" >&2
# The compiler is g++: what clang does not know about its options is no fault.
printf '%s\n' "$files" | xargs -r -n 1 -P "$(nproc)" clang-tidy --quiet -p "$build" \
  --extra-arg=-Wno-unknown-warning-option --extra-arg=-Wno-error
echo "no faults"
