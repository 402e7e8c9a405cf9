#!/usr/bin/env bash
# no_calls.sh OBJDUMP OBJECT...: the kernels call nothing but memset and memcpy. A function that the compiler leaves as a call
# in the walk passes its numbers through the stack: two of them cost a fifth of the speed of one scenario.
set -euo pipefail
objdump=$1
shift
kernels=0 calls=
for object in "$@"; do
  [[ $object == *kernels_* ]] || continue
  found=$("$objdump" -d -r -C --no-show-raw-insn "$object" | awk '
    function report() { if (target != "" && target !~ /^mem(set|cpy)/) print kernel " calls " target; target = "" }
    /^[0-9a-f]+ <.*>:$/ { report(); kernel = ""; if (/ (advance|evaluate_energies)</ || /::(advance|evaluate_energies)</) { kernel = $0; print "kernel" } next }
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
if ((kernels < 144)); then
  echo "only $kernels kernels found: expected those of three instruction sets, two forms, two precisions, four numbers of lanes, three kernels each"
  exit 1
fi
echo "$kernels kernels, no call"
