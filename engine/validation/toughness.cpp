#include "engine/validation/toughness.hpp"

#include "engine/base/cache.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rift::validation {
namespace {

constexpr std::size_t numbers_of_row = 1 + std::size(advances);

std::vector<double> numbers_of(const std::vector<ToughnessRow>& rows) {
  std::vector<double> numbers;
  for (const ToughnessRow& row : rows) {
    numbers.push_back(row.energy);
    numbers.insert(numbers.end(), row.late.begin(), row.late.end());
  }
  return numbers;
}

std::vector<ToughnessRow> rows_of(const std::vector<double>& numbers) {
  std::vector<ToughnessRow> rows;
  for (std::size_t k = 0; k < kappas.size(); ++k) {
    ToughnessRow row{.kappa = kappas[k], .energy = numbers[k * numbers_of_row]};
    std::copy_n(&numbers[k * numbers_of_row + 1], row.late.size(), row.late.begin());
    rows.push_back(row);
  }
  return rows;
}

ToughnessRow row_of(const scene::Scene& scene, const FreeCrack& crack) {
  ToughnessRow row{.kappa = crack.kappa, .energy = energy_per_area(scene, crack)};
  const auto late = time_errors(scene, {crack}, advances, false);
  for (std::size_t k = 0; k < row.late.size(); ++k) row.late[k] = late[k].front();
  return row;
}

std::vector<scene::Scene> lanes_of(const scene::Scene& scene) {
  std::vector<scene::Scene> lanes(kappas.size(), scene);
  for (std::size_t k = 0; k < kappas.size(); ++k) lanes[k].breaking.kappa = kappas[k];
  return lanes;
}

/// The kappas at which every realisation arrives: means over those that do would be of the easy ones.
std::vector<std::size_t> complete_kappas(const ToughnessGroup& group) {
  std::vector<std::size_t> complete;
  for (std::size_t k = 0; k < kappas.size(); ++k)
    if (std::all_of(group.realisation.begin(), group.realisation.end(),
                    [&](const auto& rows) { return std::isfinite(rows[k].energy); }))
      complete.push_back(k);
  return complete;
}

/// Where the line of least squares through the means over the realisations is 1, those of one packing left
/// out; NaN where the means do not rise or are fewer than two.
double kappa_without(const ToughnessGroup& group, const std::vector<std::size_t>& at, int packing) {
  std::vector<double> mean;
  double x = 0.0, y = 0.0, xy = 0.0, xx = 0.0;
  const auto count = static_cast<double>(at.size());
  for (const std::size_t k : at) {
    std::vector<double> values;
    for (std::size_t r = 0; r < group.realisation.size(); ++r)
      if (static_cast<int>(r / 2) != packing) values.push_back(group.realisation[r][k].energy);
    mean.push_back(spread_of(values).mean);
    x += kappas[k] / count, y += mean.back() / count;
  }
  for (std::size_t n = 0; n < at.size(); ++n) {
    const double off = kappas[at[n]] - x;
    xy += off * (mean[n] - y), xx += off * off;
  }
  return xy > 0.0 ? x + (1.0 - y) * xx / xy : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

std::vector<ToughnessGroup> planned_toughness(const scene::Scene& scene) {
  const int elements = scene.specimen.elements;
  return {{.elements = elements, .packings = 8, .resolved = fracture::resolved_radii},
          {.elements = elements, .packings = 8, .resolved = 2.0 * fracture::resolved_radii},
          {.elements = 2 * elements, .packings = 4, .resolved = fracture::resolved_radii}};
}

/// Packing and static pulls of a group that has others' packings are there already.
double estimated_seconds(const std::vector<ToughnessGroup>& groups) {
  constexpr double packing = 4e-4, march = 2e-4;  // [s] an element, and a realisation of all kappas
  double seconds = 0.0;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const bool packed =
        std::any_of(groups.begin(), groups.begin() + static_cast<std::ptrdiff_t>(g),
                    [&](const ToughnessGroup& other) { return other.elements == groups[g].elements; });
    seconds += groups[g].packings * groups[g].elements * (2.0 * march + (packed ? 0.0 : packing));
  }
  return seconds;
}

void compute_toughness(ToughnessGroup& group,
                       const std::function<scene::Preset(const std::vector<std::string>&)>& read,
                       base::Cache& cache, const simulation::StageProgress& progress, int threads) {
  const scene::Scene base = read({fmt::format("specimen.elements={}", group.elements)}).scene;
  const Problem pairs{.packings = group.packings, .mirrored = true};
  const std::vector<Realisation> realisations = realisations_of(pairs, group.elements);
  for (const Realisation& realisation : realisations) {
    const auto told = [&](std::string_view stage, double) {
      return !progress || progress(stage, static_cast<double>(group.realisation.size()) /
                                              static_cast<double>(realisations.size()));
    };
    scene::Preset preset = read(overrides_of(base, realisation));
    const std::string key = fmt::format("toughness 1, n = {:a}, kappa {}, of {}", group.resolved,
                                        fmt::join(kappas, " "), scene::preset_text(preset.scene));
    const std::size_t count = kappas.size() * numbers_of_row + 1;
    auto numbers = base::recall(cache, "toughness", key);
    if (!numbers || numbers->size() != count) {
      const double finer = std::sqrt(fracture::resolved_radii / group.resolved);
      if (finer < 1.0) {
        const simulation::Prepared p = simulation::prepare(preset, cache, told);
        const simulation::LanePlan& lane = p.lane.front();
        preset.scene.breaking.strength = finer * lane.scenario.material.value().strength * lane.units.energy;
      }
      const std::vector<FreeCrack> cracks =
          run_free_cracks(preset, lanes_of(preset.scene), realisation, true, cache, told, threads);
      std::vector<ToughnessRow> rows;
      for (const FreeCrack& crack : cracks) rows.push_back(row_of(preset.scene, crack));
      numbers = numbers_of(rows);
      numbers->push_back(cracks.front().mean_radius);
      base::remember(cache, "toughness", key, *numbers);
    }
    group.realisation.push_back(rows_of(*numbers));
    group.mean_radius = numbers->back();
  }
}

Fitted fitted_kappa(const ToughnessGroup& group) {
  const std::vector<std::size_t> at = complete_kappas(group);
  Fitted fitted{kappa_without(group, at, -1), 0.0};
  std::vector<double> without;
  for (int packing = 0; packing < group.packings; ++packing)
    without.push_back(kappa_without(group, at, packing));
  const Spread spread = spread_of(without);
  const double n = group.packings;
  fitted.error = spread.count == group.packings ? spread.deviation * (n - 1.0) / std::sqrt(n)
                                                : std::numeric_limits<double>::quiet_NaN();
  return fitted;
}

Fitted mean_at(const ToughnessGroup& group, double kappa,
               const std::function<double(const ToughnessRow&)>& of) {
  std::size_t k = 1;
  while (k + 1 < kappas.size() && kappas[k] < kappa) ++k;
  const double share = (kappa - kappas[k - 1]) / (kappas[k] - kappas[k - 1]);
  std::vector<double> values;
  for (const auto& rows : group.realisation)
    values.push_back((1.0 - share) * of(rows[k - 1]) + share * of(rows[k]));
  const Spread spread = spread_of(values);
  return {spread.mean, spread.error()};
}

}  // namespace rift::validation
