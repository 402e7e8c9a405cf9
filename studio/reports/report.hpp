#pragma once

#include "engine/base/world_error.hpp"
#include "engine/scene/scene.hpp"
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

/// A section of a report's page: HTML, a table, or charts and maps, below a paragraph where there is a note.
/// One without content is left out.
struct ReportSection {
  std::string title;
  std::variant<std::string, Table, std::vector<NamedChart>> content;
  std::string note = {};
};

/// By what a report was made; its page says when and on which machine too.
struct Made {
  std::string command = {};
  simulation::BuildInfo build = {};
  std::optional<double> wall_s = {};  // of the call
};

/// What every report is made of.
struct Report {
  std::string title;
  Made made = {};
  std::vector<std::string> opening = {};  // paragraphs before the sections
  std::vector<scene::Scene> scenes = {};  // what was computed: its fixed parameters, and
                                          // what it leaves out, stand below the sections
  bool marched = true;                    // they are not, where only their specimens and
                                          // beams are of interest
  std::vector<std::pair<std::string, std::string>> files = {};  // beside the page: name and text;
                                                                // summary.json first: it tells a report that
                                                                // was cut off, which --force may replace
  std::vector<ReportSection> sections = {};
};

/// "2026-11-30".
std::string today_text();

/// "quickstart" of "/home/a/presets/quickstart.toml", as titles have it.
std::string preset_in_titles(const std::string& preset);

/// By which command, version and machine a page was made, when, and how long that took: a table.
std::string html_made(const Made& made);

/// What all of these scenes share: their parameters by their keys in a preset, and what all of them leave
/// out, a line each; of scenes that were not marched the specimen's and the material's parameters alone.
struct SharedParts {
  std::vector<std::pair<std::string, std::string>> parameters;
  std::vector<std::string> left_out;
};
SharedParts shared_parts(const std::vector<scene::Scene>& scenes, bool marched = true);

/// Two sections: the parameters that all of these scenes share, by their keys in a preset, and what all of
/// them leave out; of scenes that were not marched the specimen's and the material's alone. Empty where there
/// are no scenes.
std::string html_scenes(const std::vector<scene::Scene>& scenes, bool marched = true);

/// Writes the files, draws charts/ and writes report.html last. Throws WorldError where a chart cannot be
/// drawn; the page is then written all the same and says so in its place.
void write_report(const Report& report, const std::filesystem::path& folder);

/// The charts as figures of a page, drawn into `folder`; what cannot be drawn is said in its place.
/// @param[out] failure  of the last one that cannot be drawn
std::string html_figures(const std::vector<NamedChart>& charts, const std::filesystem::path& folder,
                         std::optional<base::WorldError>& failure);

}  // namespace rift::studio
