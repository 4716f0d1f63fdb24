# Sourced by run.sh and test.sh: installs what is missing, configures and builds the release preset.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export LC_ALL=C.UTF-8

say() { printf '\n== %s\n' "$*" >&2; }

as_root() {
  if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

is_there() {  # PACKAGE [COMMAND]
  if [ -n "${2:-}" ] && command -v "$2" >/dev/null 2>&1; then return 0; fi
  [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

install_packages() {
  local missing=() package command
  while read -r package command; do
    case "$package" in '' | '#'*) continue ;; esac
    is_there "$package" "$command" || missing+=("$package")
  done < packages.txt
  [ ${#missing[@]} -gt 0 ] || return 0
  say "installing ${missing[*]}"
  as_root apt-get update -q >&2
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}" >&2
}

install_node_modules() {
  local stamp=reports/node_modules/.package-lock.json
  if [ -f "$stamp" ] && [ ! reports/package-lock.json -nt "$stamp" ]; then return 0; fi
  say "installing the report's plot packages"
  (cd reports && npm ci --no-progress >&2)
  touch "$stamp"
}

build() {
  say "building (build/release)"
  cmake --preset release >&2
  cmake --build --preset release >&2
}

install_packages
install_node_modules
build
