#include "engine/ensemble/instruction_set.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdlib>

namespace rift::ensemble {
namespace {

InstructionSet of_processor() {
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512dq"))
    return InstructionSet::avx512;
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return InstructionSet::avx2;
  return InstructionSet::baseline;
}

}  // namespace

std::string_view name_of(InstructionSet set) {
  constexpr std::array<std::string_view, 3> names{"baseline", "AVX2", "AVX-512"};
  return names[static_cast<std::size_t>(set)];
}

InstructionSet instruction_set() {
  static const InstructionSet best = of_processor();
  const char* wanted = std::getenv("RIFT_SIMD");
  if (wanted == nullptr) return best;
  for (const InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2})
    if (set < best && name_of(set) == wanted) return set;
  return best;
}

int lanes_in_register(Precision precision, InstructionSet set) {
  const int bytes = set == InstructionSet::baseline ? 16 : set == InstructionSet::avx2 ? 32 : 64;
  return bytes / (precision == Precision::double_precision ? 8 : 4);
}

int lanes_for(Precision precision, int scenarios) {
  const int most = most_lanes(precision);
  int lanes = most;
  while (lanes > 1 && scenarios <= lanes / 2) lanes /= 2;
  return scenarios > 1 ? std::max(lanes, most / 4) : 1;
}

template <class Beam>
Kernel<Beam> kernel_for(InstructionSet set, int lanes) {
  const Kernel<Beam> found = set == InstructionSet::baseline ? baseline::find_kernel<Beam>(lanes)
                             : set == InstructionSet::avx2   ? avx2::find_kernel<Beam>(lanes)
                                                             : avx512::find_kernel<Beam>(lanes);
  assert(found.advance);
  return found;
}

template <class Real>
double multiply_and_add(InstructionSet set, long rounds) {
  return set == InstructionSet::baseline ? baseline::multiply_and_add<Real>(rounds)
         : set == InstructionSet::avx2   ? avx2::multiply_and_add<Real>(rounds)
                                         : avx512::multiply_and_add<Real>(rounds);
}

template Kernel<LinearBeam<double>> kernel_for(InstructionSet, int);
template Kernel<LinearBeam<float>> kernel_for(InstructionSet, int);
template Kernel<CorotationalBeam<double>> kernel_for(InstructionSet, int);
template Kernel<CorotationalBeam<float>> kernel_for(InstructionSet, int);
template double multiply_and_add<double>(InstructionSet, long);
template double multiply_and_add<float>(InstructionSet, long);

}  // namespace rift::ensemble
