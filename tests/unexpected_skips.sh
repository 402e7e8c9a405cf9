#!/usr/bin/env bash
# Fails where a test was skipped without a reason in the list, and where the list names a test that does not exist.
# usage: unexpected_skips.sh JUNIT LIST, the first as of ctest --output-junit
set -euo pipefail
junit=$1
list=$2
[ -s "$junit" ] || { echo "unexpected_skips: $junit: no results of tests" >&2; exit 1; }

names() { sed -n 's/.*<testcase name="\([^"]*\)".*status="\('"$1"'\)".*/\1/p' "$junit" | sort -u; }
allowed=$(sed -n '/^#/d; s/^\([^:]*\): .*/\1/p' "$list" | sort -u)
nameless=$(grep -vE '^#|^[^: ]+: .|^$' "$list" || true)

wrong=0
complain() { # WHAT NAMES
  [ -n "$2" ] || return 0
  printf '%s\n' "$1" >&2
  printf '%s\n' "$2" | sed 's/^/  /' >&2
  wrong=1
}
complain "lines of $list that are not NAME: REASON:" "$nameless"
complain "skipped without a reason in $list:" "$(comm -23 <(names 'notrun\|disabled') <(printf '%s\n' "$allowed"))"
complain "named in $list, and no test of this name was run:" \
  "$(comm -13 <(names '[a-z]*') <(printf '%s\n' "$allowed" | sed '/^$/d'))"
exit $wrong
