#include "engine/simulation/record.hpp"

#include "engine/results/run_writer.hpp"
#include "engine/simulation/summary.hpp"

#include <chrono>

namespace rift {
namespace {

Observer writing_to(results::RunWriter& writer, const std::function<bool(const Progress&)>& go_on) {
  return {.sample = [&](const results::Sample& s) { writer.sample(s); },
          .frame = [&](const results::Frame& f) { writer.frame(f); },
          .event = [&](const results::ReleaseEvent& e) { writer.event(e); },
          .go_on =
              [&](const Progress& p) {
                writer.flush();
                return !go_on || go_on(p);
              }};
}

}  // namespace

Recorded record_run(const Prepared& prepared, const std::filesystem::path& folder, const BuildInfo& build,
                    const std::function<bool(const Progress&)>& go_on, const MarchOptions& options,
                    double preparation_s) {
  const auto start = std::chrono::steady_clock::now();
  results::RunWriter writer(folder, header_of(prepared, build), geometry_of(prepared));
  Recorded run{march(prepared, writing_to(writer, go_on), options), {}};
  std::vector<Rates> rates;
  std::vector<std::vector<results::RatePoint>> curves;
  for (int lane = 0; lane < static_cast<int>(prepared.lane.size()); ++lane) {
    rates.push_back(rates_of(prepared, run.result, lane));
    curves.push_back(rates.back().curve);
  }
  const double marching_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  run.summary = summary_of(prepared, run.result, rates, build, preparation_s + marching_s);
  writer.finish(run.summary, curves);
  return run;
}

}  // namespace rift
