#include "engine/study/curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace rift::study {
namespace {

constexpr double slack = 1e-9;  // velocities and lengths of presets are read from decimal text

bool same(double a, double b) { return std::abs(a - b) <= slack * std::max(1.0, std::abs(b)); }

bool has_range(double v, double from, double to) { return v >= from - slack && v <= to + slack; }

Curve filtered(const Curve& curve, double from, double to, bool inside) {
  Curve out;
  for (const CurvePoint& p : curve)
    if (has_range(p.v, from, to) == inside) out.push_back(p);
  return out;
}

void add_row(CurvePoint& point, const SummaryRow& row) {
  point.seed.push_back(row.at("seed").get<long>());
  point.ratio.push_back(number_in(row, "ratio_with_damping"));
  point.plateau_scatter.push_back(number_in(row, "ratio_scatter"));
  point.broberg = number_in(row, "broberg");
  point.freund = number_in(row, "freund");
  point.strip = number_in(row, "strip");
  point.wall_s += number_in(row, "wall_fracture_s");
}

}  // namespace

Selection simple_release(const std::string& region) {
  Selection s;
  s.technique = "simple";
  s.damping_region = region;
  return s;
}

bool selects(const Selection& s, const SummaryRow& row) {
  if (!row.is_object() || std::isnan(number_in(row, "crack_velocity_over_cr"))) return false;
  if (text_in(row, "technique") != s.technique || text_in(row, "damping_region") != s.damping_region)
    return false;
  if (s.technique == "progressive" && !(same(number_in(row, "relaxation"), s.relaxation) &&
                                        same(number_in(row, "damage_zone_ratio"), s.damage_zone_ratio)))
    return false;
  const std::string prestress = text_in(row, "prestress_method");
  return same(number_in(row, "elements"), s.elements == 0 ? paper_elements : s.elements) &&
         same(number_in(row, "length_m"), s.length_m) && axis_in(row, "path", "0.5 H") == s.path &&
         axis_in(row, "dt_fraction", "-") == s.dt_fraction && (prestress.empty() || prestress == "static");
}

Curve curve_of(const std::vector<SummaryRow>& rows, const Selection& selection) {
  std::map<long, std::map<long, const SummaryRow*>> by_velocity;  // in 1e-6 c_r, then by seed
  for (const SummaryRow& row : rows) {
    if (!selects(selection, row) || std::isnan(number_in(row, "ratio_with_damping"))) continue;
    by_velocity[std::lround(1e6 * number_in(row, "crack_velocity_over_cr"))][row.at("seed").get<long>()] =
        &row;
  }
  Curve curve;
  for (const auto& [v, of_seed] : by_velocity) {
    CurvePoint point;
    point.v = 1e-6 * static_cast<double>(v);
    for (const auto& [seed, row] : of_seed) add_row(point, *row);
    curve.push_back(std::move(point));
  }
  return curve;
}

Curve within(const Curve& curve, double from, double to) { return filtered(curve, from, to, true); }
Curve outside(const Curve& curve, double from, double to) { return filtered(curve, from, to, false); }

double release_energy_per_beam(const SummaryRow& row) {
  const double per_length =
      number_in(row, "ratio_release") * number_in(row, "g_i0_j_m2") * number_in(row, "thickness_m");
  return per_length * number_in(row, "length_m") / number_in(row, "beams_crossed");
}

double mean_of(const std::vector<double>& numbers) {
  if (numbers.empty()) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0.0;
  for (double n : numbers) sum += n;
  return sum / static_cast<double>(numbers.size());
}

double deviation_of(const std::vector<double>& numbers) {
  const double mean = mean_of(numbers);
  if (numbers.size() < 2) return numbers.empty() ? mean : 0.0;
  double sum = 0.0;
  for (double n : numbers) sum += (n - mean) * (n - mean);
  return std::sqrt(sum / static_cast<double>(numbers.size() - 1));
}

double number_in(const SummaryRow& row, const char* name) {
  const auto found = row.find(name);
  return found != row.end() && found->is_number() ? found->get<double>()
                                                  : std::numeric_limits<double>::quiet_NaN();
}

std::string text_in(const SummaryRow& row, const char* name) {
  const auto found = row.find(name);
  return found != row.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::string axis_in(const SummaryRow& row, const char* axis, const std::string& absent) {
  const auto axes = row.find("axes");
  if (axes == row.end() || !axes->is_object()) return absent;
  const std::string text = text_in(*axes, axis);
  return text.empty() ? absent : text;
}

}  // namespace rift::study
