#!/usr/bin/env bash
# pairs.sh must pass a house in order and fail on each breach of its rules, seeded into a scratch tree.
checked=pairs
source "$(dirname "${BASH_SOURCE[0]}")/scratch_tree.sh"
mkdir -p "$tree/common"

put() { printf '%s\n' "${@:2}" > "$tree/common/$1"; }
fresh() {  # a.h declares, a.cpp defines; b.h stands by itself; c_schema.cpp.in is made into a source
  rm -f "$tree"/common/*
  put a.h '/// A.' '#pragma once' '#include "common/b.h"' 'int of(int, // one' '       int);' 'inline int twice(int x) { return 2 * x; }' \
    'struct Point {' '  int x() const;' '};' 'const char* schema_text();'
  put a.cpp '#include "common/a.h"' 'int of(int a,' '       int b) { return a + b; }' 'int Point::x() const { return 1; }'
  put b.h '/// B.' '#pragma once'
  put c_schema.cpp.in 'const char* schema_text() {' '}'
  put some_test.cpp 'int main() {}'
}

pass 'a house in order was'
put d.cpp 'int lonely() { return 1; }'
breach 'common/d.cpp: has no header of its name'
put b.h '/// B.' '#pragma once' 'std::string' 'name_of(int);'
breach 'common/b.h: name_of() is not defined in common/b.cpp'
put a.cpp '#include "common/a.h"'
breach 'common/a.h: of() is not defined in common/a.cpp'
put b.h '/// B.' '#pragma once' '#include "common/a.h"'
breach 'common/a and common/b include one another'
put b.cpp '#include "common/a.h"'
breach 'common/a and common/b include one another'
printf 'every breach was seen\n'
