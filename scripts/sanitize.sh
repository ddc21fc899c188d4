#!/usr/bin/env bash
# Builds with sanitizers in build-address/ or build-thread/ and runs the tests there.
# Usage: scripts/sanitize.sh address|thread [CTEST OPTIONS]     all tests unless -R or -L chooses
#   address   ASan and UBSan; every find ends the test
#   thread    TSan; what it must not look into is in cmake/thread_sanitizer.supp, with the reason of each line
# Environment: TARGETS, to build only these, where only their tests are to run.
set -euo pipefail
cd "$(dirname "$0")/.."
export PATH=/usr/bin:$PATH
case ${1:-} in
  address) flags="-fsanitize=address,undefined -fno-sanitize-recover=undefined" ;;
  thread) flags="-fsanitize=thread" ;;
  *) sed -n '2,5s/^# //p' "$0" >&2; exit 2 ;;
esac
build=build-$1
shift

bash scripts/setup.sh
launcher=()
if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
cmake -S . -B "$build" "${launcher[@]}" -DCMAKE_BUILD_TYPE=RelWithDebInfo \
  -DCMAKE_CXX_FLAGS="$flags -fno-omit-frame-pointer -g1" >/dev/null
cmake --build "$build" -j "$(nproc)" ${TARGETS:+--target $TARGETS}

# ROS's own programs, which load the nodelet, are not built so: the runtime must be there before them.
export ASAN_OPTIONS=detect_leaks=0:abort_on_error=1:new_delete_type_mismatch=1
export UBSAN_OPTIONS=print_stacktrace=1
export TSAN_OPTIONS=suppressions=$PWD/cmake/thread_sanitizer.supp:halt_on_error=1:second_deadlock_stack=1
case $build in
  build-address) STILLMAP_PRELOAD=$(gcc -print-file-name=libasan.so) ;;
  build-thread) STILLMAP_PRELOAD=$(gcc -print-file-name=libtsan.so) ;;
esac
export STILLMAP_PRELOAD
# Address randomisation with many bits leaves no room for TSan's shadow on newer kernels.
exec setarch "$(uname -m)" -R ctest --test-dir "$build" --output-on-failure --no-tests=error --timeout 1500 "$@"
