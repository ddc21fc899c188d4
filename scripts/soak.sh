#!/usr/bin/env bash
# A long drive: prints what a scan costs and what memory grows over the way, and fails when they are not bounded.
# Usage: scripts/soak.sh [SCANS] [stillmap soak's options]; a simulated street with 64 rings, looped every 500 m.
#   scripts/soak.sh                                    # 10,000 scans, 5 km, all of the map in memory
#   ROLLING=1 scripts/soak.sh 200000                   # the same 100 km long, with the rolling map
#   LAP=/path/to/sequence_or.bag scripts/soak.sh 5000  # a recorded lap
# Environment: BUILD (default build), OUT (default build/soak), LAP, ROLLING.
set -euo pipefail
cd "$(dirname "$0")/.."

stillmap=${BUILD:-build}/devel/lib/stillmap/stillmap
out=${OUT:-build/soak}
scans=${1:-10000}
shift || true
lap=${LAP:-$out/street}
mkdir -p "$out"
if [ ! -e "$lap" ]; then
  "$stillmap" simulate street "$lap.part" --sensor hdl64 --scans 1000 --ego-speed 5
  mv "$lap.part" "$lap"
fi

if [ "${ROLLING:-0}" = 1 ]; then
  rm -rf "$out/far"
  options=(--set rolling_radius_m=150 --set "rolling_directory=$out/far" --set rolling_disk_mb=2000
    --most-mb 250 --most-mb-per-km 2)
else
  options=(--most-mb-per-km 60)
fi
"$stillmap" soak "$lap" --scans "$scans" "${options[@]}" --most-cost-ratio 1.1 --most-different-percent 2 "$@"
