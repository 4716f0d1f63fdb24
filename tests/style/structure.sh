#!/usr/bin/env bash
# The house: size of files, and who includes whom.
source "$(dirname "${BASH_SOURCE[0]}")/files.sh"

all_files=$(own_files)
own_files() { printf '%s\n' "$all_files"; }  # looked up once
all_includes=$(source_files | xargs -r grep -nE '^[[:space:]]*#[[:space:]]*include\b' /dev/null || true)  # FILE:LINE:DIRECTIVE
all_links=$(own_files | grep -E '(^|/)CMakeLists\.txt$' | xargs -r grep -nE 'gibench_' /dev/null || true)  # FILE:LINE:LIBRARIES

longest=400  # lines
# The folders of common/ from the ground to the roof: each includes only itself and those before it.
common_order=(core json image light_paths scene scene_io metrics reference reflectance ray geometry lighting effects
  finite_elements method spaces)

check_length() {
  local found
  found=$(own_files | grep -E '\.(cpp|h|cmake|sh|js|mjs|css|html)$|CMakeLists\.txt$' | grep -v '^reports/vendor/' |
    xargs -r awk -v longest=$longest 'FNR == longest + 1 { print FILENAME }')
  if [ -n "$found" ]; then fault "$found"$'\n'"  longer than $longest lines; a file holds one idea"; fi
}

check_headers() {
  local found
  found=$(source_files | grep '\.h$' | xargs -r grep -L '^#pragma once' || true)
  if [ -n "$found" ]; then fault "$found"$'\n'"  a header starts with #pragma once"; fi
  found=$(source_files | grep '\.h$' | xargs -r awk 'FNR == 1 && !/^\/\/\// { print FILENAME }')
  if [ -n "$found" ]; then fault "$found"$'\n'"  a header's first line says what it holds (/// ...)"; fi
  found=$(source_files | grep '\.h$' | xargs -r awk 'FNR == 1 && /^\/\/\/ (What|Which|How|Where|Whether|Why|When|Who)[ ,:]/ { print FILENAME ": " $0 }')
  if [ -n "$found" ]; then fault "$found"$'\n'"  a header's first line names what it holds: 'The end of a run', not 'How a run ended'"; fi
}

# forbid WHERE PATTERN WHY [EXCEPT]: no source file under WHERE includes a path that matches.
forbid() {
  local found
  found=$(grep -E "^($1)[^:]*:[0-9]+:[[:space:]]*#[[:space:]]*include[[:space:]]*[<\"]($2)" <<< "$all_includes" || true)
  if [ -n "${4:-}" ]; then found=$(grep -vE "^($4)" <<< "$found" || true); fi
  if [ -n "$found" ]; then fault "$found"$'\n'"  $3"; fi
}

# sees WHERE ALLOWED WHY: what a source file under WHERE includes of the project matches ALLOWED.
sees() {
  local found
  found=$(grep -E "^$1/[^:]*:[0-9]+:[[:space:]]*#[[:space:]]*include[[:space:]]*\"[a-z]+/" <<< "$all_includes" |
    grep -vE "include[[:space:]]*\"($2)" || true)
  if [ -n "$found" ]; then fault "$found"$'\n'"  $3"; fi
}

# links WHERE FORBIDDEN WHY: no CMakeLists.txt under WHERE names a library gibench_… that matches.
links() {
  local found
  found=$(grep -E "^$1/.*gibench_($2)\b" <<< "$all_links" || true)
  if [ -n "$found" ]; then fault "$found"$'\n'"  $3"; fi
}

check_methods() {
  local folder other
  for folder in methods/*/; do
    for other in methods/*/; do
      if [ "$other" != "$folder" ]; then forbid "$folder" "$other" "a method includes no other method"; fi
    done
  done
}

