#!/usr/bin/env bash
# The installed tree works alone: a package that finds the library builds and runs, the command line runs, and so does
# the demo by roslaunch. Usage: install_test.sh BUILD_FOLDER (of a build with ROS)
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "$1" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
trap 'echo "install_test.sh: failed at line $LINENO: $BASH_COMMAND" >&2' ERR
export PATH=/usr/bin:$PATH

DESTDIR=$folder cmake --install "$build" >"$folder/install.log"
prefix=$folder$(sed -n 's/^CMAKE_INSTALL_PREFIX:PATH=//p' "$build/CMakeCache.txt")

cmake -S "$here/consumer" -B "$folder/consumer" -DCMAKE_PREFIX_PATH="$prefix" >"$folder/configure.log"
cmake --build "$folder/consumer" >"$folder/build.log"
grep -q "^stillmap_DIR:PATH=$prefix/" "$folder/consumer/CMakeCache.txt"
"$folder/consumer/consumer"

# As for a user of the installed tree, who has no workspace.
unset CMAKE_PREFIX_PATH LD_LIBRARY_PATH PYTHONPATH ROS_PACKAGE_PATH
set +u
. "$prefix/setup.bash"
set -u
"$prefix/bin/stillmap" parameters | cmp - "$prefix/share/stillmap/config/default.yaml"
[ "$(rospack find stillmap)" = "$prefix/share/stillmap" ]
rospack plugins --attrib=plugin nodelet | grep -x "stillmap $prefix/share/stillmap/nodelet_plugins.xml" >/dev/null
for launch in stillmap demo; do roslaunch --nodes stillmap $launch.launch rviz:=true | grep -x /stillmap >/dev/null; done
roslaunch --dump-params stillmap demo.launch | grep -x '/stillmap/voxel_size_m: 0.1' >/dev/null
/usr/bin/python3 "$here/demo_answers.py"
