#include "engine/simulation/record.hpp"

#include "engine/results/archive.hpp"
#include "engine/results/files.hpp"
#include "engine/results/run_writer.hpp"
#include "engine/simulation/summary.hpp"

#include <chrono>

namespace rift {
namespace {

/// What a run does to its writer, then to whoever looks on.
struct Recording {
  results::RunWriter& writer;
  const Observer& beside;
  const std::filesystem::path& folder;
  Preset steered;  // with the changes so far

  Observer observer() {
    Observer o{.sample =
                   [&](const results::Sample& s) {
                     writer.sample(s);
                     if (beside.sample) beside.sample(s);
                   },
               .frame =
                   [&](const results::Frame& f) {
                     writer.frame(f);
                     if (beside.frame) beside.frame(f);
                   },
               .event =
                   [&](const results::ReleaseEvent& e) {
                     writer.event(e);
                     if (beside.event) beside.event(e);
                   },
               .go_on =
                   [&](const Progress& p) {
                     writer.flush();
                     return !beside.go_on || beside.go_on(p);
                   },
               .ended = beside.ended};
    if (beside.steer)
      o.steer = [&](const Moment& moment) {
        writer.flush();  // whoever steers may want to show to others what there is
        return beside.steer(moment);
      };
    o.changed = [&](const Change& change, const std::string& refused) {
      if (refused.empty()) keep(change);
      if (beside.changed) beside.changed(change, refused);
    };
    return o;
  }

  /// At once, so that a kill does not lose it.
  void keep(const Change& change) {
    steered.steering.push_back(change);
    results::write_whole_file(folder / results::steering_name, preset_text(steered));
  }
};

}  // namespace

Recorded record_run(const Prepared& prepared, const std::filesystem::path& folder, const BuildInfo& build,
                    const Observer& beside, const MarchOptions& options, double preparation_s) {
  const auto start = std::chrono::steady_clock::now();
  results::RunWriter writer(folder, header_of(prepared, build), geometry_of(prepared));
  Recording recording{writer, beside, folder, prepared.preset};
  recording.steered.steering.clear();
  Recorded run{march(prepared, recording.observer(), options), {}};
  Prepared as_steered;
  if (!run.result.steered.empty()) as_steered = prepared, as_steered.lane = run.result.steered;
  const Prepared& done = run.result.steered.empty() ? prepared : as_steered;
  std::vector<Rates> rates;
  std::vector<std::vector<results::RatePoint>> curves;
  for (int lane = 0; lane < static_cast<int>(done.lane.size()); ++lane) {
    rates.push_back(rates_of(done, run.result, lane));
    curves.push_back(rates.back().curve);
  }
  const double marching_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  run.summary = summary_of(done, run.result, rates, build, preparation_s + marching_s);
  writer.finish(run.summary, curves);
  return run;
}

}  // namespace rift
