#include "engine/claims/cylinders.hpp"

#include "engine/calibration/calibrate.hpp"
#include "engine/lattice/lattice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace rift::claims {
namespace {

constexpr double converged_elements = 15000, converged_margin = 0.025;  // the paper's words of Fig. 17
constexpr double table_young = 10.3, table_margin = 0.03;               // [GPa]; the margin is ours
constexpr double least_poisson = 0.30, most_poisson = 0.33;
constexpr double micro_gpa = lattice::bulk_micro_material.young_modulus / 1e9;

/// A number of the cylinders, by their elements.
using Sizes = std::map<double, calibration::Scattered>;
Sizes by_size(const Evidence& evidence, double calibration::Response::*number, double scale) {
  std::map<double, std::vector<double>> values;
  for (const calibration::CylinderResult& cylinder : evidence.cylinders)
    values[cylinder.packing.elements].push_back(scale * cylinder.responses.front().*number);
  Sizes means;
  for (const auto& [elements, all] : values) means[elements] = calibration::scattered(all);
  return means;
}

Sizes large_ones(Sizes sizes) {
  std::erase_if(sizes, [](const auto& size) { return size.first < converged_elements; });
  return sizes;
}

double mean_over(const Sizes& sizes) {
  double sum = 0.0;
  for (const auto& [elements, s] : sizes) sum += s.mean;
  return sum / static_cast<double>(sizes.size());
}

std::string list_of(const Sizes& sizes, int digits) {
  std::string list;
  for (const auto& [elements, s] : sizes)
    list += fmt::format("{}{:.{}f} at {:.0f}", list.empty() ? "" : ", ", s.mean, digits, elements);
  return list;
}

/// Every mean above 15,000 elements within 2.5 % of their common mean.
Judgement converges(const Sizes& all, const char* name, int digits) {
  const auto sizes = large_ones(all);
  if (sizes.size() < 2) return {Verdict::not_decidable, "fewer than two sizes of 15,000 elements and more"};
  const double mean = mean_over(sizes);
  double farthest = 0.0;
  for (const auto& [elements, s] : sizes) farthest = std::max(farthest, std::abs(s.mean / mean - 1.0));
  return {yes_or_no(farthest <= converged_margin),
          fmt::format("{} {}: differ from their mean by up to {:.1f} %", name, list_of(all, digits),
                      100.0 * farthest)};
}

Judgement young_of_table(const Evidence& evidence) {
  const auto sizes = large_ones(by_size(evidence, &calibration::Response::young_over_micro, micro_gpa));
  if (sizes.empty()) return {Verdict::not_decidable, "no cylinder of 15,000 elements"};
  const double mean = mean_over(sizes);
  return {yes_or_no(std::abs(mean / table_young - 1.0) <= table_margin),
          fmt::format("E {} GPa, mean {:.2f}, {:+.1f} % of 10.3 (margin 3 %)", list_of(sizes, 2), mean,
                      100.0 * (mean / table_young - 1.0))};
}

Judgement poisson_of_table(const Evidence& evidence) {
  const auto sizes = large_ones(by_size(evidence, &calibration::Response::poisson_ratio, 1.0));
  if (sizes.empty()) return {Verdict::not_decidable, "no cylinder of 15,000 elements"};
  const bool all_within = std::ranges::all_of(sizes, [](const auto& size) {
    return size.second.mean >= least_poisson && size.second.mean <= most_poisson;
  });
  return {yes_or_no(all_within), fmt::format("ν {} (0.30 to 0.33 counts as 0.3)", list_of(sizes, 3))};
}

}  // namespace

Judgement cylinders_converge(const Evidence& evidence) {
  return all_of(
      {{"E [GPa]", converges(by_size(evidence, &calibration::Response::young_over_micro, micro_gpa), "E", 2)},
       {"ν", converges(by_size(evidence, &calibration::Response::poisson_ratio, 1.0), "ν", 3)}});
}

Judgement cylinders_meet_table2(const Evidence& evidence) {
  return all_of({{"modulus", young_of_table(evidence)}, {"Poisson's ratio", poisson_of_table(evidence)}});
}

}  // namespace rift::claims
