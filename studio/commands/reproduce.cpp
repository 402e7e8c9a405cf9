#include "engine/base/files.hpp"
#include "engine/calibration/calibrate.hpp"
#include "engine/claims/claims.hpp"
#include "engine/lattice/lattice.hpp"
#include "engine/measurement/specimen_properties.hpp"
#include "engine/scene/issue.hpp"
#include "engine/study/runner.hpp"
#include "engine/study/store.hpp"
#include "engine/theory/wave_speeds.hpp"
#include "studio/commands/chosen_claims.hpp"
#include "studio/commands/commands.hpp"
#include "studio/commands/draw_claim.hpp"
#include "studio/commands/reproduce_readings.hpp"
#include "studio/commands/session.hpp"
#include "studio/reports/calibration_report.hpp"
#include "studio/reports/reproduction.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <set>

namespace rift::studio {
namespace fs = std::filesystem;
namespace {

struct ReproduceOptions : SessionOptions {
  std::vector<std::string> names;
  std::string out = reproduction_folder;
  bool quick = false;
};

/// A folder of something else is left alone.
void check_folder(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(folder, ignored) || fs::is_empty(folder, ignored) ||
      fs::is_directory(folder / "runs", ignored) || fs::exists(folder / "reproduction.md", ignored) ||
      fs::exists(folder / "readings.md", ignored))
    return;
  refuse("rift reproduce", fmt::format("'{}' exists and holds other files: choose another folder with --out",
                                       scene::printable(folder.string())));
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

/// What the specimens of the study's scenarios show of themselves: each is pulled once, or the cache knows
/// it.
class OwnPlates {
 public:
  OwnPlates(const claims::PaperStudy& study, Session& session) : study_(study), session_(session) {}

  claims::OwnPlate operator()(const study::SummaryRow& row) {
    const scene::Scene& scene = study_.preset.study.at(static_cast<std::size_t>(row.row)).scene;
    const std::string key =
        simulation::specimen_key(scene) + scene::word_of("material.stiffness", scene.material.stiffness);
    if (const auto known = known_.find(key); known != known_.end()) return known->second;
    scene::Preset preset = study_.preset;
    preset.scene = scene, preset.study.clear();
    const auto progress = session_.progress_of_stages();
    const simulation::Prepared plate = simulation::prepare(preset, session_.cache, progress);
    const simulation::OwnConstants own =
        measurement::pulled_constants(plate, plate.lane.front(), session_.cache,
                                      simulation::stage(progress, "static pulls"), session_.options.threads);
    const theory::WaveSpeeds speeds =
        theory::wave_speeds(own.young_modulus(), own.poisson_ratio(), plate.density, theory::Plane::stress);
    return known_[key] = {own.poisson_ratio(), speeds.rayleigh, own.between_grips};
  }

