#!/bin/sh
# Traces the guides of the scenes again: scenes/generate/guides.sh PROGRAM, from the project's folder.
set -eu
program=$1

# guide SCENE NAME arguments …: adds a guide to the file beside the scene
guide() {
  scene=$1
  name=$2
  shift 2
  "$program" guides trace "scenes/$scene/scene.xml" --name "$name" -o "scenes/$scene/scene.guides.json" \
    "$@" > /dev/null
}

rm -f scenes/rooms/scene.guides.json scenes/box/scene.guides.json \
  scenes/keyhole/scene.guides.json scenes/lantern/scene.guides.json

# From the globes over the dining table through the gap of the door. The cones overlap, from all of a globe to all of
# the gap: what no guide covers is left to few, bright paths.
for y in 0.2 0.62 1.04 1.46 1.88; do
  guide rooms "near globe, $y m" --disc 0.1 --cone 7.5 --from=0.828,1.57,-3.854 --to=1.395,$y,-1.92
  guide rooms "far globe, $y m" --disc 0.1 --cone 6.5 --from=0.251,1.57,-3.864 --to=1.395,$y,-1.92
done

# Five for each caustic of the glass ball.
guide box "ball 1" --disc 0.05 --from=0,1.82,-0.05       --to=0.36,0.33,0.42
guide box "ball 2" --disc 0.05 --from=-0.09,1.82,-0.14   --to=0.28,0.33,0.36
guide box "ball 3" --disc 0.05 --from=0.09,1.82,-0.14    --to=0.44,0.33,0.36
guide box "ball 4" --disc 0.05 --from=-0.09,1.82,0.04    --to=0.28,0.33,0.48
guide box "ball 5" --disc 0.05 --from=0.09,1.82,0.04     --to=0.44,0.33,0.48
guide box "mirror and ball 1" --disc 0.1 --cone 1 --from=0,1.82,-0.05 --to=1.2,0.944,0.226
guide box "mirror and ball 2" --disc 0.1 --cone 1 --from=0,1.82,-0.05 --to=1.2,0.99,0.226
guide box "mirror and ball 3" --disc 0.1 --cone 1 --from=0,1.82,-0.05 --to=1.2,0.90,0.226
guide box "mirror and ball 4" --disc 0.1 --cone 1 --from=0,1.82,-0.05 --to=1.2,0.944,0.18
guide box "mirror and ball 5" --disc 0.1 --cone 1 --from=0,1.82,-0.05 --to=1.2,0.944,0.272

# Through the round part of the keyhole and three places of the slot below. The cones are wide enough
# for all of the hole from all of the lamp: what no guide covers is left to few, bright paths.
guide keyhole "round hole"  --disc 0.008 --cone 5 --from=-1.66206,0.935,0.02899 --to=-1.45,0.934,0.002
guide keyhole "slot, upper" --disc 0.008 --cone 4.5 --from=-1.66206,0.935,0.02899 --to=-1.45,0.921,0.002
guide keyhole "slot, lower" --disc 0.008 --cone 4.5 --from=-1.66206,0.935,0.02899 --to=-1.45,0.909,0.002
guide keyhole "slot, foot"  --disc 0.008 --cone 4.5 --from=-1.66206,0.935,0.02899 --to=-1.45,0.902,0.002
# By way of the wall behind the lamp.
for y in 0.75 0.85 0.95 1.05; do
  for z in -0.15 -0.05 0.05 0.25; do
    guide keyhole "wall $y $z" --weight 0.02 --disc 0.008 --cone 5,4 \
      --from=-1.678,0.935,0.03 --to="-2.6,$y,$z" --to=-1.45,0.925,0.002
  done
done

# Through the face, and through the middle hole of each rosette.
guide lantern "left eye"      --disc 0.005 --cone 7 --from=-0.00027,0.85184,0.00464 --to=-0.0087,0.9095,0.1505
guide lantern "right eye"     --disc 0.005 --cone 7 --from=0.00242,0.85184,0.00397 --to=0.0783,0.9095,0.1288
guide lantern "mouth"         --disc 0.005 --cone 5 --from=0.00120,0.84941,0.00482 --to=0.0390,0.8309,0.1564
guide lantern "mouth, left"   --disc 0.005 --cone 5 --from=-0.00095,0.84980,0.00490 --to=-0.0309,0.8436,0.1588
guide lantern "mouth, right"  --disc 0.005 --cone 5 --from=0.00314,0.84980,0.00388 --to=0.1018,0.8436,0.1257
guide lantern "rosette 72"    --disc 0.005 --cone 6 --from=0.00499,0.85015,0.00035 --to=0.1674,0.8551,0.0117
guide lantern "rosette 108"   --disc 0.005 --cone 6 --from=0.00410,0.85129,-0.00256 --to=0.1423,0.8947,-0.0889
guide lantern "rosette 144"   --disc 0.005 --cone 6 --from=0.00187,0.85015,-0.00463 --to=0.0629,0.8551,-0.1556
guide lantern "rosette 180"   --disc 0.005 --cone 6 --from=-0.00117,0.85129,-0.00469 --to=-0.0406,0.8947,-0.1629
guide lantern "rosette -144"  --disc 0.005 --cone 6 --from=-0.00383,0.85015,-0.00321 --to=-0.1286,0.8551,-0.1079
guide lantern "rosette -108"  --disc 0.005 --cone 6 --from=-0.00482,0.85129,-0.00034 --to=-0.1674,0.8947,-0.0117
guide lantern "rosette -72"   --disc 0.005 --cone 6 --from=-0.00424,0.85015,0.00265 --to=-0.1423,0.8551,0.0889
