#!/usr/bin/env bash
# Installs what is missing, builds everything, runs every test. Then it builds without ROS, which must also work, and
# compares the labels of the two builds; its tests would be the same ones again. Last, some tests of each part under
# sanitizers. The build folders are build/, build_core/, build-address/ and build-thread/ in the repository.
set -euo pipefail
cd "$(dirname "$0")/.."
export PATH=/usr/bin:$PATH  # another python3 before the system's breaks catkin
trap 'echo "test.sh: failed at line $LINENO after $SECONDS s: $BASH_COMMAND" >&2' ERR

# NAME COMMAND...: runs it and notes the wall time.
times=""
timed() {
  local name=$1 start=$SECONDS
  shift
  "$@"
  times+=$(printf '%5d s  %s' $((SECONDS - start)) "$name")$'\n'
}

# FOLDER [CMAKE OPTIONS]
build() {
  local folder=$1 launcher=()
  shift
  if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
  cmake -S . -B "$folder" "${launcher[@]}" "$@"
  cmake --build "$folder" -j "$(nproc)"
}

# Plain ctest, whose exit code counts; run_tests' does not. The rostests are alone while they run.
run_tests() {
  ctest --test-dir build -j "$(nproc)" --output-on-failure --no-tests=error 2>&1 | tee build/ctest.log
}

timed "install" bash scripts/setup.sh
# Warnings are errors here alone: a user's compiler may know more of them.
timed "build" build build -DCMAKE_CXX_FLAGS="-Wpedantic -Werror"
timed "tests" run_tests
timed "build without ROS" build build_core -DSTILLMAP_WITH_ROS=OFF -DSTILLMAP_BUILD_TESTS=OFF
timed "determinism" bash scripts/determinism.sh
timed "ASan and UBSan" bash scripts/sanitize.sh address quick
timed "TSan" bash scripts/sanitize.sh thread quick

printf '\nSlowest tests:\n'
sed -nE 's/^.*Test +#[0-9]+: (\S+) .* ([0-9.]+) sec.*$/\2 s  \1/p' build/ctest.log | sort -rn |
  awk 'NR <= 10 { print "  " $0 }'  # not head: who writes to a closed pipe ends the script
printf '\nWall time:\n%s%5d s  total\n' "$times" $SECONDS
printf '\n%s\n' "$(grep 'tests passed' build/ctest.log)"
