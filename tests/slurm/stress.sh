#!/usr/bin/env bash
# stress.sh RIFT [ARRAYS [KILLS]]: what docs/scaling.md says of studies under Slurm, measured on a Slurm of this machine alone. As root;
# some ten minutes for 50 arrays and 20 kills.
set -euo pipefail
rift=$(realpath "$1") arrays=${2:-50} kills=${3:-20}
here=$(cd "$(dirname "$0")" && pwd)
. "$here/tiny_study.sh"
work=$(mktemp -d)
trap '"$here/slurm_of_one_node.sh" stop "$work/slurm"; rm -rf "$work"' EXIT
"$here/slurm_of_one_node.sh" start "$work/slurm"
export SLURM_CONF=$work/slurm/slurm.conf
cd "$work"
preset '' 'crack_velocity = ["0.2 c_r", "0.3 c_r", "0.4 c_r", "0.5 c_r", "0.7 c_r", "0.9 c_r"]
seed = [1, 2]' >short.toml
preset 'dt_fraction = 0.0004' 'crack_velocity = ["0.1 c_r", "0.12 c_r", "0.14 c_r", "0.16 c_r", "0.2 c_r", "0.3 c_r"]
seed = [1, 2, 3, 4]' >long.toml

until_the_queue_is_empty() { while [ -n "$(squeue --noheader)" ]; do sleep 1; done; }
states() { tr ' ' '\n' <"$work/slurm/log/jobcomp.txt" | grep '^JobState=' | sort | uniq -c | tr '\n' ' '; }

"$rift" study short.toml --quiet --out short_whole >/dev/null
SECONDS=0
for k in $(seq "$arrays"); do
  "$rift" study short.toml --slurm --tasks 4 --time 00:10:00 --quiet --out "short_$k" >/dev/null 2>&1
done
until_the_queue_is_empty
wrong=0 packed=0
for k in $(seq "$arrays"); do
  [ "$(lasting "short_$k/table.csv")" = "$(lasting short_whole/table.csv)" ] || wrong=$((wrong + 1))
  packed=$((packed + $(python3 -c 'import csv, sys; print(sum(row["packing_from_cache"] != "true" for row in csv.DictReader(open(sys.argv[1]))))' "short_$k/table.csv")))
done
echo "$arrays arrays of 4 tasks in $SECONDS s: $(states); $wrong tables that differ from one process's; $packed scenarios whose task packed by itself"

"$rift" study long.toml --quiet --yes --out long_whole >/dev/null
: >"$work/slurm/log/jobcomp.txt"
SECONDS=0 done=0 kill9=0 scancels=0
"$rift" study long.toml --slurm --tasks 4 --time 00:10:00 --quiet --out long >/dev/null 2>&1
array=$(python3 -c 'import json; print(json.load(open("long/slurm/jobs.json"))["compute"])')
while [ $done -lt "$kills" ] && squeue --noheader --jobs "$array" 2>/dev/null | grep -q .; do
  sleep $((RANDOM % 3 + 1)).$((RANDOM % 10))
  if [ $((RANDOM % 5)) = 0 ]; then
    task=$(squeue --noheader --states=RUNNING --format=%i --jobs "$array" | shuf -n 1 || true)
    [ -z "$task" ] || { scancel "$task"; scancels=$((scancels + 1)) done=$((done + 1)); }
  else
    victim=$(pgrep -f -- "long --yes.*--claim" | shuf -n 1 || true)
    [ -z "$victim" ] || { kill -9 "$victim" 2>/dev/null && kill9=$((kill9 + 1)) done=$((done + 1)); }
  fi
done
until_the_queue_is_empty
same=differs
[ "$(lasting long/table.csv)" = "$(lasting long_whole/table.csv)" ] && same='is the same'
echo "$kill9 kills by signal 9 and $scancels by scancel in $SECONDS s: $(states); the table $same as of one process"
