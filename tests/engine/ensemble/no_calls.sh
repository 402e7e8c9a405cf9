#!/usr/bin/env bash
# no_calls.sh OBJDUMP SETS OBJECT...: the kernels of that many instruction sets call nothing but memset, memcpy and, once a
# part and step, the loads of the few and of the neighbours' elements, which call nothing either. A function that the compiler leaves as a call
# in the walk passes its numbers through the stack: two of them cost a fifth of the speed of one scenario.
set -euo pipefail
objdump=$1 sets=$2
shift 2
kernels=0 calls=
for object in "$@"; do
  found=$("$objdump" -d -r -C --no-show-raw-insn "$object" | awk '
    function report() { if (target != "" && target !~ /^mem(set|cpy)|(add_extra_forces|walk_halo)</) print kernel " calls " target; target = "" }
    /^[0-9a-f]+ <.*>:$/ { report(); kernel = ""; if (/[ :](advance|find_means|add_extra_forces|walk_halo)</) kernel = $0; if (/[ :]advance</) print "kernel"; next }
    kernel == "" { next }
    /R_X86_64_/ { if (target != "") { target = $0; sub(/.*R_X86_64_[A-Z0-9]+[ \t]+/, "", target) } next }
    { report() }
    /\tcall/ { target = $0; sub(/.*\tcall[ \t]+/, "", target); sub(/^[0-9a-f]+ </, "", target) }
    END { report() }')
  kernels=$((kernels + $(grep -c '^kernel$' <<< "$found" || true)))
  calls+=$(grep -v '^kernel$' <<< "$found" || true)
done
if [[ -n $calls ]]; then
  echo "$calls"
  exit 1
fi
expected=$((sets * 3 * 2 * 4 * 3))
if ((kernels != expected)); then
  echo "$kernels kernels found, expected $expected: of $sets instruction sets, two forms and linear beams that break, two precisions, four numbers of lanes, three kernels each"
  exit 1
fi
echo "$kernels kernels, no call"
