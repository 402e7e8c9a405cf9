#include "engine/ensemble/instruction_set.hpp"

#include <algorithm>
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
  switch (set) {
    case InstructionSet::baseline:
      return "baseline";
    case InstructionSet::avx2:
      return "AVX2";
    case InstructionSet::avx512:
      return "AVX-512";
  }
  return "";
}

InstructionSet instruction_set() {
  static const InstructionSet best = of_processor();
  const char* wanted = std::getenv("RIFT_SIMD");
  if (wanted == nullptr) return best;
  for (const InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2})
    if (set < best && name_of(set) == wanted) return set;
  return best;
}

template <class Real>
int lanes_in_register(InstructionSet set) {
  const int bytes = set == InstructionSet::baseline ? 16 : set == InstructionSet::avx2 ? 32 : 64;
  return bytes / static_cast<int>(sizeof(Real));
}

template <class Real>
int lanes_for(int scenarios) {
  int lanes = most_lanes<Real>;
  while (lanes > 1 && scenarios <= lanes / 2) lanes /= 2;
  return scenarios > 1 ? std::max(lanes, most_lanes<Real> / 4) : 1;
}

template <class Real>
Kernel<Real> kernel_for(InstructionSet set, lattice::Kinematics kinematics, int lanes) {
  const bool turning = kinematics == lattice::Kinematics::corotational;
  Kernel<Real> found;
  switch (set) {
    case InstructionSet::baseline:
      found = baseline::find_kernel(Real{}, lanes, turning);
      break;
    case InstructionSet::avx2:
      found = avx2::find_kernel(Real{}, lanes, turning);
      break;
    case InstructionSet::avx512:
      found = avx512::find_kernel(Real{}, lanes, turning);
      break;
  }
  assert(found.advance);
  return found;
}

template <class Real>
double multiply_and_add(InstructionSet set, long rounds) {
  switch (set) {
    case InstructionSet::baseline:
      return baseline::multiply_and_add(Real{}, rounds);
    case InstructionSet::avx2:
      return avx2::multiply_and_add(Real{}, rounds);
    case InstructionSet::avx512:
      return avx512::multiply_and_add(Real{}, rounds);
  }
  return 0.0;
}

template double multiply_and_add<double>(InstructionSet, long);
template double multiply_and_add<float>(InstructionSet, long);
template int lanes_in_register<double>(InstructionSet);
template int lanes_in_register<float>(InstructionSet);
template int lanes_for<double>(int);
template int lanes_for<float>(int);
template Kernel<double> kernel_for<double>(InstructionSet, lattice::Kinematics, int);
template Kernel<float> kernel_for<float>(InstructionSet, lattice::Kinematics, int);

}  // namespace rift::ensemble
