#!/usr/bin/env bash
# Builds this revision and runs its tests on a bare Ubuntu 20.04 of its own: GCC 9, CMake 3.16, PCL 1.10, TBB 2020, and
# the ROS 1 that Ubuntu itself packages. CLI11 and diagnostic_updater, which Ubuntu 20.04 lacks, are Debian's headers.
# Needs root, debootstrap and Debian's apt. Usage: try_focal.sh [CTEST OPTIONS]   -R REGEX for some of the tests
# Environment: FOCAL_ROOT, a folder to keep that Ubuntu in for the next time; removed afterwards unless told.
set -euo pipefail
cd "$(dirname "$0")/.."
kept=${FOCAL_ROOT:-}
root=${kept:-$(mktemp -d)/root}
mirror=${UBUNTU_MIRROR:-archive.ubuntu.com/ubuntu}
trap 'echo "try_focal.sh: failed at line $LINENO: $BASH_COMMAND" >&2' ERR

# Mounts first: a root is never removed with something mounted on it.
clean_up() {
  for mounted in proc dev; do
    if mountpoint -q "$root/$mounted"; then umount "$root/$mounted"; fi
  done
  if [ -z "$kept" ]; then rm -rf --one-file-system "$(dirname "$root")"; fi
}
trap clean_up EXIT

inside() { chroot "$root" env DEBIAN_FRONTEND=noninteractive ROS_HOSTNAME=localhost HOME=/root "$@"; }

# By https, since Debian has no package of Ubuntu's keys; apt inside has them.
if [ ! -e "$root/etc/apt/sources.list" ]; then
  debootstrap --variant=minbase --no-check-gpg focal "$root" "https://$mirror" >/dev/null
fi
for suite in focal focal-updates; do echo "deb http://$mirror $suite main universe"; done >"$root/etc/apt/sources.list"
echo "127.0.0.1 localhost" >"$root/etc/hosts"
mount -t proc proc "$root/proc"
mount --bind /dev "$root/dev"

sources=$root/srv/stillmap
mkdir -p "$sources"
git archive HEAD | tar x -C "$sources"
lacking="libcli11-dev libdiagnostic-updater-dev"
inside apt-get update -qq
inside env WITHOUT="$lacking" bash /srv/stillmap/scripts/setup.sh libdiagnostic-msgs-dev >/dev/null
for package in $lacking; do
  (cd "$root/srv" && apt-get download -qq "$package" && dpkg -x "$package"_*.deb "$root" && rm "$package"_*.deb)
done
# Of diagnostic_updater only what its headers hold: the library is for a newer C library.
rm -f "$root"/usr/lib/*/libdiagnostic_updater.so
sed -i 's/set(libraries "diagnostic_updater")/set(libraries "")/' "$root"/usr/lib/*/cmake/diagnostic_updater/*Config.cmake

inside g++ --version | sed -n 1p
inside cmake -S /srv/stillmap -B /srv/stillmap/build -DCMAKE_CXX_FLAGS=-Wpedantic >/dev/null
inside cmake --build /srv/stillmap/build -j "$(nproc)"
inside bash -c 'cd /srv/stillmap/build && ctest --output-on-failure "$@"' _ "$@"
