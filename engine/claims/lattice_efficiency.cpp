#include "engine/claims/lattice_efficiency.hpp"

#include "engine/base/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace rift::claims {
namespace {

constexpr double paper_relaxation = 1.0, paper_zone = 1.0;
constexpr double broberg_goal = 0.02;  // of G_ID / eta, relative

long key_of(double number) { return std::lround(1e6 * number); }

bool of_strip(const SummaryRow& row) { return row.technique == "progressive" && !(row.tips > 1.5); }

/// "0.97 at 0.1, 0.62 at 0.5"
std::string listed_at(const std::vector<EfficiencyPoint>& points) {
  std::string list;
  for (const EfficiencyPoint& p : points)
    list += fmt::format("{}{:.3f} at {:g}", list.empty() ? "" : ", ", base::mean_of(p.ratio), p.v);
  return list;
}

const EfficiencyPoint* find_point(const std::vector<EfficiencyPoint>& points, double v) {
  const auto found = std::find_if(points.begin(), points.end(),
                                  [&](const EfficiencyPoint& p) { return key_of(p.v) == key_of(v); });
  return found == points.end() ? nullptr : &*found;
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

std::vector<BrobergProblem> broberg_problem(const Evidence& evidence) {
  const auto zones = by_zone(evidence);
  std::map<std::tuple<long, long, long>, BrobergProblem>
      points;  // the smallest elements of a velocity and zone last
  std::map<std::tuple<long, long, long>, std::vector<double>> radii;
  for (const SummaryRow& row : evidence.rows) {
    if (!(row.tips > 1.5) || std::isnan(row.ratio)) continue;
    const double v = row.crack_velocity_over_cr, zone = row.damage_zone_ratio;
    const std::tuple place(key_of(v), key_of(zone), std::lround(row.elements));
    BrobergProblem& p = points[place];
    p.v = v, p.zone = zone, p.elements = row.elements;
    p.broberg = row.broberg;
    p.ratio.push_back(row.ratio);
    radii[place].push_back(row.mean_radius_m);
    p.half_length_m = 0.5 * row.length_m * (row.window_over_length[0] + row.window_over_length[1]);
    const auto strip = zones.find(key_of(zone));
    const EfficiencyPoint* eta = strip == zones.end() ? nullptr : find_point(strip->second, v);
    if (eta) p.efficiency = base::mean_of(eta->ratio), p.efficiency_scatter = scatter_of(eta->ratio);
  }
  std::vector<BrobergProblem> list;
  for (auto& [place, point] : points) {
    point.radius_m = base::mean_of(radii[place]);
    list.push_back(std::move(point));
  }
  return list;
}

std::vector<Extrapolated> extrapolated(const std::vector<BrobergProblem>& points) {
  std::vector<Extrapolated> list;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const BrobergProblem &coarse = points[k], &fine = points[k + 1];
    if (key_of(coarse.v) != key_of(fine.v) || key_of(coarse.zone) != key_of(fine.zone)) continue;
    const double x = coarse.radius_m / coarse.half_length_m, y = fine.radius_m / fine.half_length_m;
    const double on = y / (x - y);
    const double limit = fine.over_efficiency() + on * (fine.over_efficiency() - coarse.over_efficiency());
    if (!std::isfinite(limit)) continue;
    const auto relative = [](const BrobergProblem& p) {
      return scatter_of(p.ratio) / base::mean_of(p.ratio);
    };
    const double of_coarse = relative(coarse), of_fine = fine.ratio.size() > 1 ? relative(fine) : of_coarse;
    const double of_efficiency = fine.efficiency_scatter / fine.efficiency;
    list.push_back({fine.v, fine.zone, limit, fine.broberg,
                    std::hypot((1.0 + on) * of_fine, on * of_coarse, of_efficiency)});
  }
  return list;
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

Judgement beyond_broberg(const Evidence& evidence) {
  const std::vector<BrobergProblem> points = broberg_problem(evidence);
  const std::vector<Extrapolated> limits = extrapolated(points);
  if (limits.empty()) return {Verdict::not_decidable, "no result"};
  double most = 0.0;
  for (const BrobergProblem& p : points) most = std::max(most, p.elements);
  std::string text = fmt::format("G_ID / η over Broberg with {:.0f} elements:", most);
  for (const BrobergProblem& p : points)
    if (p.elements == most)
      text += fmt::format(" {:.3f} at {:g}, r_l = {:g};", p.over_efficiency() / p.broberg, p.v, p.zone);
  text += " extrapolated to R = 0 (± scatter):";
  std::vector<double> away, scatter;
  for (const Extrapolated& e : limits) {
    away.push_back(std::abs(e.limit / e.broberg - 1.0));
    scatter.push_back(e.scatter);
    text += fmt::format(" {:.3f} \u00b1 {:.3f} at {:g}, r_l = {:g};", e.limit / e.broberg, e.scatter, e.v,
                        e.zone);
  }
  const Verdict verdict = base::mean_of(scatter) > broberg_goal ? Verdict::not_decidable
                          : base::mean_of(away) <= broberg_goal ? Verdict::holds
                                                                : Verdict::does_not_hold;
  return {verdict, fmt::format("{} mean distance {:.1f} %, mean scatter {:.1f} %", text,
                               100.0 * base::mean_of(away), 100.0 * base::mean_of(scatter))};
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
       .text = "A crack that opens from zero in the middle of a large plate, before any boundary reflection: "
               "G_ID is η times Broberg's factor, and G_ID / η tends to Broberg (within 2 %) as the elements "
               "grow small.",
       .needs = {"beyond_broberg", "beyond_efficiency"},
       .judge = beyond_broberg,
       .beyond = true},
  };
}

}  // namespace rift::claims
