#!/usr/bin/env bash
# The same labels and map, bit for bit, of two builds on 1, 2 and 8 threads: with ROS and without, as scripts/test.sh
# makes them, or any two programs, of an unoptimised build for one. (The nodelet beside the command line: ctest -R flow.)
# Usage: determinism.sh [STILLMAP OTHER_STILLMAP]
set -euo pipefail
cd "$(dirname "$0")/.."
first=${1:-build/devel/lib/stillmap/stillmap} second=${2:-build_core/devel/lib/stillmap/stillmap}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# Each line: all labels and the map of a run, as one checksum. Times are in summary.json.
label() {
  local stillmap=$1 sequence=$2 threads=$3
  rm -rf "$folder/out"
  "$stillmap" label "$folder/$sequence" "$folder/out" --delay 2 --threads "$threads" >/dev/null
  (cd "$folder/out" && find . -type f ! -name summary.json | sort | xargs sha256sum | sha256sum | cut -c 1-16)
}

different=0
for world in "street vlp16" "orchard livox"; do
  read -r scene sensor <<<"$world"
  "$first" simulate "$scene" "$folder/$scene" --sensor "$sensor" --scans 6 >/dev/null
  expected=$(label "$first" "$scene" 1)
  for build in first second; do
    for threads in 1 2 8; do
      sum=$(label "${!build}" "$scene" "$threads")
      printf '%-8s %-6s %d threads  %s\n' "$scene" "$build" "$threads" "$sum"
      if [ "$sum" != "$expected" ]; then different=$((different + 1)); fi
    done
  done
done
if [ $different -gt 0 ]; then
  echo "determinism.sh: $different runs differ from the first on 1 thread" >&2
  exit 1
fi
