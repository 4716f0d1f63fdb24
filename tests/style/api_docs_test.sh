#!/usr/bin/env bash
# api_docs.sh must pass documented headers and fail on each breach of its rules, seeded into a scratch tree.
command -v doxygen >/dev/null || { echo "skipped: doxygen is not installed"; exit 77; }
checked=api_docs
source "$(dirname "${BASH_SOURCE[0]}")/scratch_tree.sh"
mkdir -p "$tree"/{common/core,docs,methods/one}
cp "$own/../../docs/Doxyfile" "$tree/docs/"
printf '# The library\n\nStart with `common/core/a.h`.\n' > "$tree/docs/api.md"

put() { printf '%s\n' '/// A header.' '#pragma once' '' "${@:2}" > "$tree/$1"; }
fresh() {
  put common/core/a.h '/// A pair.' 'struct Pair {' '  int first, second;  ///< both counted' '};' 'int sum(const Pair& pair);'
  put methods/one/one.h 'int one_entry();'
  put methods/one/inside.h 'struct Inside {};'
}

pass 'documented headers were'
put common/core/a.h '/// A sum of <RD> events.' 'int sum(int a);'
breach 'common/core/a.h:4: warning: Unsupported xml/html tag <RD>'
put common/core/a.h '/// Twice a number.' '/// @param b the number' 'int twice(int a);'
breach "argument 'b' of command @param is not found"
put common/core/a.h 'struct Pair {' '  int first, second;' '};'
breach 'Compound Pair is not documented'
put methods/one/one.h 'enum class Kind { a, b };'
breach 'methods/one/one.h:4: warning: Member Kind (enumeration)'
printf 'every breach was seen\n'
