#!/usr/bin/env bash
# Makes twin_history.csv and twin_instruments.csv anew: a crack that runs by itself by a known law (twin_toughness.csv),
# seen every 5 us from 22 mm on with normal noise of 0.3 mm; and the load cell and two strain gauges of that test, with
# normal noise of 1 % of what they show at first. From the project's root: presets/measured/make_twin.sh [RIFT]
set -euo pipefail
cd "$(dirname "$0")/../.."
rift=${1:-./rift}
run=$(mktemp -d)
trap 'rm -rf "$run"' EXIT
"$rift" run experiment_truth --set output.frames=0 --out "$run/truth" --quiet >/dev/null
{
  echo "# Synthetic: made by make_twin.sh from a run of experiment_truth, with normal noise of 0.3 mm; the truth is twin_toughness.csv"
  echo "time [us];position [mm];uncertainty [mm]"
  awk -F, -v start=22 -v apart=5 -v noise=0.3 '
    function normal() { return sqrt(-2 * log(1 - rand())) * cos(6.283185307 * rand()) }
    BEGIN { srand(3) }
    NR > 1 {
      t = $2 * 1e6; a = $5 * 1e3
      if (!begun && a >= start) { zero = t0 + (start - a0) / (a - a0) * (t - t0); begun = 1; printf "0;%g;%g\n", start, noise }
      while (begun && zero + (n + 1) * apart <= t) {
        ++n; now = zero + n * apart
        printf "%d;%.3f;%g\n", n * apart, a0 + (now - t0) / (t - t0) * (a - a0) + noise * normal(), noise
      }
      t0 = t; a0 = a
    }' "$run/truth/series.csv"
} >presets/measured/twin_history.csv
{
  echo "# Synthetic: made by make_twin.sh from a run of experiment_truth, with normal noise of 1 %; for rift measure --against"
  echo "time [us];grip_force [N];gauge0_strain_yy;gauge1_strain_yy"
  awk -F, -v start=22 -v apart=5 -v noise=0.01 '
    function normal() { return sqrt(-2 * log(1 - rand())) * cos(6.283185307 * rand()) }
    BEGIN { srand(5) }
    FILENAME ~ /gauges/ { strain[$1, $4] = $14; next }
    FNR > 1 {
      t = $2 * 1e6; a = $5 * 1e3
      now["force"] = $17; now[0] = strain[$1, 0]; now[1] = strain[$1, 1]
      if (FNR == 2) for (k in now) first[k] = now[k]
      if (!begun && a >= start) { zero = t0 + (start - a0) / (a - a0) * (t - t0); begun = 1; n = 0 }
      for (; begun && zero + n * apart <= t; ++n) {
        part = (zero + n * apart - t0) / (t - t0)
        for (k in now) seen[k] = before[k] + part * (now[k] - before[k]) + noise * first[k] * normal()
        printf "%d;%.1f;%.6f;%.6f\n", n * apart, seen["force"], seen[0], seen[1]
      }
      t0 = t; a0 = a
      for (k in now) before[k] = now[k]
    }' "$run/truth/gauges.csv" "$run/truth/series.csv"
} >presets/measured/twin_instruments.csv
