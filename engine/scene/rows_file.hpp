#pragma once

#include "engine/scene/parameters.hpp"
#include "engine/scene/preset.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rift::scene {

/// The rows of a CSV file that stands for a parameter's list, as the list would be written in a preset.
struct RowsFile {
  Value rows;
  RowsOrigin origin;
  std::vector<Issue> issues;  // of the file, by line; the rows count only without any
};

/// Whether `value` names a file of rows for this parameter: crack.history, crack.toughness, loading.curve,
/// and crack.path where the name ends in ".csv".
bool names_rows_file(const Parameter& row, const Value& value);

/// Never throws for bad input, a missing file included.
/// @param[in] name  as written, found from `folder`
RowsFile read_rows_file(const Parameter& row, const std::string& name, const std::filesystem::path& folder);

}  // namespace rift::scene
