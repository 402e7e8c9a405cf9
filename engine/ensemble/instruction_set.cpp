#include "engine/ensemble/instruction_set.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace rift::ensemble {
namespace {

// Kernels of which instruction sets this build has (RIFT_KERNELS); the others have none.
#ifdef RIFT_WITH_baseline
constexpr bool has_baseline = true;
#else
constexpr bool has_baseline = false;
#endif
#ifdef RIFT_WITH_avx2
constexpr bool has_avx2 = true;
#else
constexpr bool has_avx2 = false;
#endif
#ifdef RIFT_WITH_avx512
constexpr bool has_avx512 = true;
#else
constexpr bool has_avx512 = false;
#endif

constexpr std::array every_set{InstructionSet::avx512, InstructionSet::avx2, InstructionSet::baseline};

/// The best one that both this processor and this build have.
InstructionSet best_set() {
  for (const InstructionSet set : every_set)
    if (is_available(set)) return set;
  throw std::runtime_error("this build has no kernels for this processor: configure with -DRIFT_KERNELS=all");
}

}  // namespace

bool is_available(InstructionSet set) {
  __builtin_cpu_init();
  if (set == InstructionSet::avx512)
    return has_avx512 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
           __builtin_cpu_supports("avx512dq");
  if (set == InstructionSet::avx2)
    return has_avx2 && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  return has_baseline;
}

std::string_view name_of(InstructionSet set) {
  constexpr std::array<std::string_view, 3> names{"baseline", "AVX2", "AVX-512"};
  return names[static_cast<std::size_t>(set)];
}

InstructionSet instruction_set() {
  static const InstructionSet best = best_set();
  const char* wanted = std::getenv("RIFT_SIMD");
  if (wanted == nullptr || *wanted == '\0') return best;
  for (const InstructionSet set : every_set) {
    if (name_of(set) != wanted) continue;
    if (is_available(set)) return set;
    throw std::invalid_argument("RIFT_SIMD=" + std::string(wanted) +
                                ": this processor or this build has no kernels for it; the best is " +
                                std::string(name_of(best)));
  }
  throw std::invalid_argument("RIFT_SIMD=" + std::string(wanted) + ": expected baseline, AVX2 or AVX-512");
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
Kernel<Beam> kernel_for(InstructionSet set, int lanes, bool breaking) {
  Kernel<Beam> found{};
  if constexpr (has_baseline)
    if (set == InstructionSet::baseline) found = baseline::find_kernel<Beam>(lanes, breaking);
  if constexpr (has_avx2)
    if (set == InstructionSet::avx2) found = avx2::find_kernel<Beam>(lanes, breaking);
  if constexpr (has_avx512)
    if (set == InstructionSet::avx512) found = avx512::find_kernel<Beam>(lanes, breaking);
  assert(found.advance);
  return found;
}

template <class Real>
double multiply_and_add(InstructionSet set, long rounds) {
  if constexpr (has_avx512)
    if (set == InstructionSet::avx512) return avx512::multiply_and_add<Real>(rounds);
  if constexpr (has_avx2)
    if (set == InstructionSet::avx2) return avx2::multiply_and_add<Real>(rounds);
  if constexpr (has_baseline) return baseline::multiply_and_add<Real>(rounds);
  return 0.0;
}

template Kernel<LinearBeam<double>> kernel_for(InstructionSet, int, bool);
template Kernel<LinearBeam<float>> kernel_for(InstructionSet, int, bool);
template Kernel<CorotationalBeam<double>> kernel_for(InstructionSet, int, bool);
template Kernel<CorotationalBeam<float>> kernel_for(InstructionSet, int, bool);
template double multiply_and_add<double>(InstructionSet, long);
template double multiply_and_add<float>(InstructionSet, long);

}  // namespace rift::ensemble
