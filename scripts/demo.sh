#!/usr/bin/env bash
# From a fresh Debian 12 to a clean map: installs what is missing, builds, records a simulated street and orchard,
# replays the street through the nodelet, labels both, and leaves maps and pictures in demo_output/.
set -euo pipefail
cd "$(dirname "$0")/.."
export PATH=/usr/bin:$PATH  # another python3 before the system's breaks catkin and rospy
out=demo_output
stillmap=build/devel/lib/stillmap/stillmap

# What each step takes on two cores, seconds.
declare -A step_s=([install]=150 [build]=400 [record]=45 [replay]=30 [label]=25 [draw]=60)
left_s=0
for seconds in "${step_s[@]}"; do left_s=$((left_s + seconds)); done

step() {
  printf '\n== %s (about %d:%02d left)\n' "$2" $((left_s / 60)) $((left_s % 60))
  left_s=$((left_s - step_s[$1]))
}
trap 'echo "demo.sh: failed at line $LINENO: $BASH_COMMAND" >&2' ERR

step install "Installing what is missing"
packages=(python3-matplotlib)
rviz=false
if [ -n "${DISPLAY:-}" ]; then
  packages+=(rviz)
  rviz=true
fi
bash scripts/setup.sh "${packages[@]}"

step build "Building in build/"
launcher=()
if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
mkdir -p "$out"
cmake -S . -B build "${launcher[@]}" >"$out/build.log"
cmake --build build -j "$(nproc)" --target stillmap stillmap_nodelet stillmap_generate_messages |
  tee -a "$out/build.log" | grep --line-buffered "^\[ *[0-9]*%\]"
set +u
. build/devel/setup.sh
set -u

step record "Recording a simulated street and orchard"
"$stillmap" simulate street "$out/street.bag" --scans 80
"$stillmap" simulate orchard "$out/orchard.bag" --scans 120

step replay "Replaying the street through the nodelet: roslaunch stillmap stillmap.launch bag:=... save_map:=..."
/usr/bin/python3 scripts/replay_bag.py "$out/street.bag" --save-map "$out/static_map.bt" --log "$out/roslaunch.log" \
  save_map:="$PWD/$out/static_map.pcd" rate:=0.5 rviz:=$rviz

step label "Labelling every point of both with the command line"
for scene in street orchard; do "$stillmap" label "$out/$scene.bag" "$out/$scene"; done

step draw "Drawing before and after"
draw() {
  local scene=$1 picture=$2
  shift 2
  /usr/bin/python3 scripts/render.py "$out/$scene.bag" "$out/$scene/final" "$out/$picture" --title "Simulated $scene" "$@"
}
draw street street_perspective.png --span-m 44 --turn-deg -16 --pitch-deg 22
draw street street_top.png --view top --span-m 50
draw orchard orchard_perspective.png --span-m 24 --turn-deg 14 --pitch-deg 25
draw orchard orchard_top.png --view top --span-m 34

[ -s "$out/static_map.pcd" ] || { echo "demo.sh: the nodelet left no $out/static_map.pcd; see $out/roslaunch.log" >&2; exit 1; }
cat <<END

Done. In $PWD/$out:
  static_map.pcd static_map.bt                  the street's map, saved by the nodelet
  street_perspective.png street_top.png         before and after
  orchard_perspective.png orchard_top.png       the same among swaying foliage
  street/ orchard/                              a label for each point of each scan, and summary.json
  street.bag orchard.bag                        to replay: . build/devel/setup.sh
                                                roslaunch stillmap stillmap.launch bag:=$PWD/$out/street.bag rviz:=true
END
