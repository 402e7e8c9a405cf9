#!/usr/bin/env bash
# Refuses phrases that readers did not understand, in the string literals of the program and in documents and presets.
# docs/glossary.md has the words to use instead. Text in backticks, such as names of tests and keys, is not read.
# usage: plain_words.sh SOURCE_DIR
set -euo pipefail
cd "$1"

# What is refused (a pattern) => what to say.
phrases='
\<books\>|\<booked\> => energy balance, balance error
\<told\> => is reported, is given
\<(laid|lay|lays) [a-z ]*over\> => reference, compared with
given back => forward check
made to rise => monotone fit
nothing is left of it => is already finished
\<(come|comes|came) to (its|their) end => finishes, is finished
\<(run|runs|ran) by (itself|themselves) => a predicted crack
off broberg => difference to Broberg
\<(the|each|every|a) knob => parameter
safe for certain => guaranteed stable
beam to soften => steps per beam release
\<is dear\> => is expensive
\<(loud|quiet) (quarter|minute|run) => with background load, without other load
first echo => first boundary reflection
came of (it|each)|comes? to, and what => expected and observed outcome
cost and buy => error and run time
thrown into => measured by waves
\<(made|built|written|starts?|begins?|begun) anew => rebuilt, starts again
decimals have a point => use a decimal point
cannot be: |packing not asked for => not computed, not evaluated
what was (found|said)\> => results, messages
straight on to => extrapolated to
'
banned=$(sed -nE 's/ => .*//p' <<<"$phrases" | paste -sd'|')

# The joined string literals of C++ sources, a line each; comments are left out.
literals() {
  sed -E 's@^[[:space:]]*//.*$@@; s@[[:space:]]//[^"]*$@@; s@\\"@ @g' "$1" | tr '\n' ' ' |
    sed -E 's/"[[:space:]]+"//g' | grep -oE '"[^"]*"' | grep -vx '"booked"' || true  # a dataset of checkpoints
}

# A document's sentences, a paragraph a line.
prose() {
  # shellcheck disable=SC2016  # backticks of the document
  sed -E 's/`[^`]*`//g; s/^# ?//; s/^$/\x01/' "$1" | tr '\n' ' ' | tr '\001' '\n'
}

# FUNCTION FILE...: what the function finds in each file, behind the file's name.
texts() {
  local function=$1 file
  shift
  for file; do "$function" "$file" | sed "s@^@$file: @"; done
}

mapfile -t sources < <(find engine studio viz -name '*.[ch]pp' | LC_ALL=C sort)
mapfile -t documents < <(find docs CHANGELOG.md CONTRIBUTING.md presets -name '*.md' -o -name '*.toml' | LC_ALL=C sort)
found=$({ texts literals "${sources[@]}"; texts prose "${documents[@]}"; } | LC_ALL=C grep -iE ": .*($banned)") || exit 0
LC_ALL=C grep -ioE "^[^:]*:|.{0,40}($banned).{0,40}" <<<"$found"
exit 1
