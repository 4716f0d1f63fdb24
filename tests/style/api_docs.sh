#!/usr/bin/env bash
# Doxygen makes the API documentation without a warning, and every class, struct and enumeration of the public headers (common/,
# methods/registry.h, methods/NAME/NAME.h) has a comment. Exit status 77: Doxygen is not installed.
source "$(dirname "${BASH_SOURCE[0]}")/files.sh"
command -v doxygen >/dev/null || { echo "skipped: doxygen is not installed"; exit 77; }
made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT

# warnings SETTING...: of docs/Doxyfile with these settings, the paths as git has them.
warnings() {
  { cat docs/Doxyfile; printf '%s\n' "OUTPUT_DIRECTORY = $made" "$@"; } | doxygen - 2>&1 | sed "s|^$PWD/||"
}

found=$(warnings)
if [ -n "$found" ]; then fault "$found"$'\n'"  Doxygen warns of these comments"; fi

found=$(warnings EXTRACT_ALL=NO WARN_IF_UNDOCUMENTED=YES GENERATE_HTML=NO |
  grep -E '^(common/.*|methods/registry|methods/([a-z_]+)/\2)\.h:' | grep -E '(Compound .*|\(enumeration\) .*) is not documented' || true)
if [ -n "$found" ]; then fault "$found"$'\n'"  a public class, struct or enumeration has a comment (/// ...)"; fi
finish
