#!/usr/bin/env bash
# The same labels and map, bit for bit: of an optimised build with ROS and an unoptimised one without, on 1, 2 and 8
# threads. scripts/test.sh makes both builds. (The nodelet beside the command line: ctest -R flow.)
# Usage: determinism.sh [OPTIMISED_STILLMAP UNOPTIMISED_STILLMAP]
set -euo pipefail
cd "$(dirname "$0")/.."
optimised=${1:-build/devel/lib/stillmap/stillmap} unoptimised=${2:-build_core/devel/lib/stillmap/stillmap}
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
  "$optimised" simulate "$scene" "$folder/$scene" --sensor "$sensor" --scans 6 >/dev/null
  first=$(label "$optimised" "$scene" 1)
  for build in optimised unoptimised; do
    for threads in 1 2 8; do
      sum=$(label "${!build}" "$scene" "$threads")
      printf '%-8s %-12s %d threads  %s\n' "$scene" "$build" "$threads" "$sum"
      if [ "$sum" != "$first" ]; then different=$((different + 1)); fi
    done
  done
done
if [ $different -gt 0 ]; then
  echo "determinism.sh: $different runs differ from the optimised one on 1 thread" >&2
  exit 1
fi
