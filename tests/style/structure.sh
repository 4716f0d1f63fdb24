#!/usr/bin/env bash
# The house: size of files, and who includes whom.
source "$(dirname "${BASH_SOURCE[0]}")/files.sh"

longest=400  # lines

check_length() {
  while read -r file; do
    local lines
    lines=$(wc -l < "$file")
    if [ "$lines" -gt "$longest" ]; then fault "$file: $lines lines; a file holds one idea in at most $longest"; fi
  done < <(own_files | grep -E '\.(cpp|h|cmake|sh|js|mjs|css|html)$|CMakeLists\.txt$' | grep -v '^reports/vendor/')
}

# forbid WHERE PATTERN WHY [EXCEPT]: no source file under WHERE includes a path that matches.
forbid() {
  local found
  found=$(source_files | grep -E "^($1)" | grep -vE "^(${4:-$})" |
    xargs -r grep -nE "^[[:space:]]*#[[:space:]]*include[[:space:]]*[<\"]($2)" || true)
  if [ -n "$found" ]; then fault "$found"$'\n'"  $3"; fi
}

check_methods() {
  local folder name
  for folder in methods/*/; do
    name=$(basename "$folder")
    for other in methods/*/; do
      other=$(basename "$other")
      if [ "$other" != "$name" ]; then forbid "methods/$name/" "methods/$other/" "a method includes no other method"; fi
    done
  done
}

check_length
forbid 'common/' '(methods|bench|tests|scenes)/' "common knows no method, no program, no test"
forbid 'methods/' '(bench|tests|scenes)/' "methods know neither the program nor the tests"
forbid 'bench/' 'tests/' "the program knows no tests" 'bench/micro/'
forbid '(common|methods|bench|scenes|tests)/' 'embree' "only the ray backend sees Embree" 'common/ray/ray_backend\.cpp|bench/micro/'
forbid '(common|methods|bench|scenes|tests)/' 'OpenImageIO' "only common/image sees OpenImageIO" '(tests/)?common/image/'
forbid '(bench|reports|scenes)/' 'common/method/method\.h' "callers use a MethodSession, never a method itself"
check_methods

while read -r file; do
  if ! grep -q '^#pragma once' "$file"; then fault "$file: a header starts with #pragma once"; fi
  if ! head -n 1 "$file" | grep -q '^///'; then fault "$file: a header's first line says what it holds (/// ...)"; fi
done < <(source_files | grep '\.h$')
finish
