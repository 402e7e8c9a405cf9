#include "studio/report/stored_series.hpp"

#include <fstream>

namespace rift::studio {
namespace fs = std::filesystem;
namespace {

/// What tells scenarios apart: their settings, and their results to the last bit for settings that a summary
/// does not name (the path).
std::string identity(const SummaryRow& row) {
  std::string text;
  for (const char* name : {"technique",
                           "relaxation",
                           "damage_zone_ratio",
                           "damping_alpha",
                           "damping_region",
                           "crack_velocity_over_cr",
                           "elements",
                           "length_m",
                           "seed",
                           "stiffness",
                           "plane",
                           "dt_s",
                           "beta",
                           "precision",
                           "kinematics",
                           "prestress_method",
                           "steps",
                           "ratio",
                           "ratio_release",
                           "energy_fracture_j"}) {
    const auto found = row.find(name);
    text += (found == row.end() ? "-" : found->dump()) + ";";
  }
  return text;
}

}  // namespace

StoredSeries::StoredSeries(const fs::path& folder) {
  std::error_code ignored;  // no folder, no series
  for (const auto& entry : fs::directory_iterator(folder / "runs", ignored)) {
    if (entry.path().extension() != ".json") continue;
    std::ifstream file(entry.path());
    const SummaryRow row = SummaryRow::parse(file, nullptr, false);
    if (row.is_object()) file_[identity(row)] = fs::path(entry.path()).replace_extension(".csv");
  }
}

SeriesTable StoredSeries::of(const SummaryRow& row) const {
  const auto found = file_.find(identity(row));
  return found == file_.end() ? SeriesTable{} : read_series(found->second);
}

}  // namespace rift::studio
