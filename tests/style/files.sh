# Sourced by the style checks: lists the project's own files, one per line, from the project's folder.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
export LC_ALL=C.UTF-8

# Every file that belongs to the project: what git knows or would add, or all but the made ones where git is absent.
own_files() {
  if git rev-parse --is-inside-work-tree >/dev/null 2>&1; then
    git ls-files --cached --others --exclude-standard | while read -r file; do if [ -f "$file" ]; then echo "$file"; fi; done
  else
    find . \( -name .git -o -name build -o -name out -o -name node_modules \) -prune -o -type f -print | sed 's|^\./||' | sort
  fi
}

source_files() { own_files | grep -E '\.(cpp|h)$' || true; }

faults=0
fault() {
  printf '%s\n' "$*" >&2
  faults=$((faults + 1))
}
finish() {
  if [ "$faults" -gt 0 ]; then
    printf '%d faults\n' "$faults" >&2
    exit 1
  fi
  printf 'no faults\n'
}
