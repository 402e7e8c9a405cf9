#!/usr/bin/env bash
# Runs every block of the README marked "sh" that calls ./rift, in order, in one empty folder, and stops at the first command that
# fails: a README that lies fails here. A block marked "csv NAME" is the file of that name.
# usage: readme_commands.sh SOURCE_DIR RIFT [--no-viz]: without the renderer, commands that need it are left out.
set -euo pipefail
source_dir=$1
rift=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
ln -s "$rift" rift
awk '/^```csv / {file=$2; next} /^```/ {file=""} file {print > file}' "$source_dir/README.md"
commands=$(awk '/^```sh$/ {inside=1; next} /^```/ {inside=0} inside && /^\.\/rift/' "$source_dir/README.md")
[ "${3:-}" != --no-viz ] || commands=$(grep -vE ' render ' <<<"$commands" | sed 's/ --render//')
[ -n "$commands" ] || { echo "the README has no ./rift commands"; exit 1; }
while IFS= read -r command; do
  echo "\$ $command"
  bash -c "$command"
done <<<"$commands"
