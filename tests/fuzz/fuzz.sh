#!/usr/bin/env bash
# Fuzzes every target with libFuzzer and says what came of it: executions, edges reached of those there are.
#   tests/fuzz/fuzz.sh [RUNS] [TARGET...]     RUNS of each target (default 20000); all targets without names
# Needs clang. SANITIZE= (empty) builds without sanitizers, ten times as fast. New inputs go to build/fuzz_corpus.
set -euo pipefail
cd "$(dirname "$0")/../.."
runs=${1:-20000}
shift || true
targets=("$@")
[ ${#targets[@]} -gt 0 ] || targets=(preset crack_history measured_curve journal archive checkpoint study_result)
folder=build/fuzz
[ "${SANITIZE-address,undefined}" ] || folder=build/fuzz_plain
cmake --preset fuzz -B "$folder" -DRIFT_SANITIZE="${SANITIZE-address,undefined}" >/dev/null
cmake --build "$folder" --target "${targets[@]/#/fuzz_}"
failed=0
printf '%-14s %12s %16s %10s\n' target executions 'edges reached' 'of'
for target in "${targets[@]}"; do
  mkdir -p "build/fuzz_corpus/$target"
  log="build/fuzz_corpus/$target.log"
  if ! "$folder/tests/fuzz/fuzz_$target" -runs="$runs" -max_len=1500 -timeout=20 -rss_limit_mb=2048 \
      -malloc_limit_mb=1024 -artifact_prefix="build/fuzz_corpus/$target-" "build/fuzz_corpus/$target" \
      "tests/fuzz/corpus/$target" >"$log" 2>&1; then
    failed=1
    echo "$target failed: $log" >&2
  fi
  edges=$(sed -n 's/.*Loaded 1 modules *(\([0-9]*\) inline.*/\1/p' "$log")
  sed -n 's/^#\([0-9]*\)[[:space:]]*DONE *cov: \([0-9]*\).*/\1 \2/p' "$log" |
    while read -r done reached; do printf '%-14s %12s %16s %10s\n' "$target" "$done" "$reached" "$edges"; done
done
exit $failed
