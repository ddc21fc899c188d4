#!/usr/bin/env bash
# A picture of what rviz shows of a bag, taken without a screen; the replay is slow because rviz then draws in software.
# Usage: scripts/rviz_picture.sh BAG OUT.png [--at-scan N] [--explain "X Y Z"] [NAME:=VALUE for stillmap.launch ...]
# Needs the packages rviz xvfb xauth imagemagick and a sourced workspace (. build/devel/setup.sh).
set -euo pipefail
if [ $# -lt 2 ]; then
  sed -n '2,4s/^# //p' "$0" >&2
  exit 2
fi
bag=$1 picture=$2
shift 2
export LIBGL_ALWAYS_SOFTWARE=1 QT_X11_NO_MITSHM=1 QT_QPA_PLATFORM=xcb XDG_RUNTIME_DIR=${XDG_RUNTIME_DIR:-/tmp}
exec xvfb-run -a -s "-screen 0 1280x800x24 +extension GLX" \
  /usr/bin/python3 "$(dirname "$0")/replay_bag.py" "$bag" --picture "$picture" "$@" rviz:=true rate:=0.25
