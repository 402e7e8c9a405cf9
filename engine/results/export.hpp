#pragma once

#include <filesystem>

/// A run in other programs' formats, from what is whole of its journal: works for unfinished and damaged runs
/// too. All throw WorldError where the folder holds no journal or no geometry, or a file cannot be written.
namespace rift::results {

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
