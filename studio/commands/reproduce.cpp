#include "engine/base/console.hpp"
#include "engine/base/files.hpp"
#include "engine/base/interrupted.hpp"
#include "engine/base/text.hpp"
#include "engine/calibration/calibrate.hpp"
#include "engine/claims/claims.hpp"
#include "engine/lattice/lattice.hpp"
#include "engine/scene/issue.hpp"
#include "engine/simulation/own_numbers.hpp"
#include "engine/study/runner.hpp"
#include "engine/study/store.hpp"
#include "studio/commands/commands.hpp"
#include "studio/commands/draw_claim.hpp"
#include "studio/commands/scene_options.hpp"
#include "studio/reports/calibration_report.hpp"
#include "studio/reports/reproduction.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <set>

namespace rift::studio {
namespace fs = std::filesystem;
namespace {

using Clock = std::chrono::steady_clock;

struct ReproduceOptions {
  std::vector<std::string> names;
  std::string out = "reproduction";
  bool quick = false, quiet = false, json = false, no_cache = false;
  int threads = 0;
  std::string color;
};

scene::Issue issue(std::string text) {
  return {.file = "rift reproduce", .key = {}, .text = std::move(text)};
}

/// The claims of the names, in the table's order; for none or "all" all of the paper's, for "beyond" the
/// others.
std::vector<const claims::Claim*> chosen_claims(const std::vector<std::string>& names) {
  std::set<std::string> wanted(names.begin(), names.end());
  std::vector<std::string> known{"all", "beyond"};
  for (const claims::Claim& claim : claims::claims()) known.push_back(claim.name);
  std::vector<scene::Issue> issues;
  for (const std::string& name : wanted) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    const std::string nearest = scene::nearest_name(name, known);
    issues.push_back(issue(nearest.empty() ? fmt::format("unknown name '{}': the names are {}",
                                                         scene::printable(name), scene::listed(known, "and"))
                                           : fmt::format("unknown name '{}', did you mean '{}'?",
                                                         scene::printable(name), nearest)));
  }
  if (!issues.empty()) throw scene::InputError(issues);
  std::vector<const claims::Claim*> chosen;
  if (wanted.empty()) wanted.insert("all");
  for (const claims::Claim& claim : claims::claims())
    if (wanted.contains(claim.beyond ? "beyond" : "all") || wanted.contains(claim.name))
      chosen.push_back(&claim);
  return chosen;
}

/// A folder of something else is left alone.
void check_folder(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(folder, ignored) || fs::is_empty(folder, ignored) ||
      fs::is_directory(folder / "runs", ignored) || fs::exists(folder / "reproduction.md", ignored))
    return;
  throw scene::InputError({issue(fmt::format("'{}' is there and holds something else: choose another --out",
                                             scene::printable(folder.string())))});
}

