#include "engine/claims/lattice_efficiency.hpp"

#include "engine/base/numbers.hpp"
#include "engine/claims/broberg_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace rift::claims {
namespace {

constexpr double paper_relaxation = 1.0, paper_zone = 1.0;

long key_of(double number) { return std::lround(1e6 * number); }

bool of_strip(const SummaryRow& row) { return row.technique == "progressive" && !(row.tips > 1.5); }

/// "0.97 at 0.1, 0.62 at 0.5"
std::string listed_at(const std::vector<EfficiencyPoint>& points) {
  std::string list;
  for (const EfficiencyPoint& p : points)
    list += fmt::format("{}{:.3f} at {:g}", list.empty() ? "" : ", ", base::mean_of(p.ratio), p.v);
  return list;
}

/// Efficiency of the strip by the zone's length, linear relaxation.
std::map<long, std::vector<EfficiencyPoint>> by_zone(const Evidence& evidence) {
  std::map<long, std::vector<EfficiencyPoint>> zones;
  for (const double zone : zones_of(evidence)) zones[key_of(zone)] = efficiency(evidence, 1.0, zone);
  return zones;
}

}  // namespace

std::vector<MapCell> map_of(const Evidence& evidence) {
  std::map<std::pair<long, long>, MapCell> cells;
  for (const SummaryRow& row : evidence.rows) {
    if (!of_strip(row) || std::isnan(row.ratio)) continue;
    const double power = row.relaxation, zone = row.damage_zone_ratio;
    MapCell& cell = cells[{key_of(power), key_of(zone)}];
    cell.relaxation = power, cell.zone = zone;
    cell.v.push_back(row.crack_velocity_over_cr);
    cell.ratio.push_back(row.ratio);
    cell.distance.push_back(std::abs(row.error_broberg));
    cell.wall_s += row.wall_fracture_s;
  }
  std::vector<MapCell> list;
  for (auto& [place, cell] : cells) list.push_back(std::move(cell));
  return list;
}

std::vector<double> zones_of(const Evidence& evidence) {
  std::map<long, double> zones;
  for (const SummaryRow& row : evidence.rows)
    if (of_strip(row)) zones[key_of(row.damage_zone_ratio)] = row.damage_zone_ratio;
  std::vector<double> list;
  for (const auto& [key, zone] : zones) list.push_back(zone);
  return list;
}

std::vector<EfficiencyPoint> efficiency(const Evidence& evidence, double relaxation, double zone) {
  std::map<long, EfficiencyPoint> points;
  for (const SummaryRow& row : evidence.rows) {
    if (!of_strip(row) || std::isnan(row.ratio)) continue;
    if (key_of(row.relaxation) != key_of(relaxation) || key_of(row.damage_zone_ratio) != key_of(zone))
      continue;
    const double v = row.crack_velocity_over_cr;
    EfficiencyPoint& point = points[key_of(v)];
    point.v = v;
    point.ratio.push_back(row.ratio);
    point.along.push_back(row.ratio_scatter);
  }
  std::vector<EfficiencyPoint> list;
  for (auto& [key, point] : points) list.push_back(std::move(point));
  return list;
}

std::vector<WakeBand> wake_bands(const SummaryRow& row) {
  std::vector<WakeBand> bands;
  const std::vector<double>&energy = row.wake_kinetic_j, &cell = row.wake_cell_m;
  if (energy.empty()) return bands;
  double all = row.wake_rotation_j;
  for (double e : energy) all += e;
  const double radius = row.mean_radius_m;
  for (std::size_t k = 0; k + 1 < energy.size(); ++k) bands.push_back({cell[k] / radius, energy[k] / all});
  bands.push_back({2.0 * cell.back() / radius, energy.back() / all});
  return bands;
}

