#include "engine/scene/derived.hpp"
#include "engine/theory/wave_loaded_crack.hpp"
#include "engine/theory/wave_speeds.hpp"
#include "engine/validation/crack_shape.hpp"
#include "engine/validation/problems.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rift::validation {
namespace {

constexpr double largest_radius = 0.5e-3;  // that the rules ask for [m]
constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

Verdict verdict_of(bool holds) { return holds ? Verdict::holds : Verdict::does_not_hold; }

template <class Value>
Spread spread_over(const std::vector<FreeCrack>& cracks, const Value& value) {
  std::vector<double> values;
  for (const FreeCrack& crack : cracks) values.push_back(value(crack));
  return spread_of(values);
}

std::string times_text(const Spread& s) {
  if (s.count == 0) return "in no realisation";
  return fmt::format("{:.2f} ± {:.2f} µs", 1e6 * s.mean, 1e6 * s.deviation);
}

double first_gone(const FreeCrack& crack) { return crack.gone.empty() ? undefined : crack.gone.front().time; }

theory::WaveLoadedCrack exact(const scene::Scene& scene, const FreeCrack& crack) {
  return theory::wave_loaded_crack(crack.young_modulus, crack.poisson_ratio, scene::density(scene),
                                   scene.material.plane, scene.breaking.release_rate.value(),
                                   scene.loading.traction.value(), crack.height);
}

/// Mean errors of the times at some advances. @param[in] every  whether each realisation must have got there
Finding times_of(const scene::Scene& scene, const std::vector<FreeCrack>& cracks,
                 const std::vector<double>& at, double within, bool by_energy, const std::string& rule) {
  Finding finding{rule, "", Verdict::holds};
  const auto errors = time_errors(scene, cracks, at, by_energy);
  for (std::size_t k = 0; k < at.size(); ++k) {
    const double advance = at[k];
    const Spread error = spread_of(errors[k]);
    const bool all = error.count == static_cast<int>(cracks.size());
    if (!finding.measured.empty()) finding.measured += "; ";
    finding.measured += fmt::format("{:g} mm ", 1e3 * advance);
    finding.measured += error.count == 0
                            ? std::string("never")
                            : fmt::format("{:+.1f} ± {:.1f} %", 1e2 * error.mean, 1e2 * error.deviation);
    if (!all) finding.measured += fmt::format(" ({} of {})", error.count, cracks.size());
    if (!all || !(std::abs(error.mean) <= within)) finding.verdict = Verdict::does_not_hold;
  }
  return finding;
}

std::vector<Finding> judge_wave_loaded(const scene::Scene& scene, const std::vector<FreeCrack>& cracks) {
  std::vector<Finding> findings{
      times_of(scene, cracks, {8e-3, 10e-3, 12e-3, 15e-3}, 0.10, false,
               "The tip's mean time since the waves met is within 10 % of the exact one at 8, 10, 12, 15 mm"),
      times_of(scene, cracks, {3e-3, 5e-3}, 0.20, false, "The same within 20 % at 3 and 5 mm"),
      times_of(
          scene, cracks, {5e-3, 8e-3, 10e-3, 12e-3, 15e-3}, 0.10, true,
          "Without a tip: the mean time at which the energy lost is G_c times the advance is within 10 % "
          "of the exact one (short waves, which carry energy away, make it 6 to 8 % late)")};
  const Spread energy =
      spread_over(cracks, [&](const FreeCrack& crack) { return energy_per_area(scene, crack); });
  findings.push_back({"Energy lost per area from 5 to 15 mm is 1.00 ± 0.15 G_c",
                      energy.count == 0
                          ? "15 mm is never reached"
                          : fmt::format("{:.2f} ± {:.2f} (standard error {:.2f}, {} of {})", energy.mean,
                                        energy.deviation, energy.error(), energy.count, cracks.size()),
                      verdict_of(energy.count > 0 && std::abs(energy.mean - 1.0) <= 0.15)});
  const Spread start = spread_over(cracks, [&](const FreeCrack& crack) {
    const theory::WaveLoadedCrack theory = exact(scene, crack);
    return theory.arrival + theory.delay;
  });
  findings.push_back({"First beam gone",
                      fmt::format("{}; exact start of the crack {}",
                                  times_text(spread_over(cracks, first_gone)), times_text(start)),
                      Verdict::reported});
  return findings;
}

std::vector<Finding> judge_branching(const Problem& problem, const scene::Scene& scene,
                                     const std::vector<FreeCrack>& cracks) {
  constexpr double margin = 2e-3, least = 15e-3;  // [m]
  const double rayleigh = scene::rayleigh_speed(scene);
  const Spread first = spread_over(cracks, first_gone);
  std::vector<Finding> findings{{fmt::format("Mean time of the first beam gone is {:g} ± {:g} µs",
                                             1e6 * problem.start, 1e6 * problem.start_within),
                                 times_text(first),
                                 verdict_of(first.count == static_cast<int>(cracks.size()) &&
                                            std::abs(first.mean - problem.start) <= problem.start_within)}};
  const Spread speed = spread_over(
      cracks, [&](const FreeCrack& crack) { return fitted_speed(crack, margin, least) / rayleigh; });
  findings.push_back({"Slope of the foremost tip's position, fitted over at least 15 mm, is at most 0.6 c_R",
                      speed.count == 0 ? "no tip reaches the edge"
                                       : fmt::format("{:.2f} ± {:.2f} c_R ({} of {})", speed.mean,
                                                     speed.deviation, speed.count, cracks.size()),
                      verdict_of(speed.count == static_cast<int>(cracks.size()) && speed.mean <= 0.6)});
  std::string tips, length;
  int two = 0;
  for (const FreeCrack& crack : cracks) {
    const CrackShape shape = shape_of(crack);
    two += shape.tips_at_edge == 2;
    tips += fmt::format("{}{}", tips.empty() ? "" : ", ", shape.tips_at_edge);
    length += fmt::format("{}{:.0f}", length.empty() ? "" : ", ", 1e3 * shape.length);
  }
  findings.push_back({"Exactly two tips reach the edge in at least two of three packings",
                      "tips at the edge: " + tips,
                      verdict_of(3 * two >= 2 * static_cast<int>(cracks.size()))});
  const Spread lost = spread_over(cracks, [&](const FreeCrack& crack) {
    return crack.fracture.back()[1] /
           (scene.breaking.release_rate.value() * crack.thickness * shape_of(crack).length);
  });
  findings.push_back({"Energy lost is within 25 % of G_c times the length of all branches",
                      fmt::format("{:.2f} ± {:.2f}; length {} mm", lost.mean, lost.deviation, length),
                      verdict_of(std::abs(lost.mean - 1.0) <= 0.25)});
  return findings;
}

}  // namespace

