#pragma once

#include "engine/ensemble/part.hpp"

#include <string_view>

namespace rift::ensemble {

/// The precision of the state; energies are summed in double.
enum class Precision { double_precision, single_precision };

/// Vector instructions that the kernels are compiled for; each includes the ones before.
enum class InstructionSet { baseline, avx2, avx512 };

std::string_view name_of(InstructionSet set);

/// Whether this processor has it and this build its kernels (RIFT_KERNELS).
bool is_available(InstructionSet set);

/// The best one that is available, or the one that $RIFT_SIMD names ("baseline", "AVX2", "AVX-512").
/// @throws std::invalid_argument  that one is not available, or is none
/// @throws std::runtime_error  none is available
InstructionSet instruction_set();

/// Every instruction set has kernels for 1 lane and for a half, a quarter and all of this many (of 64 bytes).
constexpr int most_lanes(Precision precision) { return precision == Precision::double_precision ? 8 : 16; }

/// Lanes that fill a register: the fastest a lane.
int lanes_in_register(Precision precision, InstructionSet set);

/// The fewest lanes there are kernels for that hold `scenarios`, or most_lanes().
int lanes_for(Precision precision, int scenarios);

/// @param[in] lanes     1 or most_lanes(), a half or a quarter of it
/// @param[in] breaking  whether the intact beams break by themselves; linear ones only
template <class Beam>
Kernel<Beam> kernel_for(InstructionSet set, int lanes, bool breaking);

/// Multiplies and adds, `rounds` times in every register; returns the floating-point operations done.
template <class Real>
double multiply_and_add(InstructionSet set, long rounds);

// One namespace an instruction set, one source file each, compiled with its flags (see
// engine/CMakeLists.txt). Without a kernel for the lanes the result is empty.

namespace baseline {
template <class Beam>
Kernel<Beam> find_kernel(int lanes, bool breaking);
template <class Real>
double multiply_and_add(long rounds);
}  // namespace baseline
namespace avx2 {
template <class Beam>
Kernel<Beam> find_kernel(int lanes, bool breaking);
template <class Real>
double multiply_and_add(long rounds);
}  // namespace avx2
namespace avx512 {
template <class Beam>
Kernel<Beam> find_kernel(int lanes, bool breaking);
template <class Real>
double multiply_and_add(long rounds);
}  // namespace avx512

}  // namespace rift::ensemble
