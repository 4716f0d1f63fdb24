#!/usr/bin/env bash
# words.sh must pass a clean text and fail on each word and phrase that it forbids, seeded into a scratch tree.
checked=words
source "$(dirname "${BASH_SOURCE[0]}")/scratch_tree.sh"
mkdir -p "$tree/docs"
faults=0

blame() {
  printf '%s\n' "$*" >&2
  faults=$((faults + 1))
}

printf '%s\n' 'One value per sample. There is no file of this name; the text is not JSON, and each sample has a scene.' \
  'Four rays per vertex recommend themselves.' > "$tree/docs/page.md"
if ! said=$(check); then blame "a clean text was blamed: $said"; fi

# Each line breaks one rule: all are written, and each has to be named.
cat > "$tree/docs/page.md" <<'LINES'
TODO: the rest
see /home/somebody/notes
"resolved": "https://somewhere"
fetched from deb.debian.org
<<<<<<< ours
  // total = 1;
rays a link, in radiosity mode
a small mark a scene, a bar for the geometric mean
one value a vertex and channel
not a row a scene
what is no text
this file is no study
a name that is none
what numerics do is told here, never thrown
what cannot be told is omitted
what, where, the mend
Mend with clang-format
holds something else than a study
the key stands twice
the same on the former's basis
what the scene calls for besides
what was found out besides
is wrong by that light however fine it is made
counted and lived with
does so for the light of 0 to N reflections each by itself
the session checks, times, counts and poisons
bounces that provably hold less than the share T
Without an answer
What was not measured is absent, never zero
LINES
sed 's/^/a blank at the end: /; s/$/ /' <<< 'this line' >> "$tree/docs/page.md"
cp "$tree/docs/page.md" "$tree/docs/page.h"  # code in comments is a matter of sources
if said=$(check); then blame "no breach was seen"; fi
number=0
while IFS= read -r line; do
  number=$((number + 1))
  if [[ $said != *"docs/page.h:$number:$line"* ]]; then blame "not seen: $line"; fi
done < "$tree/docs/page.h"

if [ "$faults" -gt 0 ]; then
  printf '%d faults\n' "$faults" >&2
  exit 1
fi
printf 'every breach was seen\n'
