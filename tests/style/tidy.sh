#!/usr/bin/env bash
# tidy.sh BUILD_FOLDER [FILE...]: clang-tidy with the checks of .clang-tidy on source files of the build. Without files:
# those that differ from GIBENCH_BASE (default: the last commit's parent); all of them with GIBENCH_TIDY=all. About ten
# seconds per file and core. The build folder must have no precompiled headers: clang cannot read those of g++.
build=$(realpath "$1")
shift
source "$(dirname "${BASH_SOURCE[0]}")/files.sh"
base=${GIBENCH_BASE:-HEAD~1}

compiled_files() {  # of the project, as the build compiles them
  awk -v root="$PWD/" -F'"' '$2 == "file" && index($4, root) == 1 { print substr($4, length(root) + 1) }' \
    "$build/compile_commands.json" | sort -u
}

# A header that changed is looked at through the source of its name, or one that includes it.
changed_files() {
  { git diff --name-only --diff-filter=d "$base" -- '*.cpp' '*.h'; git ls-files --others --exclude-standard -- '*.cpp' '*.h'; } |
    while read -r file; do
      case $file in
        *.cpp) echo "$file" ;;
        *.h)
          if [ -f "${file%.h}.cpp" ]; then echo "${file%.h}.cpp"
          else grep -rlF "\"$file\"" --include='*.cpp' bench common methods reports scenes tests | head -n 1 || true; fi ;;
      esac
    done
}

chosen_files() {
  if [ "${GIBENCH_TIDY:-}" = all ]; then compiled_files; else comm -12 <(changed_files | sort -u) <(compiled_files); fi
}

if [ $# -gt 0 ]; then
  files=$(printf '%s\n' "$@")
else
  if [ "${GIBENCH_TIDY:-}" != all ] && ! git rev-parse -q --verify "$base^{commit}" >/dev/null; then
    echo "tidy: git knows no commit $base: set GIBENCH_BASE, or GIBENCH_TIDY=all" >&2
    exit 2
  fi
  files=$(chosen_files)
fi
if [ -z "$files" ]; then
  echo "no file to check"
  exit 0
fi
printf '%s\n' "$files" >&2
# The compiler is g++: what clang does not know about its options is not a fault.
printf '%s\n' "$files" | tr '\n' '\0' | xargs -0 -r -n 1 -P "$(nproc)" clang-tidy --quiet -p "$build" \
  --extra-arg=-Wno-unknown-warning-option --extra-arg=-Wno-error
echo "no faults"
