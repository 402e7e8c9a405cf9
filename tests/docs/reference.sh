#!/usr/bin/env bash
# Makes the reference of the engine from its docstrings, and fails where a docstring does not fit what it stands at.
# usage: reference.sh SOURCE_DIR
set -euo pipefail
cd "$1"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
{ cat docs/Doxyfile; echo "OUTPUT_DIRECTORY = $folder"; } | doxygen - >"$folder/out" 2>&1
if [ -s "$folder/out" ]; then
  cat "$folder/out"
  exit 1
fi
grep -q 'rate_between' "$folder/reference/release__rate_8hpp.html" || { echo 'rate_between is not in the reference'; exit 1; }
