#pragma once

#include "engine/base/world_error.hpp"
#include "engine/simulation/record.hpp"
#include "studio/charts/chart.hpp"
#include "studio/text/table.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace rift::studio {

/// A section of a report's page: HTML, a table, or charts and maps.
struct ReportSection {
  std::string title;
  std::variant<std::string, Table, std::vector<NamedChart>> content;
};

/// What every report is made of.
struct Report {
  std::string title;
  std::vector<std::string> opening = {};                        // paragraphs before the sections
  std::vector<std::pair<std::string, std::string>> files = {};  // beside the page: name and text;
                                                                // summary.json first: it tells a report that
                                                                // was cut off, which --force may replace
  std::vector<ReportSection> sections = {};
};

/// "Made by `rift accuracy quickstart`, rift 0.9 (GCC 12.2.0), in 2 min 05 s.": the compiler and the time
/// only where they are given.
std::string made_by(const std::string& command, const simulation::BuildInfo& build,
                    std::optional<double> wall_s = {});

/// Writes the files, draws charts/ and writes report.html last. Throws WorldError where a chart cannot be
/// drawn; the page is then written all the same and says so in its place.
void write_report(const Report& report, const std::filesystem::path& folder);

/// The charts as figures of a page, drawn into `folder`; what cannot be drawn is said in its place.
/// @param[out] failure  of the last one that cannot be drawn
std::string html_figures(const std::vector<NamedChart>& charts, const std::filesystem::path& folder,
                         std::optional<base::WorldError>& failure);

}  // namespace rift::studio
