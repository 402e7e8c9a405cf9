#include "engine/accuracy/convergence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rift::accuracy {
namespace {

constexpr double smallest_difference = 1e-6;  // below it rounding and the balance error would be measured
constexpr double lowest_order = 0.5, highest_order = 4.5, same_order = 0.5;
constexpr double same_factor = 0.01;  // relative

/// Differences of the levels `first`, `first` + 1 and `first` + 2, finest first.
struct Triple {
  double factor = 0, fine = 0, coarse = 0;  // r, f_2 - f_1, f_3 - f_2
  double order() const { return std::log(coarse / fine) / std::log(factor); }
};

bool equally_apart(const std::vector<Level>& levels, std::size_t first) {
  if (first + 2 >= levels.size()) return false;
  const double fine = levels[first + 1].h / levels[first].h,
               coarse = levels[first + 2].h / levels[first + 1].h;
  return fine > 1.0 && std::abs(coarse / fine - 1.0) <= same_factor;
}

Triple triple_at(const std::vector<Level>& levels, std::size_t first) {
  return {levels[first + 1].h / levels[first].h, levels[first + 1].value - levels[first].value,
          levels[first + 2].value - levels[first + 1].value};
}

bool exceeds_uncertainty(const Level& a, const Level& b) {
  return std::abs(a.value - b.value) > 2.0 * std::hypot(a.uncertainty, b.uncertainty);
}

/// Why the finest levels show no clean order; empty where they do.
std::string objection(const std::vector<Level>& levels) {
  if (levels.size() < 3) return "fewer than three levels";
  if (!equally_apart(levels, 0)) return "the three finest levels are not a common factor apart";
  if (!exceeds_uncertainty(levels[0], levels[1]) || !exceeds_uncertainty(levels[1], levels[2]))
    return "the finest levels differ by less than the specimens scatter";
  const Triple t = triple_at(levels, 0);
  if (std::abs(t.fine) <= smallest_difference || std::abs(t.coarse) <= smallest_difference)
    return fmt::format("the finest levels differ by at most {:g}, mere rounding", smallest_difference);
  if (t.coarse / t.fine <= 0.0)
    return fmt::format("differences of {:+.1e} and {:+.1e} alternate", t.coarse, t.fine);
  if (t.order() < lowest_order || t.order() > highest_order)
    return fmt::format("{:.2f}, outside {:g} to {:g}", t.order(), lowest_order, highest_order);
  if (!equally_apart(levels, 1)) return {};
  const Triple next = triple_at(levels, 1);
  if (next.coarse / next.fine <= 0.0) return "coarser levels do not approach from one side";
  if (std::abs(next.order() - t.order()) > same_order)
    return fmt::format("{:.2f} at the finest levels, {:.2f} at the next", t.order(), next.order());
  return {};
}

}  // namespace

Convergence converge(std::vector<Level> levels) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::erase_if(levels, [](const Level& level) { return !std::isfinite(level.value); });
  if (levels.empty()) return {.clean = false, .order = nan, .limit = nan, .text = "no levels"};
  std::sort(levels.begin(), levels.end(), [](const Level& a, const Level& b) { return a.h < b.h; });
  if (const std::string why = objection(levels); !why.empty())
    return {.clean = false, .order = nan, .limit = levels.front().value, .text = "no clean order: " + why};
  const Triple t = triple_at(levels, 0);
  return {.clean = true,
          .order = t.order(),
          .limit = levels.front().value - t.fine / (std::pow(t.factor, t.order()) - 1.0),
          .text = fmt::format("observed order {:.2f}", t.order())};
}

}  // namespace rift::accuracy
