#!/usr/bin/env bash
# Makes the pictures and films of the gallery anew, two minutes: renders/make.sh [RIFT]. Each run is kept in runs/gallery.
set -euo pipefail
cd "$(dirname "$0")/.."
rift=${1:-./rift}

run() { # NAME [OPTIONS...]
  local name=$1
  shift
  [ -e "runs/gallery/$name/summary.json" ] || "$rift" run "$name" --out "runs/gallery/$name" --quiet "$@" >/dev/null
}
draw() { "$rift" render --force --quiet "$@"; }

run fig04_frames
draw runs/gallery/fig04_frames --film renders/crack.mp4
draw runs/gallery/fig04_frames --at 0.6 --picture renders/crack.png
run fig02_lattice
draw runs/gallery/fig02_lattice --at 0 --picture renders/lattice.png
run fig03_geometry
draw runs/gallery/fig03_geometry --at 0 --picture renders/geometry.png
run teach_node_release
draw runs/gallery/teach_node_release --at 0.6 --picture renders/release_at_once_and_progressive.png
draw runs/gallery/teach_node_release --size 960x540 --frames 80 --film renders/release_at_once_and_progressive.mp4
run teach_damage_zone
draw runs/gallery/teach_damage_zone --at 0.6 --picture renders/damage_zone.png
run path_curved
draw runs/gallery/path_curved --at 0.9 --picture renders/path_curved.png
run teach_velocity
draw runs/gallery/teach_velocity --at 0.35 --picture renders/four_velocities.png
"$rift" reproduce fig16 --out runs/gallery/reproduction --quiet >/dev/null
cp runs/gallery/reproduction/charts/fig16_at_0.00.png renders/cylinders.png
