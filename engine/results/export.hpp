#pragma once

#include "engine/results/schema.hpp"

#include <cstdint>
#include <filesystem>
#include <span>

namespace rift::results {

/// Writes one moment as a VTK XML PolyData file (.vtp): elements as vertices, beams as lines, radius, and of
/// each frame the fields it has, named as in the archive. Binary, appended raw, little-endian, 64-bit sizes;
/// read by every ParaView and by VTK from 5.10 on. The file appears whole or not at all. Throws WorldError.
/// @param frames  of one moment, a lane each; none: the geometry alone
/// @param lanes   of the run: with several, names carry their lane
void write_vtp(const std::filesystem::path& path, const Geometry& geometry, std::span<const Frame> frames,
               std::int32_t lanes);

/// `ovito/` in the run's folder, in the text formats of LAMMPS that OVITO reads: run.dump (elements: id,
/// type, radius, position as deformed, and the stored fields) and, where damage is stored, beams.dump (the
/// beams that still bear something: index, atom1, atom2, factor), a snapshot for each moment; files of their
/// own for each lane where there are several (run_lane1.dump). A run without frames gives its elements,
/// unloaded. Works for unfinished and damaged runs, up to where they are whole. Memory O(geometry + one
/// frame). Throws WorldError.
/// @return the folder
std::filesystem::path export_ovito(const std::filesystem::path& run_folder);

// A run in other programs' formats, from what is whole of its journal: works for unfinished and damaged runs
// too. All throw WorldError where the folder holds no journal or no geometry, or a file cannot be written.

/// `csv/` in the run's folder: series.csv (as in the run), events.csv (a row per released beam), rate.csv
/// (release rate against tip position, per lane), crack.csv (tip position and velocity against time, per
/// lane).
/// @return the folder
std::filesystem::path export_csv(const std::filesystem::path& run_folder);

/// `pvd/` in the run's folder: run.pvd and a frame_000000.vtp for each moment that has frames (the geometry
/// alone where there are none). Memory O(geometry + the frames of one moment).
/// @return the .pvd file
std::filesystem::path export_pvd(const std::filesystem::path& run_folder);

/// `run.vtkhdf` of the run, for ParaView 5.12 or later: the one in its folder where the run has ended; else
/// `paraview/run.vtkhdf`, assembled now.
/// @return the file
std::filesystem::path export_vtkhdf(const std::filesystem::path& run_folder);

}  // namespace rift::results
