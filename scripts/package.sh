#!/usr/bin/env bash
# Makes stillmap_VERSION_ARCHITECTURE.deb in build_deb/, for this distribution: apt-get install ./build_deb/stillmap_*.deb
# scripts/try_package.sh tries it on a bare root.
set -euo pipefail
cd "$(dirname "$0")/.."
export PATH=/usr/bin:$PATH  # another python3 before the system's breaks catkin
bash scripts/setup.sh dpkg-dev
launcher=()
if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
# Binary package: without the setup files of a workspace, which would be in /usr.
cmake -S . -B build_deb "${launcher[@]}" -DCMAKE_INSTALL_PREFIX=/usr -DCATKIN_BUILD_BINARY_PACKAGE=ON \
  -DSTILLMAP_BUILD_TESTS=OFF
cmake --build build_deb -j "$(nproc)"
rm -f build_deb/stillmap_*.deb
(cd build_deb && cpack)
rm -r build_deb/_CPack_Packages  # roslaunch would find its launch files beside those of the sources
package=$(ls build_deb/stillmap_*.deb)
dpkg-deb --info "$package"
echo "$PWD/$package"
