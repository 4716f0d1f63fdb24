#!/usr/bin/env bash
# The installed program runs from a tree that was moved, without the folders of its sources and of its build.
source "$(dirname "${BASH_SOURCE[0]}")/installing.sh"

tree="$scratch/moved tree"
cmake --install "$build" --prefix "$scratch/first place" --component program > /dev/null
mv "$scratch/first place" "$tree"

# Nothing in it leads back.
found=$(grep -rIlF -e "$source/" -e "$build/" -e "$scratch" "$tree" || true)
[ -z "$found" ] || fail "$found"$'\n'"  names a folder of the build"
found=$(find "$tree" -type l)
[ -z "$found" ] || fail "$found"$'\n'"  is a link"
# (Sources are named by the messages of failed checks and by debug information.)
found=$(grep -aoF -e "$source/scenes" -e "$source/reports/page" -e "$source/reports/plots" -e "$build/share" -e "$build/bin" "$tree/bin/gibench" || true)
[ -z "$found" ] || fail "$found"$'\n'"  stands in bin/gibench"
found=$(readelf -d "$tree/bin/gibench" "$tree"/lib/gibench/*.so | grep -E '\((RPATH|RUNPATH)\)' | grep -F -e "$source" -e "$build" || true)
[ -z "$found" ] || fail "$found"$'\n'"  is a run path into the build"

# Where the system lets us, both folders are empty from here on.
hidden=()
if unshare --mount --map-root-user true 2>/dev/null; then
  hidden=(unshare --mount --map-root-user bash -c 'for one in "$0" "$1"; do mount -t tmpfs none "$one" 2>/dev/null; done
    exec "${@:2}"' "$build" "$source")
fi
gibench() { "${hidden[@]}" "$tree/bin/gibench" "$@"; }

mkdir "$scratch/elsewhere"
cd "$scratch/elsewhere"
expect "methods" pathtracer gibench list methods
expect "scenes" cornell-box gibench list scenes
gibench check cornell-box > /dev/null || fail "check cornell-box failed"
gibench run cornell-box --method pathtracer --set samples=1 --width 32 --surface-samples 64 --reference none --quiet --out out
for file in result.json image.exr log.txt; do [ -s "out/$file" ] || fail "run wrote no $file"; done

cat > small.study.json <<'JSON'
{ "gibench_study": 1, "name": "small", "scenes": ["cornell-box"], "methods": [{"method": "pathtracer", "parameters": {"samples": 1}}],
  "reference": {"samples": 1, "replicas": 8}, "surface_samples": 64, "pixel_samples": 1, "image_width": 16 }
JSON
gibench study small.study.json --out small --quiet
gibench report small --quiet 2> report.log || fail "$(cat report.log)"$'\n'"report failed"
[ -s small/report/index.html ] || fail "there is no report"
echo "no faults"
