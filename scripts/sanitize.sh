#!/usr/bin/env bash
# Builds with sanitizers in build-address/ or build-thread/ and runs the tests there.
# Usage: scripts/sanitize.sh address|thread            all tests but those that measure time or memory
#        scripts/sanitize.sh address|thread quick      those that test.sh runs: a few of each part, in minutes
#        scripts/sanitize.sh address|thread -R REGEX   or other options of ctest
#   address   ASan and UBSan; every find ends the test. fuzz.sh runs the readers' inputs so; their replays bound the
#             memory, which ASan does not bear
#   thread    TSan. Debian's TBB is built without it: src/core/on_all_threads.cpp tells it how work goes to TBB's
#             threads and comes back. cmake/thread_sanitizer.supp: what it must not look into, and why
# Environment: TARGETS, to build only these, where only their tests are to run.
set -euo pipefail
cd "$(dirname "$0")/.."
export PATH=/usr/bin:$PATH
case ${1:-} in
  address)
    flags="-fsanitize=address,undefined -fno-sanitize-recover=undefined"
    quick=(mapper_test voxel_map_test located_rows_test map_archive_test semantickitti_folder_test bag_check_test
      point_cloud_conversion_test scan_pairing_test far_places_test)
    rostest=bad_input ;;
  thread)
    flags="-fsanitize=thread"
    quick=(on_all_threads_test mapper_threads_test tile_folder_test read_ahead_test) rostest= ;;
  *) sed -n '2,10s/^# //p' "$0" >&2; exit 2 ;;
esac
build=build-$1
shift
if [ "${1:-}" = quick ]; then
  shift
  TARGETS="${quick[*]} ${rostest:+${rostest}_test stillmap_node stillmap_nodelet}"
  chosen=("${quick[@]}" ${rostest:+".*_$rostest.test"})
  set -- -R "^($(IFS='|'; echo "${chosen[*]}"))\$" "$@"
elif [ $# -eq 0 ]; then
  # Of time and memory a sanitizer's own is most; what install_test builds is built without.
  set -- -E '^(fuzz_.*|install_test)$|_(overhead|overload).test$'
fi

bash scripts/setup.sh
# Before the build, which makes a bag with the program.
export ASAN_OPTIONS=detect_leaks=0:abort_on_error=1:new_delete_type_mismatch=1:quarantine_size_mb=8  # reload_test weighs
export UBSAN_OPTIONS=print_stacktrace=1
export TSAN_OPTIONS=suppressions=$PWD/cmake/thread_sanitizer.supp:halt_on_error=1:second_deadlock_stack=1
# Address randomisation with many bits leaves no room for TSan's shadow on newer kernels; some containers keep it on.
fixed_addresses=(setarch "$(uname -m)" -R)
"${fixed_addresses[@]}" true 2>/dev/null || fixed_addresses=()
mkdir -p "$build"
if [ "$build" = build-thread ]; then
  probe=$(echo 'int main() {}' | g++ -fsanitize=thread -x c++ - -o "$build/probe" && "${fixed_addresses[@]}" "$build/probe" 2>&1) ||
    case $probe in
      *"unexpected memory mapping"*)
        echo "sanitize.sh: SKIPPED, TSan finds no room here; allow setarch -R, or set vm.mmap_rnd_bits to 28" >&2
        exit 0 ;;
    esac
fi

launcher=()
if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
# Without NDEBUG: Eigen checks indices, too.
cmake -S . -B "$build" "${launcher[@]}" -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -g1" \
  -DCMAKE_CXX_FLAGS="$flags -fno-omit-frame-pointer" >/dev/null
"${fixed_addresses[@]}" cmake --build "$build" -j "$(nproc)" ${TARGETS:+--target $TARGETS}

# ROS's own programs, which load the nodelet, are not built so: the runtime must be there before them.
case $build in
  build-address) STILLMAP_PRELOAD=$(gcc -print-file-name=libasan.so) ;;
  build-thread) STILLMAP_PRELOAD=$(gcc -print-file-name=libtsan.so) ;;
esac
export STILLMAP_PRELOAD
exec "${fixed_addresses[@]}" ctest --test-dir "$build" --output-on-failure --no-tests=error --timeout 3600 "$@"
