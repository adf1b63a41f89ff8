#!/usr/bin/env bash
# How the window feels while every processor renders: frame times of the interface, and the time from a key
# or a camera move to the screen. On a virtual display with the software rasteriser; prints figures, passes
# or fails nothing.
#   bench/viewer_bench.sh [BUILD_FOLDER]        default: build/release
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
build=${1:-$root/build/release}

echo "frame times over ten seconds of orbiting the default scene, 1280x720:"
xvfb-run -a -s '-screen 0 1280x720x24' bash -c '
  "$0/guidelight" view --frame-times "$1/scenes/default/scene.xml" &
  viewer=$!
  sleep 3
  xdotool mousemove 640 360 keydown Alt_L mousedown 1
  for i in $(seq 200); do xdotool mousemove $((640 + (i % 40) * 4)) 360; sleep 0.05; done
  xdotool mouseup 1 keyup Alt_L key ctrl+q
  wait $viewer' "$build" "$root"

echo "from the event to changed pixels, mean of five:"
"$build/tests/end_to_end_tests" --gtest_filter='*AnswersAtOnce*' | grep ' ms from '