double Spread::error() const { return deviation / std::sqrt(static_cast<double>(count)); }

Spread spread_of(const std::vector<double>& values) {
  Spread spread;
  for (const double x : values)
    if (std::isfinite(x)) spread.mean += x, ++spread.count;
  if (spread.count == 0) return {undefined, undefined, 0};
  spread.mean /= spread.count;
  double squares = 0.0;
  for (const double x : values)
    if (std::isfinite(x)) squares += (x - spread.mean) * (x - spread.mean);
  spread.deviation = spread.count > 1 ? std::sqrt(squares / (spread.count - 1)) : undefined;
  return spread;
}

double energy_per_area(const scene::Scene& scene, const FreeCrack& crack) {
  constexpr double from = 5e-3, to = 15e-3;
  const auto tips = tip_history(crack);
  const double begin = time_reached(tips, crack.notch + from, true),
               end = time_reached(tips, crack.notch + to, true);
  if (!std::isfinite(begin) || !std::isfinite(end)) return undefined;
  return (value_at(crack.fracture, end) - value_at(crack.fracture, begin)) /
         (scene.breaking.release_rate.value() * crack.thickness * (to - from));
}

std::vector<std::vector<double>> time_errors(const scene::Scene& scene, const std::vector<FreeCrack>& cracks,
                                             std::span<const double> at, bool by_energy) {
  std::vector<std::vector<double>> errors(at.size());
  for (const FreeCrack& crack : cracks) {
    const theory::WaveLoadedCrack theory = exact(scene, crack);
    const auto tips = tip_history(crack);
    const double per_advance = scene.breaking.release_rate.value() * crack.thickness;
    for (std::size_t k = 0; k < at.size(); ++k) {
      const double time = by_energy ? time_reached(crack.fracture, per_advance * at[k])
                                    : time_reached(tips, crack.notch + at[k], true);
      errors[k].push_back((time - theory.arrival) / (theory.time_of(at[k]) - theory.arrival) - 1.0);
    }
  }
  return errors;
}

std::vector<Finding> judge(const Problem& problem, const scene::Scene& scene,
                           const std::vector<FreeCrack>& cracks) {
  std::vector<Finding> findings = problem.kind == Problem::Kind::wave_loaded
                                      ? judge_wave_loaded(scene, cracks)
                                      : judge_branching(problem, scene, cracks);
  const double radius = spread_over(cracks, [](const FreeCrack& c) { return c.mean_radius; }).mean;
  for (Finding& finding : findings)
    if (radius > largest_radius && finding.verdict != Verdict::reported)
      finding.verdict = Verdict::not_judged;
  double balance = 0.0;
  std::string diverged;
  for (const FreeCrack& crack : cracks) {
    balance = std::max(balance, crack.balance_error);
    if (!crack.diverged.empty())
      diverged += fmt::format("; seed {}{}: {}", crack.realisation.seed,
                              crack.realisation.mirrored ? ", mirrored" : "", crack.diverged);
  }
  findings.push_back({"The energy balance closes to 1e-10", fmt::format("{:.1e}{}", balance, diverged),
                      verdict_of(balance <= 1e-10 && diverged.empty())});
  return findings;
}

}  // namespace rift::validation
