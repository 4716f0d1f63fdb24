# Sourced by the tests of the style checks: a scratch tree that holds the check named by `checked`.
set -euo pipefail
own=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
mkdir -p "$tree/tests/style"
cp "$own/files.sh" "$own/$checked.sh" "$tree/tests/style/"

check() { bash "$tree/tests/style/$checked.sh" 2>&1; }

# breach EXPECTED: the check fails and says EXPECTED; then the tree is made anew by fresh().
breach() {
  local said
  if said=$(check) || [[ $said != *"$1"* ]]; then
    printf '"%s" expected, but it said: %s\n' "$1" "$said" >&2
    exit 1
  fi
  fresh
}

# pass WHAT: the tree as fresh() makes it is not blamed.
pass() {
  local said
  fresh
  if ! said=$(check); then
    printf '%s blamed: %s\n' "$1" "$said" >&2
    exit 1
  fi
}