namespace {

Judgement beyond_map(const Evidence& evidence) {
  const std::vector<MapCell> cells = map_of(evidence);
  const MapCell *best = nullptr, *paper = nullptr;
  for (const MapCell& cell : cells) {
    if (!best || base::mean_of(cell.distance) < base::mean_of(best->distance)) best = &cell;
    if (key_of(cell.relaxation) == key_of(paper_relaxation) && key_of(cell.zone) == key_of(paper_zone))
      paper = &cell;
  }
  if (!best || !paper) return {Verdict::not_decidable, "no result"};
  std::string each;
  for (std::size_t k = 0; k < best->v.size(); ++k)
    each += fmt::format("{}{:.3f} at {:g}", k == 0 ? "" : ", ", best->distance[k], best->v[k]);
  const auto per_scenario = [](const MapCell& cell) {
    return cell.wall_s / static_cast<double>(cell.v.size());
  };
  return {yes_or_no(base::mean_of(best->distance) <= near_margin),
          fmt::format("best of {}: p = {:g}, r_l = {:g}, mean |delta| {:.3f} ({}), {:.2f} s per scenario; "
                      "the paper's p = 1, r_l = 1: {:.3f}, {:.2f} s",
                      cells.size(), best->relaxation, best->zone, base::mean_of(best->distance), each,
                      per_scenario(*best), base::mean_of(paper->distance), per_scenario(*paper))};
}

Judgement beyond_efficiency(const Evidence& evidence) {
  const auto zones = by_zone(evidence);
  if (zones.empty()) return {Verdict::not_decidable, "no result"};
  std::string text;
  for (const auto& [key, points] : zones)
    text += fmt::format("{}r_l = {:g}: {}", text.empty() ? "" : "; ", 1e-6 * static_cast<double>(key),
                        listed_at(points));
  double farthest = 0.0, scatter = 0.0;
  for (const EfficiencyPoint& p : zones.rbegin()->second) {
    farthest = std::max(farthest, std::abs(base::mean_of(p.ratio) - 1.0));
    scatter = std::max(scatter, std::max(scatter_of(p.ratio), base::mean_of(p.along)));
  }
  if (zones.rbegin()->second.empty()) return {Verdict::not_decidable, "no result"};
  return {yes_or_no(farthest <= near_margin),
          fmt::format("{}; the longest zone is within {:.3f} of 1, scatter at most {:.3f}", text, farthest,
                      scatter)};
}

}  // namespace

std::vector<Claim> beyond_the_paper() {
  return {
      {.name = "beyond_map",
       .artefact = "Relaxation and damage zone",
       .text = "Some power p of the relaxation and length r_l of the damage zone is near Broberg (mean "
               "|delta| at most 0.05) at 0.1 to 0.9 c_R in the paper's plate. It says nothing about the "
               "physics: in a strip the strip limit, 1, applies.",
       .needs = {"beyond_map"},
       .judge = beyond_map,
       .beyond = true},
      {.name = "beyond_efficiency",
       .artefact = "Lattice efficiency",
       .text = "In a steady strip all stored energy arrives at the tip, so that the ratio is the lattice "
               "efficiency η(v, r_l, p). It tends to 1 (within 0.05 at every velocity) as the damage zone "
               "grows; the rest moves in short waves behind the tip.",
       .needs = {"beyond_efficiency", "beyond_relaxation"},
       .judge = beyond_efficiency,
       .beyond = true},
      {.name = "beyond_broberg",
       .artefact = "Broberg's own problem",
       .text =
           "A crack that opens from zero in the middle of a large plate, before any boundary reflection: "
           "G_ID is η times Broberg's factor, where η is that of the same beams in a steady strip, and "
           "G_ID / η tends to Broberg (within 2 %, known to 1.5 %) as the elements grow small, at 0.3, 0.5 "
           "and 0.7 c_R.",
       .needs = {"beyond_broberg", "beyond_broberg_right", "beyond_broberg_left"},
       .judge = judge_broberg,
       .beyond = true},
  };
}

}  // namespace rift::claims
