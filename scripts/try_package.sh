#!/usr/bin/env bash
# Installs the package of scripts/package.sh on a bare Debian of its own and runs `roslaunch stillmap demo.launch` there.
# Needs root and debootstrap. Usage: try_package.sh [DEB]
set -euo pipefail
cd "$(dirname "$0")/.."
package=$(readlink -f "${1:-$(ls build_deb/stillmap_*.deb)}")
root=$(mktemp -d)/root
trap 'echo "try_package.sh: failed at line $LINENO: $BASH_COMMAND" >&2' ERR

# Mounts first: a root is never removed with something mounted on it.
clean_up() {
  for mounted in proc dev; do
    if mountpoint -q "$root/$mounted"; then umount "$root/$mounted"; fi
  done
  rm -rf --one-file-system "$(dirname "$root")"
}
trap clean_up EXIT

debootstrap --variant=minbase bookworm "$root" "${DEBIAN_MIRROR:-http://deb.debian.org/debian}" >/dev/null
echo "127.0.0.1 localhost" >"$root/etc/hosts"
mount -t proc proc "$root/proc"
mount --bind /dev "$root/dev"
cp "$package" test/install/demo_answers.py "$root/srv/"
start=$SECONDS
chroot "$root" apt-get update -qq
chroot "$root" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -qq -y --no-install-recommends "/srv/$(basename "$package")" >/dev/null
echo "installed with $(chroot "$root" dpkg-query -f '.\n' -W | wc -l) packages in all, in $((SECONDS - start)) s"
chroot "$root" stillmap --version
chroot "$root" env ROS_HOSTNAME=localhost /usr/bin/python3 /srv/demo_answers.py
chroot "$root" env DEBIAN_FRONTEND=noninteractive apt-get remove -qq -y stillmap >/dev/null
[ -z "$(chroot "$root" find /usr -name '*stillmap*')" ]
