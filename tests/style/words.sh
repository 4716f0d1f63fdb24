#!/usr/bin/env bash
# Nothing left over, nothing of one machine: words and paths that no file of the project may hold.
source "$(dirname "${BASH_SOURCE[0]}")/files.sh"

texts() { own_files | grep -vE '^tests/style/words\.sh$|\.(png|exr|pdf|glb|ply|obj|bin|jpg)$'; }

# forbid PATTERN WHY [EXCEPT]: case matters; EXCEPT drops files.
forbid() {
  local found
  found=$(texts | grep -vE "${3:-^$}" | xargs -r grep -nIE "$1" | cut -c 1-200 || true)
  if [ -n "$found" ]; then fault "$found"$'\n'"  $2"; fi
}

forbid '\b(TODO|FIXME|HACK|XXX|WIP)\b' "finish it, or file it"
forbid '(^|[^[:alnum:]_./-])/(work|root|home|tmp)(/|\b)' "a path of one machine"
forbid '"resolved":' "the lock file names no host: npm config set omit-lockfile-registry-resolved true" '^tests/'
forbid '(registry\.npmjs|npmjs\.org|deb\.debian\.org|proxy\.golang)' "no registry is named"
forbid '<{7}|>{7}' "a merge left open"
forbid '^[[:space:]]*//[^/].*[=(].*;[[:space:]]*$' "code in a comment" '\.(md|json|html|js|mjs|css)$'
forbid '[[:space:]]+$' "blanks at the end of a line" '\.(json|ply|obj|mtl|svg|csv|golden)$'
finish
