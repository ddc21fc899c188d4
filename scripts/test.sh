#!/usr/bin/env bash
# Installs what is missing, builds everything, runs every test; builds and tests the part without ROS, too.
# The build folders are build/ and build_core/ in the repository.
set -euo pipefail
cd "$(dirname "$0")/.."
export PATH=/usr/bin:$PATH  # another python3 before the system's breaks catkin

bash scripts/setup.sh

options=()
if command -v ccache >/dev/null; then options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi

# FOLDER [CMAKE OPTIONS]: plain ctest, whose exit code counts; run_tests' does not.
build_and_test() {
  local folder=$1
  shift
  cmake -S . -B "$folder" "${options[@]}" "$@"
  cmake --build "$folder" -j "$(nproc)"
  ctest --test-dir "$folder" --output-on-failure --no-tests=error 2>&1 | tee "$folder/ctest.log"
}

# FOLDER: how many passed, and the five slowest.
report() {
  echo
  echo "$1: $(grep 'tests passed' "$1/ctest.log")"
  grep -E 'Test +#[0-9]+:.* sec' "$1/ctest.log" | sed -E 's/^.*: (\S+) .* ([0-9.]+) sec.*$/\2 s  \1/' | sort -rn | head -5
}

build_and_test build
build_and_test build_core -DSTILLMAP_WITH_ROS=OFF
report build
report build_core
