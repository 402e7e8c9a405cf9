#!/usr/bin/env bash
# Runs every example of README.md and docs/*.md that shows what a command answers, and compares: a fenced block marked
# "console", whose lines "$ command" are run in order, in one empty folder a page; the lines below each are its output on
# both streams, where "..." stands for any lines.
# usage: docs_examples.sh SOURCE_DIR RIFT
set -euo pipefail
source_dir=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export RIFT_PRESETS="$source_dir/presets"
examples=0 failed=0

# Whether the text $1 is the text $2, in which a line "..." stands for any lines.
agrees() {
  local pattern=${2//\\/\\\\}
  pattern=${pattern//\*/\\*} pattern=${pattern//\?/\\?} pattern=${pattern//\[/\\[}
  pattern=${pattern//.../*}
  # shellcheck disable=SC2053  # a pattern on purpose
  [[ $1 == $pattern ]]
}

check() {
  local page=$1 command=$2 shown=$3 answer
  [ -n "$command" ] || return 0
  examples=$((examples + 1))
  answer=$(bash -c "$command" 2>&1 </dev/null) || true
  agrees "$answer" "$shown" && return 0
  failed=$((failed + 1))
  printf '%s: $ %s\n--- the page shows\n%s\n--- the program answers\n%s\n' "$page" "$command" "$shown" "$answer"
}

for page in "$source_dir"/README.md "$source_dir"/docs/*.md; do
  scratch=$(mktemp -d "$folder/XXXXXX")
  ln -s "$2" "$scratch/rift"
  cd "$scratch"
  PATH="$scratch:$PATH"
  inside=0 command='' shown=''
  while IFS= read -r line; do
    if [ "$inside" = 0 ]; then
      [ "$line" != '```console' ] || inside=1
    elif [ "$line" = '```' ]; then
      check "$page" "$command" "$shown"
      inside=0 command='' shown=''
    elif [[ $line == '$ '* ]]; then
      check "$page" "$command" "$shown"
      command=${line#'$ '} shown=''
    else
      shown+=${shown:+$'\n'}$line
    fi
  done <"$page"
done
echo "$examples examples, $failed failed"
[ "$failed" = 0 ] && [ "$examples" -gt 0 ]
