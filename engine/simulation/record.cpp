#include "engine/simulation/record.hpp"

#include "engine/base/clock.hpp"
#include "engine/base/files.hpp"
#include "engine/base/ownership.hpp"
#include "engine/base/world_error.hpp"
#include "engine/ensemble/instruction_set.hpp"
#include "engine/results/archive.hpp"
#include "engine/results/journal_index.hpp"
#include "engine/results/json_input.hpp"
#include "engine/results/run_folder.hpp"
#include "engine/results/run_writer.hpp"
#include "engine/scene/issue.hpp"
#include "engine/simulation/kept_march.hpp"
#include "engine/simulation/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace rift::simulation {
namespace {

/// What a run does to its writer, then to whoever looks on.
struct Recording {
  results::RunWriter& writer;
  const Observer& beside;
  const std::filesystem::path& folder;
  double checkpoint_s;
  scene::Preset steered;      // with the changes so far, and those that are to come
  double taken_before_s = 0;  // by the run, in its earlier calls and in the preparation of this one
  base::Clock::time_point began = base::Clock::now();
  base::Clock::time_point checked = base::Clock::now();

  Observer observer() {
    Observer o;
    const auto written = [this](auto write, const auto& to_beside) {
      return [this, write, &to_beside](const auto& record) {
        (writer.*write)(record);
        if (to_beside) to_beside(record);
      };
    };
    o.sample = written(&results::RunWriter::sample, beside.sample);
    o.frame = written(&results::RunWriter::frame, beside.frame);
    o.event = written(&results::RunWriter::event, beside.event);
    o.gauge = [this](const results::GaugeRow& row) { writer.gauge(row); };
    o.ended = beside.ended;
    o.last_moment = beside.last_moment;
    o.go_on = [this](const Progress& p) {
      writer.flush();
      return !beside.go_on || beside.go_on(p);
    };
    if (beside.steer)
      o.steer = [this](const RunSnapshot& snapshot) {
        writer.flush();  // whoever steers may want to show to others what there is
        return beside.steer(snapshot);
      };
    o.checkpoint = [this](const auto& make, CheckpointMoment moment) {
      const bool due = base::seconds_since(checked) > checkpoint_s;
      if (moment == CheckpointMoment::before_stop || (moment == CheckpointMoment::on_the_way && due))
        keep_checkpoint(make());
    };
    o.changed = [this](const scene::Change& change, const std::string& refused) {
      if (refused.empty()) keep(change);
      if (beside.changed) beside.changed(change, refused);
    };
    return o;
  }

  /// What the run has taken so far, in all its calls [s].
  double so_far_s() const { return taken_before_s + base::seconds_since(began); }

  void keep_checkpoint(results::Checkpoint checkpoint) {
    writer.flush();
    checkpoint.journal_bytes = writer.journal_bytes();
    set_taken_s(checkpoint, so_far_s());
    results::write_checkpoint(folder, checkpoint);
    checked = base::Clock::now();
  }

  /// At once, so that a kill does not lose it.
  void keep(const scene::Change& change) {
    std::vector<scene::Change>& all = steered.steering;
    if (std::find(all.begin(), all.end(), change) == all.end()) all.push_back(change);
    base::write_whole_file(folder / results::steering_name, scene::preset_text(steered));
  }
};

/// Marches, writing all of it, and completes the folder.
Recorded record(const Prepared& prepared, Recording& recording, const BuildInfo& build,
                const MarchOptions& options, const Resumption* from) {
  Recorded run{march(prepared, recording.observer(), options, from), {}};
  Prepared as_steered;
  if (!run.result.steered.empty()) as_steered = prepared, as_steered.lane = run.result.steered;
  const Prepared& done = run.result.steered.empty() ? prepared : as_steered;
  std::vector<Rates> rates;
  std::vector<std::vector<results::RatePoint>> curves;
  for (int lane = 0; lane < static_cast<int>(done.lane.size()); ++lane) {
    rates.push_back(rates_of(done, run.result, lane));
    curves.push_back(rates.back().curve);
  }
  run.summary = summary_of(done, run.result, rates, build, recording.so_far_s());
  if (recording.beside.stage) recording.beside.stage("archive");
  recording.writer.finish(run.summary, curves);
  if (run.result.outcome != Outcome::stopped) results::remove_checkpoints(recording.folder);
  return run;
}

}  // namespace

Recorded record_run(const Prepared& prepared, const std::filesystem::path& folder, const BuildInfo& build,
                    const Observer& beside, const MarchOptions& options, double preparation_s) {
  results::RunWriter writer(folder, header_of(prepared, build), geometry_of(prepared),
                            mechanics_of(prepared));
  Recording recording{writer, beside, folder, options.checkpoint_s, prepared.preset, preparation_s};
  return record(prepared, recording, build, options, nullptr);
}

