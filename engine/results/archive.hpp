#pragma once

#include <filesystem>

namespace rift::results {

/// Names of the files in a run's folder.
inline constexpr const char* journal_name = "journal.rift";
inline constexpr const char* archive_name = "run.vtkhdf";
inline constexpr const char* series_name = "series.csv";
inline constexpr const char* gauges_name = "gauges.csv";  // where there are gauges
inline constexpr const char* summary_name = "summary.json";
/// The effective preset of a run that was steered, with its changes: `rift run --replay` takes it.
inline constexpr const char* steering_name = "steering.toml";

/// Writes `run.vtkhdf` from what is whole of `journal.rift`, under a temporary name that is renamed when
/// complete. /VTKHDF follows the VTKHDF specification, version 2.0, PolyData; /series, /crack, /events and
/// /scene lie beside it (docs/results-format.md). Without frames the file is static: the geometry alone.
/// Reads the journal twice; memory O(geometry + samples + the frames of one moment).
/// Throws WorldError where the journal is missing or holds no geometry, or a file cannot be read or written.
/// @param target  the file; in the run's folder under its name where it is not given
void assemble_archive(const std::filesystem::path& run_folder, const std::filesystem::path& target = {});

}  // namespace rift::results
