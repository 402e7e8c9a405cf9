#!/usr/bin/env bash
# Installs the engine as a library, builds docs/library with it as a user would, runs it, and compares its ratio with that
# of the program for the same scene.
# usage: library_example.sh SOURCE_DIR BUILD_DIR RIFT
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cmake --install "$2" --prefix "$folder/prefix" --component library >/dev/null
cmake -S "$1/docs/library" -B "$folder/build" -G Ninja -DCMAKE_PREFIX_PATH="$folder/prefix" -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build "$folder/build" >/dev/null
answer=$("$folder/build/crack")
sed -n '/R"(/,/)"/p' "$1/docs/library/crack.cpp" | sed '1d; s/)".*//' >"$folder/scene.toml"
"$3" run "$folder/scene.toml" --out "$folder/run" --quiet >/dev/null
ratio=$(grep -o '"ratio": [0-9.e-]*' "$folder/run/summary.json" | head -1 | cut -d' ' -f2)
expected=$(LC_ALL=C printf 'G_ID / G_I0 = %.3f' "$ratio")
echo "library: $answer; program: $expected"
[ "$answer" = "$expected" ]
