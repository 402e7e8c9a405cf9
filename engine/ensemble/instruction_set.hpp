#pragma once

#include "engine/ensemble/part.hpp"
#include "engine/lattice/beam.hpp"

#include <string_view>

namespace rift::ensemble {

/// The numbers of the state; energies are summed in double.
enum class Precision { double_precision, single_precision };

/// Vector instructions that the kernels are compiled for; each includes the ones before.
enum class InstructionSet { baseline, avx2, avx512 };

std::string_view name_of(InstructionSet set);

/// The best one that this processor has, or the lesser one that $RIFT_SIMD names ("baseline", "AVX2",
/// "AVX-512").
InstructionSet instruction_set();

/// Every instruction set has kernels for 1 lane and for a half, a quarter and all of this many (of 64 bytes).
template <class Real>
inline constexpr int most_lanes = 64 / static_cast<int>(sizeof(Real));

/// Lanes that fill a register: the fastest a lane.
template <class Real>
int lanes_in_register(InstructionSet set);

/// The fewest lanes there are kernels for that hold `scenarios`, or most_lanes.
template <class Real>
int lanes_for(int scenarios);

/// @param[in] lanes  1 or most_lanes, a half or a quarter of it
template <class Real>
Kernel<Real> kernel_for(InstructionSet set, lattice::Kinematics kinematics, int lanes);

/// Multiplies and adds, `rounds` times in every register; returns the floating-point operations done.
template <class Real>
double multiply_and_add(InstructionSet set, long rounds);

// One namespace an instruction set, one source file each, compiled with its flags (see
// engine/CMakeLists.txt). Without a kernel for the lanes the result is empty. `Real` is chosen by the first
// argument's type.

namespace baseline {
Kernel<double> find_kernel(double, int lanes, bool corotational);
Kernel<float> find_kernel(float, int lanes, bool corotational);
double multiply_and_add(double, long rounds);
double multiply_and_add(float, long rounds);
}  // namespace baseline
namespace avx2 {
Kernel<double> find_kernel(double, int lanes, bool corotational);
Kernel<float> find_kernel(float, int lanes, bool corotational);
double multiply_and_add(double, long rounds);
double multiply_and_add(float, long rounds);
}  // namespace avx2
namespace avx512 {
Kernel<double> find_kernel(double, int lanes, bool corotational);
Kernel<float> find_kernel(float, int lanes, bool corotational);
double multiply_and_add(double, long rounds);
double multiply_and_add(float, long rounds);
}  // namespace avx512

}  // namespace rift::ensemble
