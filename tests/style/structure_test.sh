#!/usr/bin/env bash
# structure.sh must pass a house in order and fail on each breach of a rule, seeded into a scratch tree.
checked=structure
source "$(dirname "${BASH_SOURCE[0]}")/scratch_tree.sh"
mkdir -p "$tree"/{common/{core,ray,method},methods/{one,other},bench/{app,measure,micro,record,study},reports/tables}
faults=0

# breach FILE EXPECTED LINE...: a file of these lines makes the check fail with EXPECTED in what it says.
breach() {
  local file=$1 expected=$2 said
  shift 2
  mkdir -p "$(dirname "$tree/$file")"
  printf '%s\n' "$@" > "$tree/$file"
  if said=$(check); then
    printf 'not seen: %s: %s\n' "$file" "$*" >&2
    faults=$((faults + 1))
  elif [[ $said != *"$expected"* ]]; then
    printf '%s: "%s" expected, but it said: %s\n' "$file" "$expected" "$said" >&2
    faults=$((faults + 1))
  fi
  rm "$tree/$file"
  find "$tree" -mindepth 2 -type d -empty -path '*unknown*' -delete
}

header() { printf '/// A header.\n#pragma once\n%s\n' "$2" > "$tree/$1"; }

header common/core/a.h '#include <vector>'
header common/method/a.h '#include "common/core/a.h"'
header methods/one/a.h '#include "common/method/a.h"'
header bench/record/a.h '#include "common/method/a.h"'
header bench/measure/a.h '#include "methods/one/a.h"'
header bench/study/a.h '#include "bench/measure/a.h"'
header bench/app/a.h '#include <CLI/CLI.hpp>'
header bench/micro/a.h '#include "methods/one/a.h"'
header reports/tables/a.h '#include "bench/record/a.h"'
if ! said=$(check); then
  printf 'a house in order was blamed: %s\n' "$said" >&2
  exit 1
fi

breach common/core/b.cpp "stands below what it includes" '#include "common/method/a.h"'
breach common/ray/b.cpp "stands below what it includes" '#  include "common/lighting/a.h"'
breach common/unknown/b.cpp "has no place in the order" '#include <vector>'
breach common/core/b.cpp "common knows no method" '#include "methods/one/a.h"'
breach common/core/b.cpp "common knows no method" '#include "reports/tables/a.h"'
breach methods/one/b.cpp "a method includes no other method" '#include "methods/other/a.h"'
breach methods/one/b.cpp "methods know neither the program" '#include "bench/record/a.h"'
breach bench/record/b.cpp "records see only common" '#include "methods/one/a.h"'
breach bench/record/b.cpp "records see only common" '#include "bench/measure/a.h"'
breach bench/measure/b.cpp "measuring sees only" '#include "bench/study/a.h"'
breach bench/measure/b.cpp "measuring sees only" '#include "bench/app/a.h"'
breach bench/study/b.cpp "studies see only" '#include "bench/app/a.h"'
breach bench/study/b.cpp "studies see only" '#include "methods/registry.h"'
breach bench/study/b.cpp "studies see only" '#include "reports/tables/a.h"'
breach bench/micro/b.cpp "micro-benchmarks see only" '#include "bench/measure/a.h"'
breach bench/micro/b.cpp "the program knows no tests" '#include "tests/support/a.h"'
breach reports/tables/b.cpp "reports see only" '#include "bench/study/a.h"'
breach reports/tables/b.cpp "reports see only" '#include "methods/registry.h"'
breach examples/new_method/b.cpp "examples see only what is installed" '#include "methods/registry.h"'
breach examples/new_method/b.cpp "examples see only what is installed" '#include "bench/app/verbs.h"'
breach bench/record/CMakeLists.txt "records see only common" 'gibench_library(record LIBRARIES gibench_methods)'
breach bench/measure/CMakeLists.txt "measuring sees only" 'gibench_library(measure LIBRARIES gibench_app)'
breach bench/study/CMakeLists.txt "studies see only" 'target_link_libraries(gibench_study PUBLIC gibench_methods)'
breach bench/micro/CMakeLists.txt "micro-benchmarks see only" 'target_link_libraries(x PUBLIC gibench_test_support)'
breach reports/CMakeLists.txt "reports see only" 'target_link_libraries(gibench_report PUBLIC gibench_study)'
breach bench/measure/b.cpp "sees the command line" '#include <CLI/CLI.hpp>'
breach bench/study/b.cpp "touches signals" '#include <csignal>'
breach bench/measure/b.cpp "touches signals" '#include <sys/prctl.h>'
breach bench/study/child_process.cpp "touches signals" 'void listen() { sigaction(2, nullptr, nullptr); }'
breach methods/one/b.cpp "sees Embree" '#include <embree4/rtcore.h>'
breach common/core/b.cpp "sees OpenImageIO" '#include <OpenImageIO/imageio.h>'
breach common/core/b.h "#pragma once" '/// A header without a guard.'
breach common/core/b.h "first line says what it holds" '#pragma once'
breach common/core/b.h "first line names what it holds" '/// What a run holds.' '#pragma once'
breach common/core/b.h "first line names what it holds" '/// Whether a run ended.' '#pragma once'
breach common/lighting/b.cpp "through the interface of the ray backends" '#include "common/ray/embree/embree_backend.h"'
breach common/ray/embree/b.cpp "a backend knows rays and triangles" '#include "common/ray/world.h"'
breach methods/one/b.cpp "processor's own instructions" '#include <immintrin.h>'
breach common/scene/b.cpp "sees Assimp" '#include <assimp/scene.h>'
breach common/scene/b.cpp "sees Valijson" '#include <valijson/schema.hpp>'
breach bench/measure/b.cpp "callers use a MethodSession" '#include "common/method/method.h"'
breach common/lighting/b.cpp "a new kind does not compile" 'bool is_point(const Light& light) { return std::holds_alternative<PointLight>(light); }'
breach bench/measure/b.cpp "a new kind does not compile" 'const Light& after(const SceneEdit& edit) { return std::get<LightEdit>(edit).after; }'
breach bench/measure/b.cpp "a new kind does not compile" 'double number(const Value& value) { return std::get<std::int64_t>(value); }'
mapfile -t lines < <(seq 401)
breach common/core/b.cpp "longer than 400 lines" "${lines[@]}"

if [ "$faults" -gt 0 ]; then
  printf '%d faults\n' "$faults" >&2
  exit 1
fi
printf 'every breach was seen\n'
