#include "engine/claims/broberg_problem.hpp"

#include "engine/base/numbers.hpp"
#include "engine/base/student.hpp"
#include "engine/theory/references.hpp"
#include "engine/theory/strip_transient.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

namespace rift::claims {
namespace {

constexpr int stretches = 10;  // of the half length, over each of which both cracks are compared

long rounded(double number) { return std::lround(1e6 * number); }

/// What the crack of a series has released when its tip is at a position, straight between its rows [J].
class CrackEnergy {
 public:
  explicit CrackEnergy(const SeriesTable& series) {
    const std::vector<double>&tip = series.at("tip_m"), &energy = series.at("energy_fracture_j");
    for (std::size_t k = 0; k < tip.size(); ++k)
      if (!std::isnan(tip[k]) && (rows_.empty() || tip[k] > rows_.back()[0]))
        rows_.push_back({tip[k], energy[k]});
  }
  double between(double from, double to) const { return at(to) - at(from); }
  double last() const { return rows_.back()[0]; }

 private:
  double at(double tip) const {
    const auto [k, part] = base::interval_at(rows_, tip, [](const auto& row) { return row[0]; });
    return std::lerp(rows_[k - 1][1], rows_[k][1], part);
  }
  std::vector<std::array<double, 2>> rows_;
};

/// The cracks of one packing, velocity and zone.
struct Cracks {
  const SummaryRow* opening = nullptr;
  std::vector<const SummaryRow*> strips;
};
using Place = std::tuple<long, long, long>;  // velocity, zone, elements

std::map<Place, std::map<long, Cracks>> cracks_of(const Evidence& evidence) {
  std::map<Place, std::map<long, Cracks>> found;
  for (const SummaryRow& row : evidence.rows) {
    if (row.technique != "progressive" || rounded(row.relaxation) != rounded(1.0)) continue;
    const Place place(rounded(row.crack_velocity_over_cr), rounded(row.damage_zone_ratio),
                      std::lround(row.elements));
    Cracks& cracks = found[place][std::lround(row.seed)];
    if (row.tips > 1.5)
      cracks.opening = &row;
    else
      cracks.strips.push_back(&row);
  }
  return found;
}

/// What one packing shows.
struct Pair {
  double ratio = 0, efficiency = 0, own_v = 0, broberg = 0, per_cent_of_speed = 0,
         radius_over_half_length = 0;
};

/// Over stretches of the half length, the crack that opens releases
///   2 b slope a da η Broberg,   η = (E_right + E_left) / (2 b G_I0 da arrival) of the same beams.
std::optional<Pair> compare(const Cracks& cracks, const Evidence& evidence) {
  const SummaryRow& row = *cracks.opening;
  const OwnPlate own = evidence.own(row);
  const CrackEnergy opening(evidence.series(row));
  std::vector<CrackEnergy> through;
  for (const SummaryRow* strip : cracks.strips) through.emplace_back(evidence.series(*strip));
  const double middle = 0.5 * row.length_m, echo = row.echo_free_over_length * row.length_m;
  const double from = std::max(window_from * echo, least_zones * row.damage_zone_ratio * row.mean_radius_m);
  double to = std::min(echo, opening.last());
  for (const CrackEnergy& strip : through) to = std::min(to, strip.last() - middle);
  if (!(from < to)) return {};
  const double da = (to - from) / stretches, b = row.thickness_m;
  const double slope =
      2.0 * row.g_i0_j_m2 / (row.length_m * (row.window_over_length[0] + row.window_over_length[1]));
  std::vector<double> strips(stretches, 0.0);  // mean of both ways, over b G_I0 da and arrival: η
  for (std::size_t n = 0; n < through.size(); ++n)
    for (int k = 0; k < stretches; ++k) {
      const double tip = middle + from + k * da;
      const double arrives =
          theory::strip_arrival(row.crack_velocity_over_cr, tip / own.height, (tip + da) / own.height);
      strips[static_cast<std::size_t>(k)] += through[n].between(tip, tip + da) /
                                             (b * da * cracks.strips[n]->g_i0_j_m2 * arrives) /
                                             static_cast<double>(through.size());
    }
  double taken = 0.0, arrived = 0.0;  // [J]
  for (int k = 0; k < stretches; ++k) {
    const double stored = 2.0 * b * slope * (from + (k + 0.5) * da) * da;
    arrived += stored, taken += stored * strips[static_cast<std::size_t>(k)];
  }
  Pair pair{.ratio = opening.between(from, to) / arrived, .efficiency = taken / arrived};
  const auto factor = [&](double speed) {
    pair.own_v = row.crack_velocity_over_cr * row.rayleigh_speed_m_s / speed;
    return theory::broberg(pair.own_v, own.poisson_ratio, theory::Plane::stress).g;
  };
  const double faster = factor(1.01 * own.rayleigh_speed);
  pair.broberg = factor(own.rayleigh_speed);
  pair.per_cent_of_speed = faster / pair.broberg - 1.0;
  pair.radius_over_half_length = 2.0 * row.mean_radius_m / (from + to);
  return pair;
}

/// Weights of the means whose sum is L, by least squares; empty where they are too few.
Eigen::VectorXd weights_of_limit(const std::vector<const BrobergProblem*>& points) {
  const bool zones = std::any_of(points.begin(), points.end(), [&](const BrobergProblem* p) {
    return rounded(p->zone) != rounded(points.front()->zone);
  });
  Eigen::MatrixXd terms(static_cast<Eigen::Index>(points.size()), zones ? 3 : 2);
  for (Eigen::Index k = 0; k < terms.rows(); ++k) {
    const BrobergProblem& p = *points[static_cast<std::size_t>(k)];
    terms(k, 0) = 1.0, terms(k, 1) = p.radius_over_half_length;
    if (zones) terms(k, 2) = p.zone * p.radius_over_half_length;
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(terms);
  if (terms.rows() < terms.cols() || solver.rank() < terms.cols()) return {};
  return solver.solve(Eigen::MatrixXd::Identity(terms.rows(), terms.rows())).row(0).transpose();
}

std::optional<BrobergLimit> limit_of(const std::vector<const BrobergProblem*>& points) {
  const Eigen::VectorXd weight = weights_of_limit(points);
  if (weight.size() == 0) return {};
  BrobergLimit limit{.v = points.front()->v, .per_cent_of_speed = points.back()->per_cent_of_speed};
  std::map<long, std::map<long, double>> parts;  // of each size, by packing: its zones' share of the limit
  for (std::size_t k = 0; k < points.size(); ++k) {
    const BrobergProblem& p = *points[k];
    limit.limit += weight(static_cast<Eigen::Index>(k)) * base::mean_of(p.over_theory);
    for (std::size_t n = 0; n < p.seed.size(); ++n)
      parts[std::lround(p.elements)][p.seed[n]] += weight(static_cast<Eigen::Index>(k)) * p.over_theory[n];
  }
  double squares = std::pow(limit.limit * arrival_uncertainty, 2.0);
  for (const auto& [elements, of_packing] : parts) {
    std::vector<double> numbers;
    for (const auto& [seed, part] : of_packing) numbers.push_back(part);
    if (numbers.size() < 2) return {};
    squares += std::pow(base::standard_error_of(numbers), 2.0);
  }
  limit.uncertainty = std::sqrt(squares);
  return limit;
}

Judgement judge_limit(const BrobergLimit& limit) {
  const double away = std::abs(limit.limit - 1.0);
  const Verdict verdict = away > broberg_margin + limit.uncertainty ? Verdict::does_not_hold
                          : away <= broberg_margin && limit.uncertainty <= broberg_uncertainty
                              ? Verdict::holds
                              : Verdict::not_decidable;
  return {verdict, fmt::format("{:.3f} ± {:.3f}", limit.limit, limit.uncertainty)};
}

}  // namespace

std::vector<BrobergProblem> broberg_problem(const Evidence& evidence) {
  if (!evidence.series || !evidence.own) return {};
  std::vector<BrobergProblem> list;
  for (const auto& [place, packings] : cracks_of(evidence)) {
    BrobergProblem point;
    std::vector<double> own_v, broberg, per_cent, size;
    for (const auto& [seed, cracks] : packings) {
      if (!cracks.opening || cracks.strips.size() < 2) continue;
      const std::optional<Pair> pair = compare(cracks, evidence);
      if (!pair) continue;
      point.v = cracks.opening->crack_velocity_over_cr, point.zone = cracks.opening->damage_zone_ratio;
      point.elements = cracks.opening->elements;
      point.seed.push_back(seed), point.ratio.push_back(pair->ratio);
      point.efficiency.push_back(pair->efficiency);
      point.over_theory.push_back(pair->ratio / (pair->efficiency * pair->broberg));
      own_v.push_back(pair->own_v), broberg.push_back(pair->broberg);
      per_cent.push_back(pair->per_cent_of_speed), size.push_back(pair->radius_over_half_length);
    }
    if (point.seed.empty()) continue;
    point.own_v = base::mean_of(own_v), point.broberg = base::mean_of(broberg);
    point.per_cent_of_speed = base::mean_of(per_cent), point.radius_over_half_length = base::mean_of(size);
    list.push_back(std::move(point));
  }
  return list;
}

std::vector<BrobergLimit> broberg_limits(const std::vector<BrobergProblem>& points) {
  std::map<long, std::vector<const BrobergProblem*>> of_velocity;
  for (const BrobergProblem& p : points) of_velocity[rounded(p.v)].push_back(&p);
  std::vector<BrobergLimit> limits;
  for (const auto& [v, of_it] : of_velocity)
    if (const std::optional<BrobergLimit> limit = limit_of(of_it)) limits.push_back(*limit);
  return limits;
}

Judgement judge_broberg(const Evidence& evidence) {
  const std::vector<BrobergProblem> points = broberg_problem(evidence);
  const std::vector<BrobergLimit> limits = broberg_limits(points);
  std::vector<Part> parts;
  for (const double v : decided_velocities) {
    const auto at = std::find_if(limits.begin(), limits.end(),
                                 [v](const BrobergLimit& limit) { return rounded(limit.v) == rounded(v); });
    parts.push_back({fmt::format("{:g} c_R", v),
                     at == limits.end() ? Judgement{Verdict::not_decidable, "no result"} : judge_limit(*at)});
  }
  Judgement all = all_of(parts);
  std::string text = "G_ID / η over Broberg for R = 0 (± standard uncertainty): " + all.measured;
  for (const BrobergLimit& limit : limits)
    if (std::none_of(std::begin(decided_velocities), std::end(decided_velocities),
                     [&](double v) { return rounded(limit.v) == rounded(v); }))
      text +=
          fmt::format("; {:g} c_R is not judged, because one per cent of c_R is {:.1f} % of the factor there",
                      limit.v, 100.0 * limit.per_cent_of_speed);
  text += "; means of the packings before:";
  for (const BrobergProblem& p : points)
    text +=
        fmt::format(" {:.3f} ± {:.3f} at {:g}, r_l = {:g}, {:.0f} elements;", base::mean_of(p.over_theory),
                    base::standard_error_of(p.over_theory), p.v, p.zone, p.elements);
  text.pop_back();
  all.measured = text;
  return all;
}

}  // namespace rift::claims
