#!/usr/bin/env bash
# kill -9 at random moments of writing maps and tiles: what is on disk must open and be as new as was acknowledged.
# Usage: scripts/kill_test.sh [KILLS]        of each kind, 200 unless told; BUILD (default build) has the test
set -euo pipefail
cd "$(dirname "$0")/.."
STILLMAP_KILLS=${1:-200} exec "${BUILD:-build}/devel/lib/stillmap/kill_test"
