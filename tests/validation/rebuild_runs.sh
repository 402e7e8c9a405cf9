#!/usr/bin/env bash
# Small runs of rift, each rebuilt from its archive alone by rebuild_run.py and compared row by row to 1e-8.
# usage: rebuild_runs.sh SOURCE_DIR RIFT      ends with 77 (skipped) where numpy, scipy or h5py is missing
set -euo pipefail
source_dir=$1 rift=$2
python=
for candidate in python3 /usr/bin/python3; do  # the distribution's has python3-numpy, python3-scipy, python3-h5py
  if "$candidate" -c 'import numpy, scipy, h5py' 2>/dev/null; then python=$candidate; break; fi
done
if [ -z "$python" ]; then
  echo "skipped: needs python3-numpy, python3-scipy and python3-h5py"
  exit 77
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
plate=(plate_pnrt --set specimen.elements=1200 --set 'specimen.length=60 mm' --set 'specimen.height=20 mm'
       --set 'loading.displacement=1 mm' --set output.frames=0 --quiet)
rebuild() { # NAME OPTIONS...
  local name=$1
  shift
  "$rift" run "${plate[@]}" "$@" --out "$folder/$name" >"$folder/$name.txt"
  echo "$name"
  "$python" "$source_dir/tests/validation/rebuild_run.py" "$folder/$name/run.vtkhdf"
}
rebuild progressive
rebuild simple --set crack.technique=simple
rebuild quadratic_bulk --set material.stiffness=bulk --set crack.relaxation=quadratic --set crack.damage_zone_ratio=4
rebuild notched --set 'crack.start=6 mm' --set 'crack.velocity=0.2 c_r'
# A mass that is wrong by a thousandth is seen.
"$python" - "$folder/progressive/run.vtkhdf" <<'END'
import sys, h5py
with h5py.File(sys.argv[1], "r+") as run:
    mass = run["scene/lattice/mass_kg"]
    mass[...] = 1.001 * mass[...]
END
if "$python" "$source_dir/tests/validation/rebuild_run.py" "$folder/progressive/run.vtkhdf" >"$folder/wrong.txt"; then
  echo "a wrong mass is not seen"
  exit 1
fi
