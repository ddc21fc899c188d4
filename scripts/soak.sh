#!/usr/bin/env bash
# A long drive: prints what a scan costs, what memory grows and whether labels drift over the way, and fails when they
# are not bounded. A simulated street with 64 rings, looped every 500 m.
# Usage: scripts/soak.sh [SCANS] [stillmap soak's options]
#   scripts/soak.sh                                    # 10,000 scans, 5 km, all of the map in memory
#   ROLLING=1 scripts/soak.sh 200000                   # the same 100 km long, with the rolling map
#   DAY=1 scripts/soak.sh                              # 24 hours, hour by hour: 432,000 scans of a small sensor at 5 Hz
#   LAP=/path/to/sequence_or.bag scripts/soak.sh 5000  # a recorded lap
# Environment: BUILD (default build), OUT (default build/soak), LAP, ROLLING, DAY.
set -euo pipefail
cd "$(dirname "$0")/.."

stillmap=${BUILD:-build}/devel/lib/stillmap/stillmap
out=${OUT:-build/soak}
mkdir -p "$out"
rolling=(--set "rolling_directory=$out/far")
if [ "${DAY:-0}" = 1 ]; then
  scans=432000 name=day
  world=(--sensor vlp16 --columns 100 --rate-hz 5 --scans 200 --ego-speed 2.5 --drift-percent 0)
  options=(--rows 24 --threads 1 --set max_range_m=20 --set rolling_radius_m=30 "${rolling[@]}" --set rolling_disk_mb=500
    --most-mb 100 --most-mb-per-km 0.1 --most-different-percent 3)
else
  scans=10000 name=street
  world=(--sensor hdl64 --scans 1000 --ego-speed 5)
  options=(--most-mb-per-km 60 --most-different-percent 2)
  if [ "${ROLLING:-0}" = 1 ]; then
    # One row: the second map of an earlier one would leave holes in memory, which are not the map's growth.
    options=(--rows 1 --set rolling_radius_m=150 "${rolling[@]}" --set rolling_disk_mb=2000
      --most-mb 250 --most-mb-per-km 2 --most-different-percent 2)
  fi
fi
if [[ ${1:-} =~ ^[0-9]+$ ]]; then
  scans=$1
  shift
fi
lap=${LAP:-$out/$name}
if [ ! -e "$lap" ]; then
  "$stillmap" simulate street "$lap.part" "${world[@]}"
  mv "$lap.part" "$lap"
fi
rm -rf "$out/far"
"$stillmap" soak "$lap" --scans "$scans" "${options[@]}" --most-cost-ratio 1.1 "$@"
