#!/usr/bin/env bash
# Runs the Python blocks of docs/python.md in order, in one process, on a small run, and looks at what they print.
# pandas and pyvista are not asked for: a block that needs pandas is left out where that is not installed.
# usage: python_examples.sh SOURCE_DIR RIFT
set -euo pipefail
source_dir=$1 rift=$2
python=python3
python3 -c 'import h5py' 2>/dev/null || python=/usr/bin/python3  # the distribution's, for which python3-h5py is
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
"$rift" run quickstart --set specimen.elements=2000 --out runs/demo --quiet >summary.txt
"$rift" export runs/demo --to pvd >exported.txt
"$python" - "$source_dir/docs/python.md" >code.py <<'END'
import importlib.util, re, sys

blocks = re.findall(r"```python\n(.*?)```", open(sys.argv[1]).read(), re.S)
for block in blocks:
    if "pandas" not in block or importlib.util.find_spec("pandas"):
        print(block)
END
"$python" code.py >out.txt
cat out.txt
ratio=$(grep -o '"ratio": [0-9.e-]*' runs/demo/summary.json | head -1 | cut -d' ' -f2)
grep -q "^G_ID/G_I0 = $(LC_ALL=C printf '%.3f' "$ratio"), Broberg 0.520" out.txt
grep -Eq '^[1-9][0-9]* points in the window, mean 0\.[0-9]{3}$' out.txt
grep -Eq '^[0-9]+ elements, [1-9][0-9]* moments, u_y from -' out.txt
[ "$(wc -l <last_moment.csv)" -gt 1900 ]
