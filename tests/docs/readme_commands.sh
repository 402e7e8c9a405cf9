#!/usr/bin/env bash
# Runs every './rift' line of the README's sh blocks, in order, in an empty folder: a README that lies fails here.
# usage: readme_commands.sh SOURCE_DIR RIFT [--no-viz]: without the renderer, commands that need it are left out.
set -euo pipefail
source_dir=$1
rift=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
ln -s "$rift" rift
commands=$(awk '/^```sh$/ {inside=1; next} /^```/ {inside=0} inside && /^\.\/rift/' "$source_dir/README.md")
[ "${3:-}" != --no-viz ] || commands=$(grep -vE ' render |--render' <<<"$commands")
[ -n "$commands" ] || { echo "the README has no ./rift commands"; exit 1; }
while IFS= read -r command; do
  echo "\$ $command"
  bash -c "$command"
done <<<"$commands"
