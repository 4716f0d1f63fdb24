#!/usr/bin/env bash
# Nothing left over, nothing of one machine, no turn of phrase that readers stumbled over: what no file of the project may hold.
source "$(dirname "${BASH_SOURCE[0]}")/files.sh"

texts() { own_files | grep -vE '^tests/style/words(_test)?\.sh$|^reports/vendor/|\.(png|exr|pdf|glb|ply|obj|bin|jpg)$'; }

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

# Plain English.
counted='marks?|bars?|rows?|files?|lines?|entry|entries|one|each|rays|paths|samples|bytes|kB|MB|values?|points?|numbers?'
counted+='|bits'
for_each='link|vertex|row|scene|pixel|sample|element|column|channel|slot|replicate|verb|face|node|cell|triangle|method|run|metric'
for_each+='|material|object|light|camera|frame|level|bin|chunk|thread|query|coordinate'
forbid "\b($counted) an? ($for_each)\b" "'per': one value per sample"
forbid '([^r]e|[^e[:space:]]|^) (is|are|was|were) no (text|number|record|picture|file|JSON|error|fault|expression|study|scene|name)\b' "'is not a'" '^docs/glossary\.md$'
forbid '\bthat (is|are) none\b|\bwhere it is none\b' "'unknown', or what it is not"
forbid '\b(is|are|was|were) told (here|there|in|by)\b|\bcannot be told\b' "'is reported'"
forbid '\b[Mm]end(s|ed|ing)?\b' "'how to fix it', 'remedy'"
forbid 'something else than' "'anything but', or what it should be"
forbid '\b(stands?|stood) twice\b' "'appears twice'"
forbid "\b[Ff]ormer's\b|calls for besides|found out besides|however fine it is|lived with|each by itself|[Pp]oison" "say it plainly"
forbid 'provably hold|[Ww]ithout an answer|absent, never zero' "say it plainly"
forbid '[[:space:]]+$' "blanks at the end of a line" '\.(json|ply|obj|mtl|svg|csv|golden)$'
finish
