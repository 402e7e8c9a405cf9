#pragma once

#include <filesystem>

namespace rift::results {

/// `ovito/` in the run's folder, in the text formats of LAMMPS that OVITO reads: run.dump (elements: id,
/// type, radius, position as deformed, and the stored fields) and, where damage is stored, beams.dump (the
/// beams that still bear something: index, atom1, atom2, factor), a snapshot for each moment; files of their
/// own for each lane where there are several (run_lane1.dump). A run without frames gives its elements,
/// unloaded. Works for unfinished and damaged runs, up to where they are whole. Memory O(geometry + one
/// frame). Throws WorldError.
/// @return the folder
std::filesystem::path export_ovito(const std::filesystem::path& run_folder);

}  // namespace rift::results
