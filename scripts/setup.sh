#!/usr/bin/env bash
# Installs the Debian packages that are missing, by apt-get as root or with sudo.
# Usage: scripts/setup.sh [MORE PACKAGES]
# Environment: WITHOUT, those to leave out, where a distribution lacks them.
set -euo pipefail

packages=(
  # ROS 1: build and message generation
  catkin cmake make g++ python3-empy ros-geometry-msgs ros-message-generation ros-std-msgs
  # ROS 1: libraries
  libdiagnostic-updater-dev libdynamic-reconfigure-config-init-mutex-dev libnav-msgs-dev libnodeletlib-dev librosbag-storage-dev libroscpp-dev libroslz4-dev
  libsensor-msgs-dev libstd-srvs-dev libtf2-ros-dev libvisualization-msgs-dev pluginlib-dev
  # ROS 1: tools at run time
  libnodeletlib-tools rospack-tools python3-nav-msgs python3-rosbag python3-roslaunch python3-rospy
  python3-sensor-msgs python3-std-srvs rosout
  # ROS 1: tests
  valgrind librostest-dev python3-rostest python3-rosunit libgtest-dev
  # Clients that the tests drive
  octomap-tools pcl-tools python3-dynamic-reconfigure python3-rostopic
  # Other libraries
  libcli11-dev libeigen3-dev liboctomap-dev libpcl-dev libpng-dev libtbb-dev libyaml-cpp-dev nlohmann-json3-dev robin-map-dev
  libbz2-dev libzstd-dev zlib1g-dev
  # Figures
  python3-matplotlib python3-numpy
  # Tools of the scripts
  git "$@"
)

missing=()
for package in "${packages[@]}"; do
  if [[ " ${WITHOUT:-} " == *" $package "* ]]; then continue; fi
  dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null | grep -x installed >/dev/null || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then exit 0; fi

echo "setup.sh: installing ${missing[*]}"
as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "setup.sh: run as root, or install sudo" >&2; exit 1; }
  as_root=(sudo)
fi
"${as_root[@]}" apt-get update
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"
