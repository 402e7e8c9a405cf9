#pragma once

#include "engine/study/runner.hpp"
#include "engine/study/series_table.hpp"

#include <filesystem>
#include <map>
#include <string>

namespace rift::studio {

/// Finds a scenario's series among the files of a study: runs/<hash>.json holds the numbers of the row whose
/// series is runs/<hash>.csv.
class StoredSeries {
 public:
  /// Reads every runs/*.json of the study's folder; what is not JSON is passed over.
  explicit StoredSeries(const std::filesystem::path& folder);

  /// The series of a row, read anew; empty where none is stored.
  SeriesTable of(const SummaryRow& row) const;

 private:
  std::map<std::string, std::filesystem::path> file_;  // by what tells scenarios apart
};

}  // namespace rift::studio
