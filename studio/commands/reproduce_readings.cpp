#include "studio/commands/reproduce_readings.hpp"

#include "engine/base/console.hpp"
#include "engine/base/files.hpp"
#include "engine/study/runner.hpp"
#include "engine/study/store.hpp"
#include "studio/commands/chosen_claims.hpp"
#include "studio/commands/version.hpp"
#include "studio/reports/readings.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <utility>

namespace rift::studio {
namespace fs = std::filesystem;
namespace {

constexpr std::array seeds{1, 2, 3};

/// The presets whose scenarios are read, as a quick reproduction has them.
claims::PaperStudy quick_study() {
  std::vector<std::pair<std::string, scene::Preset>> presets;
  for (const std::string& name : claims::reading_presets())
    presets.emplace_back(name, without_mistakes(scene::read_preset(resolve_preset(name))));
  return claims::merge_presets(presets, claims::Effort::quick);
}

/// The plate whose coordination is sought.
scene::Preset plate_of(const claims::PaperStudy& quick) {
  scene::Preset preset = quick.preset;
  preset.scene = preset.study.front().scene;
  preset.study.clear();
  return preset;
}

/// Each series is asked for by every reading, and read once.
std::function<study::SeriesTable(const study::SummaryRow&)> kept_series(const fs::path& folder) {
  const auto kept = std::make_shared<std::map<std::string, study::SeriesTable>>();
  return [folder, kept](const study::SummaryRow& row) {
    const auto [at, fresh] = kept->try_emplace(row.series);
    if (fresh) at->second = study::read_series(folder / row.series);
    return at->second;
  };
}

void write_readings(const ReadingsReport& report, const fs::path& folder, const Session& session) {
  base::write_whole_file(folder / "readings.html", readings_html(report));
  base::write_whole_file(folder / "readings.md", readings_markdown(report));
  session.print_result(readings_json(report), [&] {
    base::print_text(readings_text(report, session.color()) + "\n");
    base::print("{}/  readings.html, readings.md, runs\n", folder.string());
  });
}

}  // namespace

ExitCode reproduce_readings(const SessionOptions& options, const std::string& folder) {
  Session session("rift reproduce", options);
  const claims::PaperStudy quick = quick_study();
  return session.until_stopped(
      [&] {
        ReadingsReport report{.build = build_info(),
                              .command = "rift reproduce readings",
                              .elements = claims::plate_elements(claims::Effort::quick),
                              .matched = {},
                              .claims = claims::claims_of_readings(),
                              .rows = {},
                              .balances = {}};
        report.matched = simulation::matching_coordination(plate_of(quick), seeds, session.cache,
                                                           session.progress_of_stages());
        const claims::PaperStudy study = claims::study_of_readings(quick, report.matched.coordination);
        const study::StudyResult result = study::run_study(
            study.preset, {.folder = folder, .threads = options.threads, .shared = true}, session.cache,
            build_info(), {.progress = session.progress_of_stages(), .finished = {}});
        session.line.clear();
        session.print_notes();
        if (!result.not_made.empty()) throw scene::InputError(result.not_made.front().issues);
        if (result.outcome == simulation::Outcome::stopped) return session.stopped();
        report.scenarios = static_cast<int>(study.preset.study.size());
        report.computed = result.computed, report.found = result.found;
        claims::Evidence evidence{.rows = {}, .elements = report.elements, .series = kept_series(folder)};
        for (const auto& row : result.rows)
          if (row) evidence.rows.push_back(*row);
        judge_readings(report, evidence);
        report.wall_s = session.seconds();
        write_readings(report, folder, session);
        return session.ended(result.outcome);
      },
      "; the finished scenarios are stored in " + folder);
}

}  // namespace rift::studio