claims::PaperStudy study_of(const std::vector<const claims::Claim*>& chosen, claims::Effort effort) {
  std::vector<std::string> names;
  for (const claims::Claim* claim : chosen)
    for (const std::string& name : claim->needs)
      if (claim->judge && !claim->calibration && std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(name);
  std::vector<std::pair<std::string, scene::Preset>> presets;
  std::vector<scene::Issue> issues;
  for (const std::string& name : names) {
    presets.emplace_back(name, scene::read_preset(resolve_preset(name)));
    const std::vector<scene::Issue>& found = presets.back().second.issues;
    issues.insert(issues.end(), found.begin(), found.end());
  }
  if (!issues.empty()) throw scene::InputError(issues);
  return claims::merge_presets(presets, effort);
}

/// The rows a claim looks at, of any stiffness.
std::vector<study::SummaryRow> rows_for(const claims::Claim& claim, const claims::PaperStudy& study,
                                        const study::StudyResult& result) {
  std::set<int> places;
  for (const std::string& name : claim.needs)
    if (const auto rows = study.of.find(name); rows != study.of.end())
      places.insert(rows->second.begin(), rows->second.end());
  std::vector<study::SummaryRow> rows;
  for (int place : places)
    if (result.rows.at(place)) rows.push_back(*result.rows[place]);
  return rows;
}

void draw_figures(JudgedClaim& claim, const std::vector<NamedChart>& charts, const fs::path& folder) {
  for (const NamedChart& named : charts) claim.figures.push_back({draw_chart(named, folder), named.caption});
}

JudgedClaim judged(const claims::Claim& claim, const claims::PaperStudy& study,
                   const study::StudyResult& result, int elements, const fs::path& folder) {
  JudgedClaim out;
  out.claim = &claim;
  if (!claim.judge) return out;
  claims::Evidence bulk{.rows = {}, .elements = elements, .series = [&](const study::SummaryRow& row) {
                          return study::read_series(folder / row.series);
                        }};
  claims::Evidence in_situ = bulk;
  for (study::SummaryRow& row : rows_for(claim, study, result)) {
    ++out.scenarios;
    out.wall_s += study::marching_time(row);
    (row.stiffness == "bulk" ? bulk : in_situ).rows.push_back(std::move(row));
  }
  const fs::path charts = folder / "charts";
  out.in_situ = claim.judge(in_situ);
  if (claim.beyond) {
    draw_figures(out, beyond_charts(claim, in_situ), charts);
    return out;
  }
  out.bulk = claim.judge(bulk);
  draw_figures(out, claim_charts(claim, bulk, "bulk"), charts);
  draw_figures(out, claim_charts(claim, in_situ, "in-situ"), charts);
  return out;
}

/// What --quick leaves of a calibration: two packings of the cylinders below the size of the quick plate.
scene::Scene calibration_scene(scene::Scene scene, claims::Effort effort) {
  if (effort == claims::Effort::full) return scene;
  scene::Scene::Calibration& c = scene.calibration;
  const double most = claims::plate_elements(effort);
  std::erase_if(c.sizes, [&](double elements) { return elements > most; });
  if (c.sizes.empty()) c.sizes = {most};
  c.elements = std::min(c.elements, static_cast<int>(most) / 2);
  c.packings = std::min(c.packings, 2);
  return scene;
}

/// Judges a claim about cylinders.
JudgedClaim calibrated(const claims::Claim& claim, const ReproduceOptions& options, claims::Effort effort,
                       const StopSignal& stop) {
  const auto start = Clock::now();
  ProgressLine line(progress_style(options.quiet, options.json));
  base::Cache cache = options.no_cache ? base::Cache{} : base::user_cache();
  const scene::Preset preset = scene::read_preset(resolve_preset(claim.needs.front()));
  if (!preset.issues.empty()) throw scene::InputError(preset.issues);
  const calibration::CalibrationStudy study = calibration::study_calibration(
      calibration_scene(preset.scene, effort), cache,
      [&](const char* stage, double done) {
        line.tell(stage, done);
        return stop.received() == 0;
      },
      options.threads);
  JudgedClaim out;
  out.claim = &claim;
  const std::vector<nlohmann::ordered_json> rows = calibration::rows_of(study);
  claims::Evidence evidence{.rows = {}, .elements = claims::plate_elements(effort)};
  for (const auto& packings : study.by_size)
    evidence.cylinders.insert(evidence.cylinders.end(), packings.begin(), packings.end());
  out.bulk = claim.judge(evidence);
  out.scenarios = static_cast<int>(rows.size());
  std::vector<NamedChart> charts = calibration_charts(rows, lattice::bulk_micro_material.young_modulus);
  if (claim.name == "table2") charts.resize(1);  // the others are Fig. 17's
  for (NamedChart& named : charts) named.name = claim.name + "_" + named.name;
  draw_figures(out, charts, fs::path(options.out) / "charts");
  out.wall_s = std::chrono::duration<double>(Clock::now() - start).count();
  return out;
}

/// The nominal c_r over the Rayleigh speed that the plate shows along its edge, with bulk and with in-situ
/// beams.
struct OwnSpeed {
  double bulk = 0, in_situ = 0;
};

OwnSpeed measure_speed(const ReproduceOptions& options, int elements, const StopSignal& stop) {
  ProgressLine line(progress_style(options.quiet, options.json));
  base::Cache cache = options.no_cache ? base::Cache{} : base::user_cache();
  const auto tell = [&](std::string_view stage, double done) {
    line.tell(stage, done);
    return stop.received() == 0;
  };
  const simulation::Prepared plate = simulation::prepare(
      scene::read_preset(resolve_preset("plate_pnrt"), {fmt::format("specimen.elements={}", elements)}),
      cache, tell);
  const simulation::OwnNumbers own = simulation::measure_own_numbers(plate, cache, tell, options.threads);
  const double in_situ = own.nominal.rayleigh / own.speed(calibration::WaveKind::rayleigh);
  return {in_situ * std::sqrt(plate.micro.young_modulus / lattice::bulk_micro_material.young_modulus),
          in_situ};
}

/// Fig. 15 once more, over the plate's own Rayleigh speed.
void add_own_speed(JudgedClaim& claim, const claims::PaperStudy& study, const study::StudyResult& result,
                   const ReproduceOptions& options, int elements, const StopSignal& stop) {
  const OwnSpeed own = measure_speed(options, elements, stop);
  for (const char* stiffness : {"bulk", "in-situ"}) {
    claims::Evidence evidence{.rows = {}, .elements = elements};
    for (study::SummaryRow& row : rows_for(*claim.claim, study, result))
      if (row.stiffness == stiffness) evidence.rows.push_back(std::move(row));
    const bool bulk = std::string_view(stiffness) == "bulk";
    draw_figures(claim, charts_over_own_speed(evidence, stiffness, bulk ? own.bulk : own.in_situ),
                 fs::path(options.out) / "charts");
  }
}

/// Draws the claims that are pictures.
void draw_pictures(Reproduction& report, const ReproduceOptions& options, const StopSignal& stop) {
  ProgressLine line(progress_style(options.quiet, options.json));
  base::Cache cache = options.no_cache ? base::Cache{} : base::user_cache();
  for (JudgedClaim& claim : report.claims) {
    if (claim.claim->pictures_at.empty()) continue;
    draw_claim(claim, options.out, report.elements, cache, options.threads,
               [&](std::string_view stage, double done) {
                 line.tell(stage, done);
                 return stop.received() == 0;
               });
  }
  line.clear();
}

std::string command_text(const ReproduceOptions& options) {
  std::string text = "rift reproduce";
  for (const std::string& name : options.names) text += " " + name;
  return text + (options.names.empty() ? " all" : "") + (options.quick ? " --quick" : "");
}

study::StudyResult compute(const ReproduceOptions& options, const claims::PaperStudy& study,
                           const StopSignal& stop) {
  if (study.preset.study.empty()) return {};
  ProgressLine line(progress_style(options.quiet, options.json));
  base::Cache cache = options.no_cache ? base::Cache{} : base::user_cache();
  const study::StudyObserver observer{.progress =
                                          [&](std::string_view stage, double done) {
                                            line.tell(stage, done);
                                            return stop.received() == 0;
                                          },
                                      .finished = {}};
  study::StudyResult result =
      study::run_study(study.preset, {.folder = options.out, .threads = options.threads, .shared = true},
                       cache, build_info(), observer);
  line.clear();
  print_notes(cache);
  return result;
}

void write_reproduction(const Reproduction& report, const ReproduceOptions& options) {
  const fs::path folder = options.out;
  base::make_folder(folder);
  base::write_whole_file(folder / "report.html", reproduction_html(report));
  base::write_whole_file(folder / "reproduction.md", reproduction_markdown(report));
  if (options.json) {
    base::print_text(base::json_text(reproduction_json(report), 2) + "\n");
    return;
  }
  base::print_text(reproduction_text(report, wants_color(options.color, stdout)) + "\n");
  base::print("{}/  report.html, reproduction.md, charts, runs\n", folder.string());
}

ExitCode reproduce(const ReproduceOptions& options) {
  const auto start = Clock::now();
  const std::vector<const claims::Claim*> chosen = chosen_claims(options.names);
  const claims::Effort effort = options.quick ? claims::Effort::quick : claims::Effort::full;
  const claims::PaperStudy study = study_of(chosen, effort);
  check_folder(options.out);
  study::open_shared(options.out);
  base::check_target(fs::path(options.out) / "report.html");
  const StopSignal stop;
  const study::StudyResult result = compute(options, study, stop);
  if (result.outcome == simulation::Outcome::stopped) {
    base::message("rift reproduce: stopped; {} of {} scenarios are kept in {}: the same call goes on\n",
                  result.computed + result.found, study.preset.study.size(), options.out);
    return static_cast<ExitCode>(128 + stop.received());
  }
  Reproduction report{.build = build_info(),
                      .command = command_text(options),
                      .elements = claims::plate_elements(effort),
                      .scenarios = static_cast<int>(study.preset.study.size()),
                      .computed = result.computed,
                      .found = result.found,
                      .wall_s = 0,
                      .claims = {}};
  try {
    for (const claims::Claim* claim : chosen) {
      if (claim->calibration && claim->judge) {
        report.claims.push_back(calibrated(*claim, options, effort, stop));
        continue;
      }
      ProgressLine line(progress_style(options.quiet, options.json));
      line.tell("charts of " + claim->name, 0.0);
      report.claims.push_back(judged(*claim, study, result, report.elements, options.out));
    }
    for (JudgedClaim& claim : report.claims)
      if (claim.claim->name == "fig15") add_own_speed(claim, study, result, options, report.elements, stop);
    draw_pictures(report, options, stop);
  } catch (const base::Interrupted& interrupted) {
    base::message("rift reproduce: {}; what was computed is kept in {}\n", interrupted.what(), options.out);
    return static_cast<ExitCode>(128 + stop.received());
  }
  report.wall_s = std::chrono::duration<double>(Clock::now() - start).count();
  write_reproduction(report, options);
  return result.outcome == simulation::Outcome::diverged ? ExitCode::diverged : ExitCode::done;
}

}  // namespace

void add_reproduce(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand(
      "reproduce", "The paper's figures and claims, each judged by what is measured here");
  const auto options = std::make_shared<ReproduceOptions>();
  command.add_option(
      "names", options->names,
      "fig07, sec4_longer, ...: the claims to judge; all (default); beyond: what the paper does not have");
  command.add_flag("--quick", options->quick, "The same plate with 5,000 elements, a minute or two");
  command.add_option("--out", options->out, "Folder of runs, charts and report; continued if it is there")
      ->capture_default_str();
  command
      .add_option("--threads", options->threads,
                  "Threads (default: one per CPU that this process may use); the results do not depend on it")
      ->check(CLI::Range(1, 1024));
  command.add_flag("--no-cache", options->no_cache,
                   "Neither read nor write the cache of packings and pre-stresses");
  command.add_flag("--quiet", options->quiet, "No progress on stderr");
  command.add_flag("--json", options->json,
                   "Progress as JSON lines on stderr, the verdicts as JSON on stdout");
  add_color_option(command, options->color);
  command.callback([options, &exit_code] { exit_code = reproduce(*options); });
}

}  // namespace rift::studio