 private:
  const claims::PaperStudy& study_;
  Session& session_;
  std::map<std::string, claims::OwnPlate> known_;
};

JudgedClaim judged(const claims::Claim& claim, const claims::PaperStudy& study,
                   const study::StudyResult& result, int elements, const fs::path& folder,
                   OwnPlates& own_plates) {
  JudgedClaim out;
  out.claim = &claim;
  if (!claim.judge) return out;
  claims::Evidence bulk{
      .rows = {},
      .elements = elements,
      .series = [&](const study::SummaryRow& row) { return study::read_series(folder / row.series); },
      .own = std::ref(own_plates)};
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

/// Judges a claim about cylinders.
JudgedClaim calibrated(const claims::Claim& claim, const ReproduceOptions& options, claims::Effort effort,
                       Session& session) {
  const double start_s = session.seconds();
  const calibration::CalibrationStudy study = calibration::study_calibration(
      calibration_scene(claim, effort), session.cache, session.progress_of_stages(), options.threads);
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
  out.wall_s = session.seconds() - start_s;
  return out;
}

/// The nominal c_r over the Rayleigh speed that the plate shows along its edge, with bulk and with in-situ
/// beams.
struct OwnSpeed {
  double bulk = 0, in_situ = 0;
};

OwnSpeed measure_speed(int elements, Session& session) {
  const auto progress = session.progress_of_stages();
  const simulation::Prepared plate = simulation::prepare(
      scene::read_preset(resolve_preset("plate_pnrt"), {fmt::format("specimen.elements={}", elements)}),
      session.cache, progress);
  const measurement::SpecimenProperties own =
      measurement::measure_specimen(plate, session.cache, progress, session.options.threads);
  const double in_situ = own.nominal.rayleigh / own.speed(measurement::WaveKind::rayleigh);
  return {in_situ * std::sqrt(plate.micro.young_modulus / lattice::bulk_micro_material.young_modulus),
          in_situ};
}

/// Fig. 15 once more, over the plate's own Rayleigh speed.
void add_own_speed(JudgedClaim& claim, const claims::PaperStudy& study, const study::StudyResult& result,
                   const fs::path& folder, int elements, Session& session) {
  const OwnSpeed own = measure_speed(elements, session);
  for (const char* stiffness : {"bulk", "in-situ"}) {
    claims::Evidence evidence{.rows = {}, .elements = elements};
    for (study::SummaryRow& row : rows_for(*claim.claim, study, result))
      if (row.stiffness == stiffness) evidence.rows.push_back(std::move(row));
    const bool bulk = std::string_view(stiffness) == "bulk";
    draw_figures(claim, charts_over_own_speed(evidence, stiffness, bulk ? own.bulk : own.in_situ),
                 folder / "charts");
  }
}

std::string command_text(const ReproduceOptions& options) {
  std::string text = "rift reproduce";
  for (const std::string& name : options.names) text += " " + name;
  return text + (options.names.empty() ? " all" : "") + (options.quick ? " --quick" : "");
}

study::StudyResult compute(const ReproduceOptions& options, const claims::PaperStudy& study,
                           Session& session) {
  if (study.preset.study.empty()) return {};
  study::StudyResult result = study::run_study(
      study.preset, {.folder = options.out, .threads = options.threads, .shared = true}, session.cache,
      build_info(), {.progress = session.progress_of_stages(), .finished = {}});
  session.line.clear();
  session.print_notes();
  if (!result.not_made.empty()) throw scene::InputError(result.not_made.front().issues);
  return result;
}

/// Judges and draws the claims; throws Interrupted.
void fill(Reproduction& report, const std::vector<const claims::Claim*>& chosen,
          const ReproduceOptions& options, claims::Effort effort, const claims::PaperStudy& study,
          const study::StudyResult& result, Session& session) {
  OwnPlates own_plates(study, session);
  for (const claims::Claim* claim : chosen) {
    if (claim->calibration && claim->judge) {
      report.claims.push_back(calibrated(*claim, options, effort, session));
      continue;
    }
    session.progress("charts of " + claim->name, 0.0);
    report.claims.push_back(judged(*claim, study, result, report.elements, options.out, own_plates));
  }
  for (JudgedClaim& claim : report.claims)
    if (claim.claim->name == "fig15")
      add_own_speed(claim, study, result, options.out, report.elements, session);
  for (JudgedClaim& claim : report.claims)
    if (!claim.claim->pictures_at.empty()) draw_claim(claim, options.out, report.elements, session);
  session.line.clear();
}

void write_reproduction(const Reproduction& report, const fs::path& folder, const Session& session) {
  base::make_folder(folder);
  base::write_whole_file(folder / "report.html", reproduction_html(report));
  base::write_whole_file(folder / "reproduction.md", reproduction_markdown(report));
  session.print_result(reproduction_json(report), [&] {
    base::print_text(reproduction_text(report, session.color()) + "\n");
    base::print("{}/  report.html, reproduction.md, charts, runs\n", folder.string());
  });
}

/// All claims under all readings; of a size of its own, so that it goes with nothing else.
bool is_of_readings(const ReproduceOptions& options) {
  const auto at = std::find(options.names.begin(), options.names.end(), readings_name);
  if (at == options.names.end()) return false;
  if (options.names.size() > 1 || options.quick)
    refuse("rift reproduce", "readings stands alone: it computes scenarios of its own with 5,000 elements");
  return true;
}

ExitCode reproduce(const ReproduceOptions& options) {
  if (is_of_readings(options)) {
    check_folder(options.out);
    study::open_shared(options.out);
    base::check_target(fs::path(options.out) / "readings.html");
    return reproduce_readings(options, options.out);
  }
  const std::vector<const claims::Claim*> chosen = chosen_claims(options.names);
  const claims::Effort effort = options.quick ? claims::Effort::quick : claims::Effort::full;
  const claims::PaperStudy study = paper_study(chosen, effort);
  check_folder(options.out);
  study::open_shared(options.out);
  base::check_target(fs::path(options.out) / "report.html");
  Session session("rift reproduce", options);
  const study::StudyResult result = compute(options, study, session);
  if (result.outcome == simulation::Outcome::stopped) {
    session.message(
        fmt::format("stopped; {} of {} scenarios are stored in {}: the same command continues from there",
                    result.computed + result.found, study.preset.study.size(), options.out));
    return session.stopped();
  }
  Reproduction report{.build = build_info(),
                      .command = command_text(options),
                      .elements = claims::plate_elements(effort),
                      .scenarios = static_cast<int>(study.preset.study.size()),
                      .computed = result.computed,
                      .found = result.found,
                      .wall_s = 0,
                      .claims = {},
                      .scenes = {}};
  for (const scene::StudyRow& row : study.preset.study) report.scenes.push_back(row.scene);
  const auto work = [&] {
    fill(report, chosen, options, effort, study, result, session);
    report.wall_s = session.seconds();
    write_reproduction(report, options.out, session);
    return session.ended(result.outcome);
  };
  return session.until_stopped(work, "; the finished scenarios are stored in " + options.out);
}

}  // namespace

void add_reproduce(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command =
      *app.add_subcommand("reproduce", "The paper's figures and claims, each recomputed and judged");
  const auto options = std::make_shared<ReproduceOptions>();
  command
      .add_option(
          "names", options->names,
          "Claims to judge, such as fig07 or sec4_longer; all (default); beyond: questions beyond the paper; "
          "readings: what the verdicts rest on, all claims under all that the paper leaves open")
      ->type_name("NAME");
  command.add_flag("--quick", options->quick, "The same plate with 5,000 elements, a minute or two");
  command
      .add_option("-o,--out", options->out, "Folder of runs, charts and report; an existing one is continued")
      ->type_name("FOLDER")
      ->capture_default_str();
  add_threads(command, *options);
  add_no_cache(command, *options);
  add_quiet(command, *options);
  add_plain(command, *options);
  command.add_flag("-j,--json", options->json,
                   "Progress as JSON lines on stderr, the verdicts as JSON on stdout");
  add_color_option(command, options->color);
  command.callback([options, &exit_code] { exit_code = reproduce(*options); });
}

}  // namespace rift::studio
