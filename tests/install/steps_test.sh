#!/usr/bin/env bash
# A method in the tree, as the README says: its steps on a copy of the methods, linked with the libraries that are built. And
# what the README's section names is there.
source "$(dirname "${BASH_SOURCE[0]}")/installing.sh"

section=$(awk '/^## / { inside = /^## A new method$/ } inside' "$source/README.md")
missing=$(grep -oE '`[a-z_]+/[A-Za-z0-9_./]*`' <<< "$section" | tr -d '`' | sort -u |
  while read -r path; do case $path in *NAME* | build/*) ;; *) [ -e "$source/$path" ] || echo "$path" ;; esac; done)
[ -z "$missing" ] || fail "$missing"$'\n'"  is named by README.md, A new method, and not there"

cmake --install "$build" --prefix "$scratch/gibench" --component development > /dev/null
mkdir "$scratch/tree"
cd "$scratch/tree"
cp -r "$source/methods" "$source/examples" "$source/tests/install/steps/CMakeLists.txt" .
for folder in methods/*/; do  # those that are there are not built a second time
  name=$(basename "$folder")
  echo "add_library(gibench_$name ALIAS gibench::$name)" > "$folder/CMakeLists.txt"
done
run_readme_block 2
{
  cmake -B build -D CMAKE_PREFIX_PATH="$scratch/gibench" -D GIBENCH_SOURCE="$source" && cmake --build build
} > log 2>&1 || fail "$(cat log)"$'\n'"README.md, A new method: the tree does not build after these steps"
expect "the new method" gathering build/gibench list methods
expect "the others" meshless build/gibench list methods
build/gibench list methods gathering | grep -q rays || fail "the new method's parameters are not listed"
echo "no faults"
