#!/usr/bin/env bash
# Makes the references that come with the program anew, those of the study `quick`:
#   scenes/references/make.sh GIBENCH [SCENE ...]
# GIBENCH is the built program. About twenty minutes of two cores for all scenes. What it makes is kept in out/references, so that a call that
# was stopped goes on from there; the packed copies replace those in this folder.
set -euo pipefail

gibench=${1:?the program: scenes/references/make.sh build/release/bin/gibench}
shift
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
scenes=("$@")
if [ ${#scenes[@]} -eq 0 ]; then scenes=(cornell-box cornell-glossy thin-wall maze colonnade); fi

# The question of the study quick, at what the light of the surface is known to 0.5%; pixels have fewer paths.
question=(--surface-samples 2048 --pixel-samples 4 --width 256 --picture-samples "${PICTURE_SAMPLES:-64}")

# Light paths of methods that do not simulate all of them: what their model error is split off with, to 1%.
paths_of() {
  "$gibench" check "$1" --method "$2" | sed -n 's/^ *light paths \([^ ]*\)$/\1/p'
}

made() {
  GIBENCH_REFERENCES='' "$gibench" reference "$1" "${question[@]}" --references out/references --packed "$here" "${@:2}"
}

for scene in "${scenes[@]}"; do
  # An older one of another key would lie there unused. (grep fails where there is none.)
  { grep -l "\"scene\": \"$scene\"" "$here"/*/meta.json 2>/dev/null || true; } | while read -r old; do rm -r "$(dirname "$old")"; done
  made "$scene" --target-error 0.0045  # packing adds a tenth to it
  for paths in $(for method in meshless spectral antiradiance; do paths_of "$scene" "$method"; done | sort -u); do
    made "$scene" --target-error 0.009 --light-paths "$paths"
  done
done
