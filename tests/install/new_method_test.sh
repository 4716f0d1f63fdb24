#!/usr/bin/env bash
# A method in a project of its own, as the README says: installed package, build, contract, run.
source "$(dirname "${BASH_SOURCE[0]}")/installing.sh"

# What the README's commands take for granted: a clone that was built, a home.
mkdir -p "$scratch/clone/build" "$scratch/home"
ln -s "$build" "$scratch/clone/build/release"
cp -r "$source/examples" "$scratch/clone/"
export HOME="$scratch/home" CTEST_OUTPUT_ON_FAILURE=1
cd "$scratch/clone"
run_readme_block 1
[ -s out/box/image.exr ] || fail "the README's run wrote no picture"

# Each header that is installed finds the headers that it names.
headers=$HOME/gibench/include/gibench
missing=$(cd "$headers" && grep -rhoE '^#include "[^"]+"' . | sort -u | cut -d '"' -f 2 |
  while read -r header; do [ -f "$header" ] || echo "$header"; done)
[ -z "$missing" ] || fail "$missing"$'\n'"  is included by installed headers and not installed"
found=$(grep -rIlF -e "$source/" -e "$build/" "$HOME/gibench" || true)
[ -z "$found" ] || fail "$found"$'\n'"  names a folder of the build"

# The program beside that of the package, which was moved: by its own place it finds the scenes.
cmake --install my_method/build --prefix "$HOME/gibench" > /dev/null
mv "$HOME/gibench" "$scratch/moved"
gibench=$scratch/moved/bin/gibench-gathering
rm -r my_method
expect "the built-in methods" meshless "$gibench" list methods
expect "the new method" gathering "$gibench" list methods
run() { "$gibench" run cornell-box --method gathering --set rays="$1" --width 32 --surface-samples 64 --reference none "${@:2}"; }
run 1 --quiet --out small
grep -q '"method": *"gathering"' small/result.json || fail "small/result.json does not name the method"
[ -s small/image.exr ] || fail "run wrote no picture"
if said=$(run 0 2>&1); then fail "rays=0 was taken"; fi
[[ $said == *rays* ]] || fail "the refusal of rays=0 does not name it: $said"
echo "no faults"
