#!/usr/bin/env bash
# words.sh must pass a clean text and fail on each word and phrase that it forbids, seeded into a scratch tree.
set -euo pipefail
own=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
mkdir -p "$tree"/{common,docs,tests/style}
cp "$own/files.sh" "$own/words.sh" "$tree/tests/style/"
faults=0

check() { bash "$tree/tests/style/words.sh" 2>&1; }

# breach EXPECTED LINE: a page with this line makes the check fail with EXPECTED in what it says.
breach() {
  local said
  printf '%s\n' "$2" > "$tree/docs/page.md"
  if said=$(check) || [[ $said != *"$1"* ]]; then
    printf '"%s" expected of "%s", but it said: %s\n' "$1" "$2" "$said" >&2
    faults=$((faults + 1))
  fi
  rm "$tree/docs/page.md"
}

printf '%s\n' 'One value per sample. There is no file of this name; the text is not JSON, and each sample has a scene.' \
  'Four rays per vertex recommend themselves.' > "$tree/docs/clean.md"
if ! said=$(check); then
  printf 'a clean text was blamed: %s\n' "$said" >&2
  exit 1
fi
breach 'finish it' 'TODO: the rest'
breach 'path of one machine' 'see /home/somebody/notes'
breach 'merge left open' '<<<<<<< ours'
breach 'blanks at the end' 'a line '
while read -r line; do breach "'per'" "$line"; done <<'LINES'
rays a link, in radiosity mode
a small mark a scene, a bar for the geometric mean
one value a vertex and channel
not a row a scene
LINES
breach "'is not a'" 'what is no text'
breach "'is not a'" 'this file is no study'
breach "'unknown'" 'a name that is none'
breach "'is reported'" 'what numerics do is told here, never thrown'
breach "'is reported'" 'what cannot be told is absent'
breach "'remedy'" 'what, where, the mend'
breach "'remedy'" 'Mend with clang-format'
breach "'anything but'" 'holds something else than a study'
breach "'appears twice'" 'the key stands twice'
while read -r line; do breach 'say it plainly' "$line"; done <<'LINES'
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

if [ "$faults" -gt 0 ]; then
  printf '%d faults\n' "$faults" >&2
  exit 1
fi
printf 'every breach was seen\n'
