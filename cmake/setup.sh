# Sourced by run.sh and test.sh: installs what is missing, configures and builds. Afterwards $build is the build folder.
#   GIBENCH_PRESET  the preset of CMakePresets.json to build; default: release
#   GIBENCH_BUILD   where build folders are made; default: build/ in the source folder
set -euo pipefail
export LC_ALL=C.UTF-8
invoked_from=$PWD
build_root=${GIBENCH_BUILD:+$(realpath -m "$GIBENCH_BUILD")}
cd -P "$(dirname "${BASH_SOURCE[0]}")/.."

preset=${GIBENCH_PRESET:-release}
build_root=${build_root:-$PWD/build}
build=$build_root/$preset

say() { printf '\n== %s\n' "$*" >&2; }
stop() {
  printf 'gibench: %s\n' "$*" >&2
  exit 2
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

is_there() {  # PACKAGE [COMMAND]
  if [ -n "${2:-}" ] && command -v "$2" >/dev/null 2>&1; then return 0; fi
  [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

install_packages() {
  local missing=() package command
  # Another distribution: CMake names what is missing, with the names that Debian gives it.
  command -v dpkg-query >/dev/null 2>&1 || return 0
  while read -r package command; do
    case "$package" in '' | '#'*) continue ;; esac
    is_there "$package" "$command" || missing+=("$package")
  done < packages.txt
  [ ${#missing[@]} -gt 0 ] || return 0
  if [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null 2>&1; then
    stop "packages are missing and there is no sudo; as root: apt-get install --no-install-recommends ${missing[*]}"
  fi
  say "installing ${missing[*]}"
  as_root apt-get update -q >&2 || say "the list of packages could not be brought up to date; going on with the old one"
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}" >&2 ||
    stop "apt-get could not install ${missing[*]}: install them by hand, then call this again"
}

# A folder that can be written, with a way out where it cannot.
make_build_folder() {
  mkdir -p "$build" 2>/dev/null && [ -w "$build" ] ||
    stop "$build cannot be written: name a folder that can with GIBENCH_BUILD=FOLDER"
}

configure() {
  local fresh=()
  # A build folder knows its sources by their absolute path: one that was moved or copied is configured anew.
  if [ -f "$build/CMakeCache.txt" ] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" "$build/CMakeCache.txt"; then
    fresh=(--fresh)
  fi
  rm -f "$build/stopped.txt"
  say "configuring ($build)"
  cmake --preset "$preset" -B "$build" "${fresh[@]}" >&2 ||
    stop "$(cat "$build/stopped.txt" 2>/dev/null || echo "CMake could not configure $build: its first error above says why")"
}

install_node_modules() {
  local reports=$build/share/gibench/reports
  local stamp=$reports/node_modules/.package-lock.json
  if [ -f "$stamp" ] && [ ! "$reports/package-lock.json" -nt "$stamp" ]; then return 0; fi
  say "installing the report's plot packages"
  # Packages of an earlier build serve without a network, and where there is none npm gives up within half a minute.
  if (cd "$reports" && npm ci --prefer-offline --fetch-retry-maxtimeout=10000 --no-progress --no-audit --no-fund >&2); then
    touch "$stamp"
  else
    say "npm could not install the plot packages (no network?): reports will have no plots until 'npm ci' works in $reports"
  fi
}

build_all() {
  say "building ($build)"
  cmake --build "$build" >&2 || stop "the build failed: the first error above says where"
}

# The cores and the memory of this machine, or of this container where its control group allows less.
usable_cores() {
  local cores quota period
  cores=$(nproc)
  if [ -r /sys/fs/cgroup/cpu.max ]; then  # control groups of version 2, then of version 1
    read -r quota period < /sys/fs/cgroup/cpu.max
  elif [ -r /sys/fs/cgroup/cpu/cpu.cfs_quota_us ]; then
    quota=$(< /sys/fs/cgroup/cpu/cpu.cfs_quota_us)
    period=$(< /sys/fs/cgroup/cpu/cpu.cfs_period_us)
  fi
  case ${quota:-max} in max | -*) ;; *) if [ $((quota / period)) -lt "$cores" ]; then cores=$((quota / period)); fi ;; esac
  echo "$cores"
}

usable_memory_mib() {
  local memory limit file
  memory=$(awk '/^MemAvailable:/ {print int($2 / 1024)}' /proc/meminfo)
  memory=${memory:-1024}
  for file in /sys/fs/cgroup/memory.max /sys/fs/cgroup/memory/memory.limit_in_bytes; do
    if [ -r "$file" ]; then
      limit=$(< "$file")
      if [ "$limit" != max ] && [ $((limit / 1048576)) -lt "$memory" ]; then memory=$((limit / 1048576)); fi
    fi
  done
  echo "$memory"
}

# The cores, as far as memory goes round: a test takes up to a gigabyte.
test_jobs() {
  local cores jobs
  cores=$(usable_cores)
  jobs=$(($(usable_memory_mib) / 1024))
  if [ "$jobs" -gt "$cores" ]; then jobs=$cores; fi
  if [ "$jobs" -lt 1 ]; then jobs=1; fi
  echo "$jobs"
}

install_packages
make_build_folder
configure
install_node_modules
build_all
