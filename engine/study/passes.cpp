#include "engine/study/passes.hpp"

#include "engine/ensemble/instruction_set.hpp"
#include "engine/scene/derived.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

namespace rift::study {
namespace {

/// Lanes as a part of most_lanes, and what a step of so many takes, in steps of a half   [measured with
/// AVX-512, 20,000 elements]. One lane gathers its neighbours, so that it is little cheaper; a quarter is for
/// processors with no wider registers.
struct Width {
  int part;
  double step;
};

template <class Real>
std::vector<Width> widths() {
  std::vector<Width> usable{{ensemble::most_lanes<Real>, 0.7}};
  for (const Width& width : {Width{4, 1.1}, Width{2, 1.0}, Width{1, 2.1}})
    if (ensemble::most_lanes<Real> / width.part <=
        ensemble::lanes_in_register<Real>(ensemble::instruction_set()))
      usable.push_back(width);
  return usable;
}

template <class Real>
Queue soonest_in(const std::vector<std::int64_t>& steps) {
  const auto longest = static_cast<double>(*std::max_element(steps.begin(), steps.end()));
  const auto all = static_cast<double>(std::accumulate(steps.begin(), steps.end(), std::int64_t{0}));
  Queue best;
  for (const Width& width : widths<Real>()) {
    const int lanes = ensemble::most_lanes<Real> / width.part;
    const double time = width.step * std::max(longest, all / lanes);
    if (best.time == 0.0 || time < best.time) best = {lanes, time};
  }
  return best;
}

}  // namespace

std::vector<std::vector<std::size_t>> passes_of(const std::vector<simulation::LanePlan>& lanes) {
  const auto kind = [&](std::size_t k) {
    const simulation::LanePlan& lane = lanes[k];
    const bool moving = scene::grip_moves(lane.scene);  // by one clock
    return std::tuple(lane.step.dt, lane.scene.damping.region == scene::DampingRegion::none,
                      moving ? lane.lead : 0.0, moving ? lane.units.time : 0.0);
  };
  const auto length = [&](std::size_t k) {
    return history::time_of_arrival(lanes[k].scenario.history, lanes[k].crack_end);
  };
  std::vector<std::size_t> order(lanes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return length(a) > length(b); });
  const ensemble::Precision precision = lanes.front().scene.solver.precision;
  const auto most = static_cast<std::size_t>(lanes_of_many(precision));
  const bool one_grip = lanes.front().scene.loading.method == scene::LoadingMethod::ramp ||
                        scene::grip_moves(lanes.front().scene);
  std::vector<std::vector<std::size_t>> passes;
  for (const std::size_t k : order) {
    const auto fits = [&](const std::vector<std::size_t>& pass) {
      return kind(pass.front()) == kind(k) && !(one_grip && pass.size() >= most);
    };
    const auto pass = std::find_if(passes.begin(), passes.end(), fits);
    if (pass == passes.end()) {
      passes.push_back({k});
    } else {
      pass->push_back(k);
    }
  }
  return passes;
}

Queue soonest(const std::vector<std::int64_t>& steps, ensemble::Precision precision) {
  return precision == ensemble::Precision::single_precision ? soonest_in<float>(steps)
                                                            : soonest_in<double>(steps);
}

int lanes_of_many(ensemble::Precision precision) {
  return soonest(std::vector<std::int64_t>(1000, 1), precision).lanes;
}

}  // namespace rift::study
