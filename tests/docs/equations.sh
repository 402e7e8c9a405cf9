#!/usr/bin/env bash
# Every function and every test that docs/equations.md names is there.
# usage: equations.sh SOURCE_DIR
set -u
cd "$1" || exit 2
wrong=0

names() { # COLUMN: what stands between backticks in that column of the tables
  awk -F ' \\| ' -v column="$1" '/^\| / && NF >= 3 { print $column }' docs/equations.md | grep -o '`[^`]*`' | tr -d '`' | sort -u
}

while read -r name; do
  grep -rqw --include='*.?pp' --include='*.inc' -- "${name##*::}" engine || { echo "no function $name in engine/"; wrong=1; }
done < <(names 2)

while read -r name; do
  suite=${name%%.*} test=${name#*.}
  pattern="TEST(_F|_P)?\($suite, ${test//\*/.*}[,)]"
  grep -rqE "$pattern|INSTANTIATE_TEST_SUITE_P\($suite," tests || { echo "no test $name in tests/"; wrong=1; }
done < <(names 3 | grep -v '^tests/' | grep '\.')
exit $wrong
