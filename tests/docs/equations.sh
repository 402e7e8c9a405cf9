#!/usr/bin/env bash
# Every function that docs/equations.md names is in the files beside it, and every test is there.
# usage: equations.sh SOURCE_DIR
set -u
cd "$1" || exit 2
wrong=0

column() { # of all tables, a row a line
  awk -F ' \\| ' -v column="$1" '/^\| / && NF >= 3 { print $column }' docs/equations.md
}
quoted() { grep -o '`[^`]*`' | tr -d '`'; }

# "`stable_step`, `damped_critical_step` (lattice/stable_step)": the names before a parenthesis are in the files that it lists.
while IFS= read -r part; do
  files=$(sed -n 's/.*(\([a-z_]*\/[a-z_;, /]*\))$/\1/p' <<<"$part" | tr ';,' '  ')
  for name in $(quoted <<<"$part"); do
    where=engine
    [ -n "$files" ] && where=$(for f in $files; do ls engine/"$f".* 2>/dev/null; done)
    grep -rqw --include='*.?pp' --include='*.inc' -- "${name##*::}" $where || { echo "no $name in ${files:-engine}"; wrong=1; }
  done
done < <(column 2 | grep -o '[^()]*\(([^)]*)\)\?')

while read -r name; do
  suite=${name%%.*} test=${name#*.}
  grep -rqE "TEST(_F|_P)?\($suite, ${test//\*/.*}[,)]|INSTANTIATE_TEST_SUITE_P\($suite," tests || { echo "no test $name in tests/"; wrong=1; }
done < <(column 3 | quoted | grep -v '^tests/' | grep '\.' | sort -u)
exit $wrong
