#!/usr/bin/env bash
# Fuzzes every reader and conversion with libFuzzer, ASan and UBSan. Starts from the inputs in fuzz/corpus and leaves
# there the smallest ones that reach as much; inputs named found_* once broke something and stay. What breaks
# something now is left in build-fuzz/found, and the exit code is 1. The table is also in build-fuzz/table.md.
# Usage: scripts/fuzz.sh [SECONDS_PER_TARGET] [TARGET ...]    60 s and all targets unless told
# Environment: JOBS, targets at a time (default: one for each core). Needs the packages clang-14 and libclang-rt-14-dev.
set -euo pipefail
cd "$(dirname "$0")/.."
export PATH=/usr/bin:$PATH
seconds=${1:-60}
shift || true
kept_bytes=55000  # of each target's corpus
build=build-fuzz
programs=$build/devel/lib/stillmap

bash scripts/setup.sh clang-14 libclang-rt-14-dev
launcher=()
if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
cmake -S . -B $build "${launcher[@]}" -DCMAKE_CXX_COMPILER=clang++-14 -DSTILLMAP_FUZZ=ON -DSTILLMAP_BUILD_TESTS=OFF
targets=("$@")
if [ ${#targets[@]} -eq 0 ]; then
  for source in fuzz/*_fuzz.cpp; do targets+=("$(basename "$source" _fuzz.cpp)"); done
fi
cmake --build $build -j "$(nproc)" --target "${targets[@]/%/_fuzz}"

# More than any input may make a reader ask for: a bag's chunk may have 256 MB.
limits=(-rss_limit_mb=1500 -malloc_limit_mb=600 -timeout=60 -report_slow_units=60 -detect_leaks=0 -print_final_stats=1)
mkdir -p $build/found $build/logs
fuzz() {
  local target=$1 inputs=$build/inputs/$1
  mkdir -p "$inputs"
  nice -n 19 "$programs/${target}_fuzz" "${limits[@]}" -max_total_time="$seconds" \
    -artifact_prefix="$build/found/${target}_" "$inputs" "fuzz/corpus/$target" >"$build/logs/$target.log" 2>&1 || true
}
minimise() {
  local target=$1 least=$build/least/$1 corpus=fuzz/corpus/$1 bytes=0 file
  rm -rf "$least"
  mkdir -p "$least"
  "$programs/${target}_fuzz" -merge=1 "${limits[@]}" -artifact_prefix="$build/found/${target}_" "$least" "$corpus" "$build/inputs/$target" \
    >>"$build/logs/$target.log" 2>&1
  find "$corpus" -type f ! -name 'found_*' -delete
  while read -r file; do
    bytes=$((bytes + $(stat -c %s "$file")))
    if [ $bytes -gt $kept_bytes ]; then break; fi
    cp "$file" "$corpus/"
  done < <(find "$least" -type f -printf '%s %p\n' | sort -n | cut -d' ' -f2)
}
row() {
  local log=$build/logs/$1.log found
  found=$(find $build/found -name "$1_*" | wc -l)
  printf '| %s | %s | %s | %s | %d |\n' "$1" "$(sed -n '/^stat::number_of_executed_units: */{s///p;q}' "$log")" \
    "$(grep -oE 'cov: [0-9]+' "$log" | sed 's/cov: //' | sort -n | tail -1)" \
    "$(find "fuzz/corpus/$1" -type f | wc -l)" "$found"
}
export -f fuzz
export build programs seconds
export limits_text="${limits[*]}"
printf '%s\n' "${targets[@]}" |
  xargs -P "${JOBS:-$(nproc)}" -I{} bash -c 'read -ra limits <<<"$limits_text"; fuzz "$1"' _ {}
{
  printf '| target | executions | edges | kept inputs | finds |\n|---|---|---|---|---|\n'
  for target in "${targets[@]}"; do
    minimise "$target"
    row "$target"
  done
} | tee $build/table.md
[ -z "$(find $build/found -type f)" ] || { echo "fuzz.sh: inputs that break something: $build/found" >&2; exit 1; }
