#pragma once

#include "engine/ensemble/part.hpp"

/// One namespace an instruction set, one source file each, compiled with its flags (see
/// engine/CMakeLists.txt). Without a kernel for the lanes the result is empty. `Real` is chosen by the first
/// argument's type.
namespace rift::ensemble {
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
