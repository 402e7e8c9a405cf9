#pragma once

#include "engine/ensemble/part.hpp"

/// One namespace an instruction set, one source file each, compiled with its flags (see
/// engine/CMakeLists.txt). Without a kernel for the lanes the result is empty. `Real` is chosen by the first
/// argument's type.
namespace rift {
namespace baseline {
Kernel<double> find_kernel(double, int lanes, bool corotational);
Kernel<float> find_kernel(float, int lanes, bool corotational);
}  // namespace baseline
namespace avx2 {
Kernel<double> find_kernel(double, int lanes, bool corotational);
Kernel<float> find_kernel(float, int lanes, bool corotational);
}  // namespace avx2
namespace avx512 {
Kernel<double> find_kernel(double, int lanes, bool corotational);
Kernel<float> find_kernel(float, int lanes, bool corotational);
}  // namespace avx512
}  // namespace rift
