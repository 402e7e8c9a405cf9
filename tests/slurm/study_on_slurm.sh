#!/usr/bin/env bash
# study_on_slurm.sh SOURCE RIFT: a study on a real Slurm of one node, which this script starts as root and ends again. Exit code
# 77, which means skipped, with the reason where Slurm is not installed or does not start.
set -euo pipefail
source=$1 rift=$2
here=$(cd "$(dirname "$0")" && pwd)
. "$here/tiny_study.sh"
work=$(mktemp -d)
trap '"$here/slurm_of_one_node.sh" stop "$work/slurm" >/dev/null 2>&1; rm -rf "$work"' EXIT
fail() {
  echo "$*" >&2
  tail -n 20 "$work"/*/slurm/*.log "$work"/slurm/log/*.log 2>/dev/null >&2 || true
  exit 1
}
if ! reason=$("$here/slurm_of_one_node.sh" start "$work/slurm" 2>&1); then
  echo "skipped: $reason"
  exit 77
fi
export SLURM_CONF=$work/slurm/slurm.conf
cd "$work"
preset '' 'crack_velocity = ["0.3 c_r", "0.5 c_r", "0.9 c_r"]
seed = [1, 2, 3]' >tiny.toml

wait_for() {  # FILE: until it is there
  for _ in $(seq 600); do [ ! -e "$1" ] || return 0; sleep 0.2; done
  squeue >&2
  fail "$1 did not come"
}

"$rift" study tiny.toml --quiet --out whole >/dev/null

# 1. rift study --slurm
"$rift" study tiny.toml --slurm --tasks 2 --time 00:05:00 --out own >submitted.txt || fail "it was not submitted"
grep -q '9 of 9 scenarios are missing' submitted.txt || fail "$(cat submitted.txt)"
"$rift" study tiny.toml --slurm --tasks 2 --time 00:05:00 --out own >again.txt 2>&1 || fail "$(cat again.txt)"
grep -q 'nothing was submitted' again.txt || fail "it was submitted twice: $(cat again.txt)"
wait_for own/report.html
for _ in $(seq 100); do [ -n "$(squeue -h)" ] || break; sleep 0.2; done
[ "$(lasting own/table.csv)" = "$(lasting whole/table.csv)" ] || fail "the tables differ"
"$rift" study tiny.toml --status --json --out own >status.json
python3 - status.json <<'P' || fail "$(cat status.json)"
import json, sys
status = json.load(open(sys.argv[1]))
assert status["done"] == status["scenarios"] == 9 and not status["workers"], status
assert {job["state"] for job in status["slurm"]} == {"COMPLETED"}, status
assert {job["stage"] for job in status["slurm"]} == {"prepare", "compute", "report"}, status
P
python3 - own/table.csv <<'P' || fail "a task has packed although the preparation had"
import csv, sys
assert all(row["packing_from_cache"] == "true" for row in csv.DictReader(open(sys.argv[1])))
P

# 2. a partition that is not there
code=0
"$rift" study tiny.toml --slurm --partition nowhere --out other >refused.txt 2>&1 || code=$?
[ "$code" = 2 ] && grep -q 'partition nowhere.*it has main' refused.txt || fail "code $code: $(cat refused.txt)"

# 3. the scripts of the documentation, as they stand
sed -n '/^<!-- slurm -->$/,/^<!-- \/slurm -->$/p' "$source/docs/studies.md" | sed -n '/^```sh$/,/^```$/p' | grep -v '^```' >recipe.sh
[ -s recipe.sh ] || fail "docs/studies.md has no recipe for Slurm"
export SCRATCH=$work/scratch
mkdir -p "$SCRATCH" presets
cp tiny.toml presets/big.toml
ln -s "$rift" rift
RIFT_PRESETS=$work/presets bash recipe.sh >recipe.txt 2>&1 || fail "$(cat recipe.txt)"
wait_for scratch/big/report.html
[ "$(lasting scratch/big/table.csv)" = "$(lasting whole/table.csv)" ] || fail "the tables of the recipe differ"
for _ in $(seq 100); do [ -n "$(squeue -h)" ] || break; sleep 0.2; done
grep -q 'JobState=FAILED\|JobState=CANCELLED' "$work/slurm/log/jobcomp.txt" && fail "$(cat "$work/slurm/log/jobcomp.txt")"
exit 0
