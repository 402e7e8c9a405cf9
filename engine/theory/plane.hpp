#pragma once

namespace rift::theory {

/// Which plane elasticity the material constants and the references are read in.
enum class Plane { stress, strain };

}  // namespace rift::theory
