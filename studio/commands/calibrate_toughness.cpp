#include "studio/commands/calibrate_toughness.hpp"

#include "engine/base/text.hpp"
#include "engine/validation/toughness.hpp"
#include "studio/text/table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace rift::studio {
namespace {

using Json = nlohmann::ordered_json;
using validation::Fitted;
using validation::ToughnessGroup;
using validation::ToughnessRow;

constexpr const char* default_plate = "freund_wave";

double energy_of(const ToughnessRow& row) { return row.energy; }
double late_at_10_mm(const ToughnessRow& row) { return row.late[3]; }

/// A plate that two waves load, with the law that has a kappa, and its notch along the middle.
void check_plate(const scene::Preset& preset) {
  const scene::Scene& scene = preset.scene;
  if (scene.breaking.law != fracture::FractureLaw::cohesive)
    refuse(scene::issue_at(preset, "fracture.law", "must be \"cohesive\": kappa is that law's constant"));
  const std::string why =
      fmt::format(": kappa is calibrated on a crack that two plane waves load, as in {}", default_plate);
  if (!scene.loading.traction) refuse(scene::issue_at(preset, "loading.traction", "is needed" + why));
  if (!scene.loading.rollers) refuse(scene::issue_at(preset, "loading.rollers", "must be true" + why));
  if (!preset.lanes.empty() || !preset.study.empty())
    refuse(preset.name, "holds lanes or a study: kappa is calibrated in one plate");
}

std::vector<std::string> table_row(const ToughnessGroup& group, double kappa) {
  const Fitted own = validation::fitted_kappa(group), energy = validation::mean_at(group, kappa, energy_of),
               late = validation::mean_at(group, kappa, late_at_10_mm);
  std::vector<std::string> row{
      fmt::format("{:g}", group.resolved), fmt::format("{:.3f}", 1e3 * group.mean_radius),
      fmt::format("{}", group.realisation.size()), scatter_cell(own.value, own.error, 3)};
  for (std::size_t k = 0; k < validation::kappas.size(); ++k) {
    const auto arrived = std::count_if(group.realisation.begin(), group.realisation.end(),
                                       [&](const auto& rows) { return std::isfinite(rows[k].energy); });
    const bool all = arrived == static_cast<long>(group.realisation.size());
    row.push_back(fmt::format("{:.2f}{}", validation::mean_at(group, validation::kappas[k], energy_of).value,
                              all ? std::string() : fmt::format(" of {}", arrived)));
  }
  row.push_back(scatter_cell(energy.value, energy.error, 2));
  row.push_back(scatter_cell(100.0 * late.value, 100.0 * late.error, 1));
  return row;
}

Json json_of(const ToughnessGroup& group, double kappa) {
  const Fitted own = validation::fitted_kappa(group), energy = validation::mean_at(group, kappa, energy_of),
               late = validation::mean_at(group, kappa, late_at_10_mm);
  Json rows = Json::array();
  for (const auto& realisation : group.realisation)
    for (const ToughnessRow& row : realisation)
      rows.push_back({{"kappa", row.kappa}, {"energy_over_gc", row.energy}, {"time_errors", row.late}});
  return {{"elements", group.elements},
          {"mean_radius_m", group.mean_radius},
          {"resolved_radii", group.resolved},
          {"realisations", group.realisation.size()},
          {"kappa", own.value},
          {"kappa_error", own.error},
          {"energy_over_gc", energy.value},
          {"energy_over_gc_error", energy.error},
          {"time_error_at_10_mm", late.value},
          {"time_error_at_10_mm_error", late.error},
          {"rows", rows}};
}

void print_groups(const std::vector<ToughnessGroup>& groups, const Session& session) {
  const Fitted kappa = validation::fitted_kappa(groups.front());
  base::print_text(
      heading(fmt::format("kappa = {} at n = {:g}, R = {:.3f} mm", scatter_cell(kappa.value, kappa.error, 3),
                          groups.front().resolved, 1e3 * groups.front().mean_radius),
              session.color()) +
      "\n");
  Table table{{"n", "R [mm]", "realisations", "kappa"}, {}};
  for (const double at : validation::kappas) table.head.push_back(fmt::format("W at {:g}", at));
  table.head.insert(table.head.end(), {"W at kappa", "time at 10 mm [%]"});
  for (const ToughnessGroup& group : groups) table.rows.push_back(table_row(group, kappa.value));
  base::print_text(plain_table(table, session.color()));
  base::print(
      "  W: energy lost from 5 to 15 mm of advance over G_c and the area, mean of the realisations. kappa "
      "makes it 1, where all arrive; ± is its "
      "standard error.\n  The last two columns are with the first row's kappa: W, and the error of the tip's "
      "time since the waves "
      "met against the exact history.\n  In a preset: fracture.kappa = {:.3f}\n",
      kappa.value);
}

}  // namespace

ExitCode calibrate_toughness(const SceneOptions& options) {
  const std::string plate = options.preset.empty() ? default_plate : options.preset;
  const std::filesystem::path file = resolve_preset(plate);
  const auto read = [&](const std::vector<std::string>& more) {
    std::vector<std::string> overrides = options.overrides;
    overrides.insert(overrides.end(), more.begin(), more.end());
    return without_mistakes(scene::read_preset(file, overrides));
  };
  const scene::Preset preset = read({});
  check_plate(preset);
  if (prints_config(options, preset)) return ExitCode::done;
  std::vector<ToughnessGroup> groups = validation::planned_toughness(preset.scene);
  Session session("rift calibrate", options);
  session.message(fmt::format(
      "40 cracks of {} values of kappa in 12 packings of {} and {} elements: about {} with an empty cache",
      validation::kappas.size(), groups.front().elements, groups.back().elements,
      duration_text(validation::estimated_seconds(groups))));
  const auto work = [&] {
    for (ToughnessGroup& group : groups)
      validation::compute_toughness(
          group, read, session.cache,
          [&](std::string_view stage, double done) {
            return session.progress(fmt::format("{} elements, n = {:g}", group.elements, group.resolved),
                                    done, stage);
          },
          options.threads);
    session.line.clear();
    session.print_notes();
    const Fitted kappa = validation::fitted_kappa(groups.front());
    Json rows = Json::array();
    for (const ToughnessGroup& group : groups) rows.push_back(json_of(group, kappa.value));
    session.print_result(Json{{"kappa", kappa.value}, {"kappa_error", kappa.error}, {"groups", rows}},
                         [&] { print_groups(groups, session); });
    return ExitCode::done;
  };
  return session.until_stopped(work, "; the finished realisations are in the cache");
}

}  // namespace rift::studio
