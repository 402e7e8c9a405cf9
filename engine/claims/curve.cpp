#include "engine/claims/curve.hpp"

#include "engine/base/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace rift::claims {
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

/// The text of an axis of a row, or `absent` where the study does not name it.
std::string axis_of(const SummaryRow& row, std::string_view axis, const char* absent) {
  for (const auto& [name, text] : row.axes)
    if (name == axis && !text.empty()) return text;
  return absent;
}

void add_row(CurvePoint& point, const SummaryRow& row) {
  point.seed.push_back(std::lround(row.seed));
  point.ratio.push_back(row.ratio);
  point.trend.push_back(row.ratio_trend);
  point.broberg = row.broberg;
  point.freund = row.freund;
  point.strip = row.strip;
  point.wall_s += row.wall_fracture_s;
}

}  // namespace

Selection simple_release(const std::string& region) {
  Selection s;
  s.technique = "simple";
  s.damping_region = region;
  return s;
}

bool selects(const Selection& s, const SummaryRow& row) {
  if (std::isnan(row.crack_velocity_over_cr)) return false;
  if (row.technique != s.technique || row.damping_region != s.damping_region) return false;
  if (s.technique == "progressive" &&
      !(same(row.relaxation, s.relaxation) && same(row.damage_zone_ratio, s.damage_zone_ratio)))
    return false;
  return same(row.elements, s.elements == 0 ? paper_elements : s.elements) &&
         same(row.length_m, s.length_m) && axis_of(row, "path", "0.5 H") == s.path &&
         axis_of(row, "dt_fraction", "-") == s.dt_fraction &&
         (row.prestress_method.empty() || row.prestress_method == "static");
}

