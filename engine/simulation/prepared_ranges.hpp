#pragma once

#include "engine/scene/derived_ranges.hpp"
#include "engine/simulation/prepare.hpp"

#include <vector>

/// What follows from a scene with its lattice, and the numbers that it may be; asked for as soon as each is
/// known, before anything is computed with it.
namespace rift::simulation {

/// Throws InputError with all that are out of their ranges.
void refuse_out_of_range(const Prepared& p, const std::vector<scene::DerivedNumber>& numbers);

/// Masses, inertias and stiffnesses of the lattice, the least and the greatest of each: such that neither
/// they nor their reciprocals leave what the precision of the run holds.
std::vector<scene::DerivedNumber> lattice_numbers(const Prepared& p);

/// The strain that the grip's displacement makes, where it follows from a force or a curve.
std::vector<scene::DerivedNumber> pull_numbers(const Prepared& p);

/// G_I0, the energy stored and the grip's force, whatever their signs.
std::vector<scene::DerivedNumber> prestress_numbers(const Prepared& p);

std::vector<scene::DerivedNumber> critical_step_numbers(const Prepared& p);

/// The step, and how many of them each lane takes.
std::vector<scene::DerivedNumber> step_numbers(const Prepared& p);

}  // namespace rift::simulation
