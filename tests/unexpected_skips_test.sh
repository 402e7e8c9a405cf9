#!/usr/bin/env bash
# unexpected_skips.sh on results of each kind.
set -euo pipefail
cd "$(dirname "$0")"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

cat >"$folder/junit.xml" <<'END'
<testsuite name="Linux" tests="3" failures="0" disabled="0" skipped="2">
	<testcase name="A.Runs" classname="A.Runs" time="0.1" status="run">
	</testcase>
	<testcase name="B.Mounts" classname="B.Mounts" time="0.1" status="notrun">
		<skipped message="SKIP_REGULAR_EXPRESSION_MATCHED"/>
	</testcase>
	<testcase name="C.Terminal" classname="C.Terminal" time="0.1" status="notrun">
		<skipped message="SKIP_REGULAR_EXPRESSION_MATCHED"/>
	</testcase>
</testsuite>
END

expect() { # CODE PART LIST...
  local code=0 wanted=$1 part=$2
  shift 2
  printf '%s\n' "$@" >"$folder/list"
  ./unexpected_skips.sh "$folder/junit.xml" "$folder/list" >"$folder/out" 2>&1 || code=$?
  if [ "$code" != "$wanted" ] || { [ -n "$part" ] && ! grep -qF -- "$part" "$folder/out"; }; then
    printf 'expected %s and "%s" of the list %s, got %s and:\n' "$wanted" "$part" "$*" "$code"
    cat "$folder/out"
    exit 1
  fi
}
expect 1 '  C.Terminal' 'B.Mounts: not allowed everywhere'
expect 1 '  B.Mounts' '# none'
expect 0 '' 'B.Mounts: not allowed everywhere' 'C.Terminal: no tmux'
expect 0 '' 'B.Mounts: not allowed everywhere' 'C.Terminal: no tmux' 'A.Runs: not always'
expect 1 '  C.Terminal' 'B.Mounts: not allowed everywhere' 'C.Terminal'
expect 1 '  D.Gone' 'B.Mounts: not allowed everywhere' 'C.Terminal: no tmux' 'D.Gone: was renamed'
if ./unexpected_skips.sh "$folder/nothing.xml" "$folder/list" 2>"$folder/out"; then
  echo 'results that are not there passed'
  exit 1
fi