Recorded resume_run(const Prepared& prepared, const std::filesystem::path& folder, const BuildInfo& build,
                    const Observer& beside, std::string& note, const MarchOptions& options,
                    double preparation_s) {
  const base::OwnedFolder owned(folder);
  if (!owned.has_locks()) note = no_locks_note(folder);
  const results::RunState state = results::inspect_run(folder);
  std::optional<results::Checkpoint> checkpoint = results::read_checkpoint(folder, state.good_bytes, note);
  if (!checkpoint) {
    const std::string steering = std::filesystem::exists(folder / results::steering_name)
                                     ? base::read_whole_file(folder / results::steering_name)
                                     : std::string{};
    results::clear_run_folder(folder);
    if (!steering.empty()) base::write_whole_file(folder / results::steering_name, steering);
    return record_run(prepared, folder, build, beside, options, preparation_s);
  }
  results::RunWriter writer(folder, checkpoint->journal_bytes);
  Resumption from{std::move(*checkpoint), results::scan_journal(folder / results::journal_name).samples};
  if (beside.sample)
    for (const results::Sample& row : from.samples) beside.sample(row);
  Recording recording{writer,          beside,
                      folder,          options.checkpoint_s,
                      prepared.preset, preparation_s + taken_s(from.checkpoint)};
  return record(prepared, recording, build, options, &from);
}

RunResult result_of_run(const std::filesystem::path& folder) {
  const results::RunState state = results::inspect_run(folder);
  const auto summary = results::read_json(state.summary_json.value(), folder / results::journal_name);
  RunResult result;
  for (const auto& scenario : summary.at("scenarios")) {
    LaneResult& lane = result.lane.emplace_back();
    for (const Outcome outcome : {Outcome::finished, Outcome::stopped, Outcome::diverged})
      if (scenario.at("outcome") == name_of(outcome)) lane.outcome = outcome;
    result.outcome = std::max(result.outcome, lane.outcome);
  }
  for (const results::Sample& row : results::scan_journal(folder / results::journal_name).samples) {
    LaneResult& lane = result.lane.at(static_cast<std::size_t>(row.lane));
    lane.samples.push_back(row);
    if (!(std::abs(row.residual) <= lane.worst_residual)) lane.worst_residual = std::abs(row.residual);
  }
  return result;
}

std::string no_locks_note(const std::filesystem::path& folder) {
  return fmt::format(
      "the file system of {} has no locks: another process could write into it at the same time",
      folder.string());
}

namespace {

/// As the journal says; nothing of it is still to be computed.
bool lanes_have_ended(const std::filesystem::path& folder, const results::RunState& state) {
  if (!state.summary_json) return false;
  const auto summary = results::read_json(*state.summary_json, folder / results::journal_name);
  for (const auto& scenario : summary.at("scenarios"))
    if (scenario.value("outcome", std::string()) == name_of(Outcome::stopped)) return false;
  return true;
}

bool files_of_end_are_there(const std::filesystem::path& folder, const results::RunState& state) {
  return state.has_archive && std::filesystem::exists(folder / results::summary_name);
}

}  // namespace

bool has_ended(const std::filesystem::path& folder) {
  const results::RunState state = results::inspect_run(folder);
  return lanes_have_ended(folder, state) && files_of_end_are_there(folder, state);
}

bool complete_end(const std::filesystem::path& folder) {
  const results::RunState state = results::inspect_run(folder);
  if (!lanes_have_ended(folder, state) || files_of_end_are_there(folder, state)) return false;
  const base::OwnedFolder owned(folder);
  results::complete_folder(folder);
  results::remove_checkpoints(folder);
  return true;
}

bool is_unfinished_run_of(const std::filesystem::path& folder, const scene::Preset& preset,
                          const BuildInfo& build) {
  const results::RunState state = results::inspect_run(folder);
  if (state.header_json.empty()) return false;
  const auto header = results::read_json(state.header_json, folder / results::journal_name);
  return header.value("preset", "") == scene::preset_text(preset) &&
         header.value("version", "") == build.version &&
         header.value("instruction_set", "") == ensemble::name_of(ensemble::instruction_set()) &&
         !has_ended(folder);
}

scene::Preset preset_of_run(const std::filesystem::path& folder) {
  const results::RunState state = results::inspect_run(folder);
  if (state.header_json.empty())
    throw base::WorldError("read", folder, state.reason.empty() ? "there is no run in it" : state.reason);
  const auto header = results::read_json(state.header_json, folder / results::journal_name);
  const std::filesystem::path steered = folder / results::steering_name;
  scene::Preset preset =
      std::filesystem::exists(steered)
          ? scene::read_preset(steered)
          : scene::read_preset_text(header.at("preset").get<std::string>(), header.at("preset_name"));
  if (!preset.issues.empty()) throw scene::InputError(preset.issues);
  preset.name = header.at("preset_name");
  return preset;
}

}  // namespace rift::simulation
