# Sourced by the tests of this folder, with their arguments SOURCE_FOLDER BUILD_FOLDER. Gives $source, $build and $scratch, a
# folder with a blank in its name that is removed at the end.
set -euo pipefail
export LC_ALL=C.UTF-8 CMAKE_BUILD_PARALLEL_LEVEL=2
unset GIBENCH_DATA GIBENCH_PATH GIBENCH_REPORTS
source=$1
build=$2

fail() {
  printf '%s\n' "$*" >&2
  exit 1
}

[ -x "$build/bin/gibench" ] || { echo "skipped: the program is not built ($build/bin/gibench)"; exit 77; }

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
scratch="$folder/a folder"
mkdir "$scratch"

# readme_block N: the commands of the N-th block of the README's section on new methods.
readme_block() {
  awk -v wanted="$1" '/^## / { inside = /^## A new method$/ }
    inside && /^ *```sh$/ { ++block; next }
    /^ *```$/ { if (block == wanted) exit; next }
    inside && block == wanted' "$source/README.md"
}

# run_readme_block N: in the current folder, as a reader would.
run_readme_block() {
  readme_block "$1" > "$folder/block.sh"
  [ -s "$folder/block.sh" ] || fail "README.md, A new method: there is no block $1"
  bash -euo pipefail "$folder/block.sh" > "$folder/log" 2>&1 || fail "$(cat "$folder/block.sh" "$folder/log")" \
    "README.md, A new method: these commands fail"
}

# expect WHAT TEXT COMMAND...: it succeeds, and TEXT is a line of what it says on stdout.
expect() {
  local said
  said=$("${@:3}") || fail "$1: ${*:3} failed"
  grep -qxF -- "$2" <<< "$said" || fail "$1: '$2' expected of ${*:3}, which says: $said"
}