check_common() {
  local folder i later IFS='|'
  for folder in common/*/; do
    folder=${folder#common/} folder=${folder%/}
    if [[ "|${common_order[*]}|" != *"|$folder|"* ]]; then
      fault "common/$folder: has no place in the order of common/ (common_order in tests/style/structure.sh, docs/architecture.md)"
    fi
  done
  for ((i = 0; i + 1 < ${#common_order[@]}; ++i)); do
    later=${common_order[*]:i+1}
    forbid "common/${common_order[i]}/" "common/($later)/" "common/${common_order[i]} stands below what it includes"
  done
}

check_rooms() {
  sees bench/record '(bench/record|common)/' "records see only common"
  sees bench/measure '(bench/(measure|record)|methods|common)/' "measuring sees only records, methods and common"
  sees bench/study '(bench/(study|measure|record)|common)/' "studies see only measuring, records and common"
  sees bench/micro '(bench/micro|methods|common)/' "micro-benchmarks see only methods and common"
  sees reports '(reports|bench/record|common)/' "reports see only records and common"
  sees examples '(common/|bench/app/program\.h"|tests/contract/contract\.h"|methods/gathering/)' "examples see only what is installed"
  links bench/record '(methods|pathtracer|meshless|spectral|antiradiance|measure|study|app|report)' "records see only common"
  links bench/measure '(study|app|report)' "measuring sees only records, methods and common"
  links bench/study '(methods|app|report)' "studies see only measuring, records and common"
  links bench/micro '(app|study|measure|record|report|test_[a-z]+)' "micro-benchmarks see only methods and common"
  links reports '(methods|measure|study|app)' "reports see only records and common"
}

# Signals are the program's: what lies below asks whether it is to stop. The process executor ends its children.
check_signals() {
  local found
  forbid '(common|methods|bench|reports|scenes)/' '(csignal|signal\.h|sys/prctl\.h)' "only bench/app touches signals" \
    'bench/app/|bench/study/child_process\.cpp'
  found=$(source_files | grep -E '^(common|methods|bench|reports|scenes)/' | grep -v '^bench/app/' |
    xargs -r grep -nE '\b(sigaction|sigprocmask|pthread_sigmask|prctl|signal)[[:space:]]*\(' /dev/null || true)
  if [ -n "$found" ]; then fault "$found"$'\n'"  only bench/app touches signals"; fi
}

# One kind picked out of a variant leaves the others unseen, and a new one forgotten: visit all of them.
check_visits() {
  local found
  found=$({ source_files | xargs -r grep -nE 'std::(get_if|holds_alternative)<' /dev/null
    # A test may insist on a kind by std::get, which throws for any other.
    source_files | grep -v '^tests/' | xargs -r grep -nE 'std::get<([A-Z][A-Za-z]|[a-z]+::)' /dev/null; } || true)
  if [ -n "$found" ]; then fault "$found"$'\n'"  std::visit with Overloaded (common/core/overloaded.h), so that a new kind does not compile"; fi
}

check_length
check_headers
forbid 'common/' '(methods|bench|reports|tests|scenes)/' "common knows no method, no program, no test"
forbid 'methods/' '(bench|reports|tests|scenes)/' "methods know neither the program nor the tests"
forbid '(bench|reports)/' 'tests/' "the program knows no tests"
forbid '(common|methods|bench|reports|scenes|tests)/' 'CLI/' "only bench/app sees the command line" 'bench/app/'
forbid '(common|methods|bench|reports|scenes|tests)/' 'embree' "only the Embree backend sees Embree" \
  'common/ray/embree/|bench/micro/bare_embree\.cpp'
forbid '(common|methods|bench|reports|scenes|tests)/' 'common/ray/embree/' "rays go through the interface of the ray backends" \
  'common/ray/embree/|common/ray/(world|coplanar_pairs)\.cpp|tests/common/ray/'
forbid 'common/ray/embree/' 'common/ray/(ray_stream|world)' "a backend knows rays and triangles, not worlds"
forbid '(common|methods|bench|reports|scenes|tests)/' '[a-z]mmintrin' "only common/core sees the processor's own instructions" 'common/core/'
forbid '(common|methods|bench|reports|scenes|tests)/' 'assimp/' "only common/scene_io/assimp sees Assimp" \
  'common/scene_io/assimp/|scenes/generators/'
forbid '(common|methods|bench|reports|scenes|tests)/' 'valijson/' "only common/json sees Valijson" 'common/json/'
forbid '(common|methods|bench|reports|scenes|tests)/' 'OpenImageIO' "only common/image sees OpenImageIO" '(tests/)?common/image/'
forbid '(bench|reports|scenes)/' 'common/method/method\.h' "callers use a MethodSession, never a method itself"
check_common
check_rooms
check_signals
check_methods
check_visits
finish
