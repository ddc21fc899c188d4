#!/usr/bin/env bash
# Measures the core's speed: Google Benchmark for its pieces, then whole scans on simulated sequences beside
# floors measured in the same run; at last what each stage reads and writes, by valgrind. Writes bench_output/micro.txt,
# pipeline.txt and memory.txt.
# Usage: scripts/bench.sh [SCANS]        scans of each sequence, 60 unless told
set -euo pipefail
cd "$(dirname "$0")/.."
export PATH=/usr/bin:$PATH

bash scripts/setup.sh libbenchmark-dev
cmake -S . -B build-bench -DSTILLMAP_WITH_ROS=OFF -DSTILLMAP_BUILD_TESTS=ON -DSTILLMAP_BUILD_BENCH=ON
cmake --build build-bench -j"$(nproc)" --target micro_bench pipeline_bench stage_instructions
programs=build-bench/devel/lib/stillmap
mkdir -p bench_output
"$programs/micro_bench" | tee bench_output/micro.txt
if perf stat -e instructions:u true 2>&1 | grep '^ *[0-9]' >/dev/null; then
  perf stat -e instructions:u -o bench_output/instructions.txt "$programs/pipeline_bench" "${1:-60}" |
    tee bench_output/pipeline.txt
  grep instructions bench_output/instructions.txt | tee -a bench_output/pipeline.txt
else
  echo "bench.sh: perf counts no instructions on this machine" >&2
  "$programs/pipeline_bench" "${1:-60}" | tee bench_output/pipeline.txt
fi

# Instructions, reads, writes, and the bytes that the caches had to fetch, for each stage of a scan.
test/speed/instruction_bounds.py "$programs/stage_instructions" --cache --scene street hdl64 | tee bench_output/memory.txt
