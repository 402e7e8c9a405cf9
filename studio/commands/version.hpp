#pragma once

#include "engine/simulation/record.hpp"

#include <string>

namespace rift::studio {

/// Version, compiler and instruction set of this program, as every result records them.
simulation::BuildInfo build_info();

/// "rift 0.2.0 (optimised, asserts off; GCC 12.2.0; AVX2)"
std::string version_text();

/// The same, the commit that the program was built from, and the libraries that it was built with.
std::string version_and_libraries_text();

}  // namespace rift::studio