Curve curve_of(const std::vector<SummaryRow>& rows, const Selection& selection) {
  std::map<long, std::map<long, const SummaryRow*>> by_velocity;  // in 1e-6 c_r, then by seed
  for (const SummaryRow& row : rows) {
    if (!selects(selection, row) || std::isnan(row.ratio)) continue;
    by_velocity[std::lround(1e6 * row.crack_velocity_over_cr)][std::lround(row.seed)] = &row;
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
  const double per_length = row.ratio_fracture * row.g_i0_j_m2 * row.thickness_m;
  return per_length * row.length_m / row.beams_crossed;
}

double scatter_of(const std::vector<double>& numbers) {
  return numbers.size() == 1 ? 0.0 : base::deviation_of(numbers);
}

Line line_through(const std::vector<double>& x, const std::vector<double>& y) {
  if (x.size() < 3) return {NAN, NAN};
  const auto n = static_cast<double>(x.size());
  double mx = 0, my = 0, xx = 0, xy = 0, yy = 0;
  for (std::size_t k = 0; k < x.size(); ++k) mx += x[k] / n, my += y[k] / n;
  for (std::size_t k = 0; k < x.size(); ++k) {
    xx += (x[k] - mx) * (x[k] - mx);
    xy += (x[k] - mx) * (y[k] - my);
    yy += (y[k] - my) * (y[k] - my);
  }
  return {xy / xx, yy > 0.0 ? xy * xy / (xx * yy) : 1.0};
}

namespace {

Judgement nothing_to_judge(const std::string& why) { return {Verdict::not_decidable, why}; }

/// "no result at 0.1, 0.2 c_r", or empty.
std::string missing_in(const Curve& curve, Span span) {
  std::string list;
  for (double v : claimed_velocities()) {
    if (v < span.from - 1e-9 || v > span.to + 1e-9 || !within(curve, v, v).empty()) continue;
    list += fmt::format("{}{:g}", list.empty() ? "" : ", ", v);
  }
  return list.empty() ? list : fmt::format("no result at {} c_R", list);
}

Verdict verdict_of(bool yes, double scatter, double margin) {
  return scatter > margin ? Verdict::not_decidable : yes_or_no(yes);
}

std::string scatter_text(double scatter) { return fmt::format("scatter {:.3f}", scatter); }

/// Mean |ratio - Broberg| of each specimen that has every velocity.
std::map<long, double> distance_by_specimen(const Curve& curve) {
  std::map<long, std::vector<double>> distances;
  for (const CurvePoint& p : curve)
    for (std::size_t k = 0; k < p.seed.size(); ++k)
      distances[p.seed[k]].push_back(std::abs(p.ratio[k] - p.broberg));
  std::map<long, double> means;
  for (const auto& [seed, all] : distances)
    if (all.size() == curve.size()) means[seed] = base::mean_of(all);
  return means;
}

/// |difference| of the means over the specimens which both points have, and the scatter of their differences.
struct Difference {
  double mean = 0, scatter = 0;
  int specimens = 0;
};
Difference difference_of(const CurvePoint& a, const CurvePoint& b) {
  std::vector<double> differences;
  for (std::size_t k = 0; k < a.seed.size(); ++k) {
    const auto other = std::find(b.seed.begin(), b.seed.end(), a.seed[k]);
    if (other != b.seed.end()) differences.push_back(a.ratio[k] - b.ratio[other - b.seed.begin()]);
  }
  return {base::mean_of(differences), scatter_of(differences), static_cast<int>(differences.size())};
}

/// A judgement of the mean ratio at one velocity.
Judgement judged_at(const Curve& curve, double v, const std::function<bool(double ratio)>& holds) {
  const Curve at = within(curve, v, v);
  if (at.empty()) return nothing_to_judge(fmt::format("no result at {:g} c_R", v));
  const double ratio = base::mean_of(at.front().ratio), scatter = specimen_scatter(at);
  return {verdict_of(holds(ratio), scatter, near_margin),
          fmt::format("{:.3f} at {:g}, {}", ratio, v, scatter_text(scatter))};
}

enum class Side { below, above };

Judgement offset_judgement(const Curve& curve, Span span, Side side) {
  if (const std::string missing = missing_in(curve, span); !missing.empty()) return nothing_to_judge(missing);
  const Curve part = within(curve, span.from, span.to);
  const double offset = mean_offset(part), scatter = specimen_scatter(part);
  const bool yes = side == Side::below ? offset < -offset_margin : offset > offset_margin;
  return {verdict_of(yes, scatter, offset_margin),
          fmt::format("{}: mean delta {:+.3f}, {}", span_text(span), offset, scatter_text(scatter))};
}

}  // namespace

const char* name_of(Verdict verdict) {
  constexpr const char* names[] = {"holds", "does not hold", "not decidable"};
  return names[static_cast<std::size_t>(verdict)];
}

std::vector<Margin> margins() {
  const auto at_most = [](double margin, const char* what) {
    return fmt::format("{} at most {:g}", what, margin);
  };
  return {
      {"near, agrees", at_most(near_margin, "mean |ratio - Broberg| over the named velocities"), "ours"},
      {"too low, too high", fmt::format("mean signed difference beyond {:g}", offset_margin), "ours"},
      {"better than", "smaller mean |ratio - Broberg|, specimen by specimen", "ours"},
      {"no influence, negligible", at_most(influence_margin, "mean |difference|"), "ours"},
      {"quasi-constant",
       fmt::format("second half of the window less the first at most {:g}, or within {:g} standard errors",
                   constant_margin, constant_errors),
       "ours"},
      {"0.002 and 0.018 (Fig. 14)",
       fmt::format(
           "within {:g} standard deviation of a single specimen's difference; not decidable within {:g}",
           value_errors, undecided_errors),
       "numbers: text; of one specimen: text; deviations: ours"},
      {"below 0.4 at 0.01 (Fig. 7), less than 6 % (Fig. 8), 1 % (Fig. 5)", "as said", "text"},
      {"E and ν within 2.5 % above 15,000 elements (Fig. 17)", "as said", "text"},
      {"tends to Broberg (beyond_broberg)",
       "|limit / Broberg - 1| at most 0.02 with a standard uncertainty of at most 0.015, at 0.3, 0.5 and 0.7 "
       "c_R; does "
       "not hold beyond 0.02 and the uncertainty",
       "ours"},
      {"not decidable", "specimens scatter beyond the margin, or the data are not in the text", "ours"},
  };
}

const std::vector<double>& claimed_velocities() {
  static const std::vector<double> velocities{0.01, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0};
  return velocities;
}

std::string span_text(Span span) { return fmt::format("{:g}-{:g}", span.from, span.to); }

double mean_distance(const Curve& curve) {
  std::vector<double> distances;
  for (const CurvePoint& p : curve) distances.push_back(std::abs(base::mean_of(p.ratio) - p.broberg));
  return base::mean_of(distances);
}

double mean_offset(const Curve& curve) {
  std::vector<double> offsets;
  for (const CurvePoint& p : curve) offsets.push_back(base::mean_of(p.ratio) - p.broberg);
  return base::mean_of(offsets);
}

double specimen_scatter(const Curve& curve) {
  std::vector<double> deviations;
  for (const CurvePoint& p : curve)
    if (p.ratio.size() > 1) deviations.push_back(scatter_of(p.ratio));
  return deviations.empty() ? 0.0 : base::mean_of(deviations);
}

Judgement is_near(const Curve& curve, Span span) {
  if (const std::string missing = missing_in(curve, span); !missing.empty()) return nothing_to_judge(missing);
  const Curve part = within(curve, span.from, span.to);
  const double distance = mean_distance(part), scatter = specimen_scatter(part);
  return {verdict_of(distance <= near_margin, scatter, near_margin),
          fmt::format("{}: mean |delta| {:.3f}, {}", span_text(span), distance, scatter_text(scatter))};
}

Judgement is_too_low(const Curve& curve, Span span) { return offset_judgement(curve, span, Side::below); }
Judgement is_too_high(const Curve& curve, Span span) { return offset_judgement(curve, span, Side::above); }

Judgement agrees_only_in(const Curve& curve, Span span) {
  if (const std::string missing = missing_in(curve, {}); !missing.empty()) return nothing_to_judge(missing);
  const Curve in = within(curve, span.from, span.to), out = outside(curve, span.from, span.to);
  const double inside = mean_distance(in), elsewhere = mean_distance(out);
  const double scatter = std::max(specimen_scatter(in), specimen_scatter(out));
  return {verdict_of(inside <= near_margin && elsewhere > near_margin, scatter, near_margin),
          fmt::format("mean |delta| {:.3f} over {}, {:.3f} elsewhere, {}", inside, span_text(span), elsewhere,
                      scatter_text(scatter))};
}

Judgement is_better(const Curve& curve, const Curve& than, Span span) {
  for (const Curve* c : {&curve, &than})
    if (const std::string missing = missing_in(*c, span); !missing.empty()) return nothing_to_judge(missing);
  const Curve a = within(curve, span.from, span.to), b = within(than, span.from, span.to);
  const std::map<long, double> of_a = distance_by_specimen(a), of_b = distance_by_specimen(b);
  std::vector<double> gains;
  for (const auto& [seed, distance] : of_a)
    if (of_b.contains(seed)) gains.push_back(of_b.at(seed) - distance);
  const double gain = mean_distance(b) - mean_distance(a);
  const double scatter = gains.empty() ? 0.0 : scatter_of(gains);
  return {verdict_of(gain > 0.0, scatter, std::abs(gain)),
          fmt::format("{}: mean |delta| {:.3f} against {:.3f}, scatter of the difference {:.3f}",
                      span_text(span), mean_distance(a), mean_distance(b), scatter)};
}

Judgement has_no_influence(const Curve& curve, const Curve& reference, Span span) {
  std::vector<double> distances, scatters;
  for (const CurvePoint& p : within(curve, span.from, span.to)) {
    const Curve other = within(reference, p.v, p.v);
    const Difference d = other.empty() ? Difference{} : difference_of(p, other.front());
    if (d.specimens == 0) continue;
    distances.push_back(std::abs(d.mean));
    scatters.push_back(d.scatter);
  }
  if (distances.empty()) return nothing_to_judge("no velocity in common");
  const double distance = base::mean_of(distances), scatter = base::mean_of(scatters);
  return {verdict_of(distance <= influence_margin, scatter, influence_margin),
          fmt::format("mean |difference| {:.3f} over {} velocities, {}", distance, distances.size(),
                      scatter_text(scatter))};
}

Judgement differs_by(const Curve& curve, const Curve& reference, double v, double value) {
  const Curve one = within(curve, v, v), other = within(reference, v, v);
  const Difference d =
      one.empty() || other.empty() ? Difference{} : difference_of(one.front(), other.front());
  if (d.specimens < 2) return nothing_to_judge(fmt::format("fewer than two specimens at {:g} c_R", v));
  const double away = std::abs(std::abs(d.mean) - value);
  const Verdict verdict = away <= value_errors * d.scatter       ? Verdict::holds
                          : away <= undecided_errors * d.scatter ? Verdict::not_decidable
                                                                 : Verdict::does_not_hold;
  return {verdict,
          fmt::format("|difference| {:.3f}, of a single specimen ± {:.3f}", std::abs(d.mean), d.scatter)};
}

Judgement is_quasi_constant(const CurvePoint& point) {
  const double trend = base::mean_of(point.trend);
  if (point.trend.empty() || std::isnan(trend)) return nothing_to_judge("no result");
  const double error = scatter_of(point.trend) / std::sqrt(static_cast<double>(point.trend.size()));
  const bool constant = std::abs(trend) <= std::max(constant_margin, constant_errors * error);
  return {yes_or_no(constant), fmt::format("{:g}: {:+.3f} ± {:.3f}", point.v, trend, error)};
}

Judgement is_mostly_constant(const Curve& curve, Span span) {
  if (const std::string missing = missing_in(curve, span); !missing.empty()) return nothing_to_judge(missing);
  int constant = 0, undecided = 0, all = 0;
  std::string list;
  for (const CurvePoint& p : within(curve, span.from, span.to)) {
    const Judgement j = is_quasi_constant(p);
    ++all;
    constant += j.verdict == Verdict::holds ? 1 : 0;
    undecided += j.verdict == Verdict::not_decidable ? 1 : 0;
    list += (list.empty() ? "" : ", ") + j.measured;
  }
  const Verdict verdict = 2 * constant > all                 ? Verdict::holds
                          : 2 * (constant + undecided) > all ? Verdict::not_decidable
                                                             : Verdict::does_not_hold;
  return {
      verdict,
      fmt::format("{} of {} velocities; second half of the window less the first, and its standard error, {}",
                  constant, all, list)};
}

Judgement is_near_value(const Curve& curve, double v, double value) {
  return judged_at(curve, v, [&](double ratio) { return std::abs(ratio - value) <= near_margin; });
}

Judgement is_below(const Curve& curve, double v, double value) {
  return judged_at(curve, v, [&](double ratio) { return ratio < value; });
}

Judgement all_of(const std::vector<Part>& parts) {
  Judgement whole{Verdict::holds, {}};
  for (const Part& part : parts) {
    const Verdict v = part.judgement.verdict;
    if (v == Verdict::does_not_hold || (v == Verdict::not_decidable && whole.verdict == Verdict::holds))
      whole.verdict = v;
    whole.measured += fmt::format("{}{} ({}): {}", whole.measured.empty() ? "" : "; ", part.label, name_of(v),
                                  part.judgement.measured);
  }
  if (parts.empty()) whole.verdict = Verdict::not_decidable;
  return whole;
}

}  // namespace rift::claims
