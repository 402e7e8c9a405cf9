#include "engine/simulation/kept_march.hpp"

#include "engine/base/clock.hpp"
#include "engine/base/text.hpp"
#include "engine/base/world_error.hpp"
#include "engine/results/json_input.hpp"
#include "engine/results/series.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <system_error>
#include <vector>

// The words of a checkpoint. A number that is none stands as null: JSON has no NaN.

namespace rift::scene {
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Change, lane, step, axis, value)
}
namespace rift::fracture {
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Wake, cell_m, kinetic_j, rotation_j, out_of_plane_m)
}

namespace rift::simulation {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Rest, since, driving, reference, sum, looks, restarted_m)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(LaneSlot, scenario, next_sample, next_frame, framed_at, rest,
                                                since_s)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BrokenBeams, gone, softened, first_s, leading_m)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LaneResult, outcome, steps, where, worst_residual, prestress_kinetic,
                                   energy_at_crack_start, wall_s, arrested_m, changes, broken, wake)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(MarchNotes, lanes, instructions, dt, marched, lane_steps,
                                                next_scenario, cracking, wall_prestress_s, wall_fracture_s,
                                                seats, lane)

std::string to_json(const MarchNotes& notes) { return base::json_text(nlohmann::json(notes)); }

MarchNotes march_notes(const std::string& text) try {
  nlohmann::json json = results::json_or_discarded(text);
  for (nlohmann::json& lane : json.at("lane"))
    for (const char* name : {"worst_residual", "arrested_m"})
      if (lane.at(name).is_null()) lane[name] = std::numeric_limits<double>::quiet_NaN();
  MarchNotes notes = json;
  for (const LaneResult& lane : notes.lane)
    if (lane.outcome < Outcome::finished || lane.outcome > Outcome::diverged)
      throw std::invalid_argument("its notes name an unknown outcome");
  return notes;
} catch (const nlohmann::json::exception& error) {
  throw std::invalid_argument(std::string("its notes are not of a checkpoint: ") + error.what());
}

void set_taken_s(results::Checkpoint& checkpoint, double seconds) {
  nlohmann::json notes = results::json_or_discarded(checkpoint.notes);
  notes["taken_s"] = seconds;
  checkpoint.notes = base::json_text(notes);
}

double taken_s(const results::Checkpoint& checkpoint) {
  const nlohmann::json notes = results::json_or_discarded(checkpoint.notes);
  return notes.is_object() && notes.contains("taken_s") && notes["taken_s"].is_number()
             ? notes["taken_s"].get<double>()
             : 0.0;
}

namespace {

namespace fs = std::filesystem;
using results::Sample;

constexpr const char* rows_name = "rows";
constexpr std::size_t numbers_of_row = 4 + results::sample_columns.size();

void append_row(std::vector<double>& numbers, const Sample& row) {
  for (const double x : {static_cast<double>(row.step), row.time_s, static_cast<double>(row.phase),
                         static_cast<double>(row.lane)})
    numbers.push_back(x);
  for (const auto& column : results::sample_columns) numbers.push_back(row.*column.value);
}

/// Throws std::invalid_argument where the numbers are no row's.
Sample row_from(const double* numbers) {
  const auto whole = [](double x, double most) {
    if (!(x >= 0.0 && x <= most) || x != std::trunc(x))
      throw std::invalid_argument("one of its rows has an invalid step, phase or lane");
    return x;
  };
  Sample row;
  row.step = static_cast<std::int64_t>(whole(numbers[0], 0x1p53));
  row.time_s = numbers[1];
  row.phase = static_cast<results::Phase>(whole(numbers[2], static_cast<double>(results::Phase::fracture)));
  row.lane = static_cast<std::int32_t>(whole(numbers[3], std::numeric_limits<std::int32_t>::max()));
  for (std::size_t k = 0; k < results::sample_columns.size(); ++k)
    row.*results::sample_columns[k].value = numbers[4 + k];
  return row;
}

/// The checkpoint as it lies in the file: its notes with the identity around them, its state with the rows
/// beside it.
results::Checkpoint wrapped(results::Checkpoint checkpoint, const std::string& identity,
                            const std::vector<Sample>& rows) {
  checkpoint.notes = base::json_text(
      nlohmann::json{{"identity", identity}, {"march", results::json_or_discarded(checkpoint.notes)}});
  std::vector<double>& numbers = checkpoint.state[rows_name];
  numbers.reserve(rows.size() * numbers_of_row);
  for (const Sample& row : rows) append_row(numbers, row);
  return checkpoint;
}

Resumption unwrapped(results::Checkpoint checkpoint) {
  Resumption from;
  const auto found = checkpoint.state.find(rows_name);
  if (found == checkpoint.state.end() || found->second.size() % numbers_of_row != 0)
    throw std::invalid_argument("it holds no rows of a march");
  for (std::size_t k = 0; k < found->second.size(); k += numbers_of_row)
    from.samples.push_back(row_from(&found->second[k]));
  checkpoint.state.erase(found);
  checkpoint.notes = base::json_text(results::json_or_discarded(checkpoint.notes).at("march"));
  from.checkpoint = std::move(checkpoint);
  return from;
}

void make_folder_for_march(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw base::WorldError("create the folder", folder, error.message());
}

/// A march under way and what of it is kept.
class Keeper {
 public:
  Keeper(const Observer& beside, const MarchOptions& options, const MarchKeeping& keeping,
         const Resumption* from)
      : beside_(beside), options_(options), keeping_(keeping) {
    if (from) rows_ = from->samples;
  }

  Observer observer() {
    Observer o = beside_;
    o.sample = [this](const Sample& row) {
      rows_.push_back(row);
      went_on_ = true;
      if (beside_.sample) beside_.sample(row);
    };
    o.ended = [this](int scenario, const RunResult& so_far) {
      const bool stopped = so_far.lane[scenario].outcome == Outcome::stopped;
      if (!keeping_.result_too && !stopped)
        std::erase_if(rows_, [&](const Sample& row) { return row.lane == scenario; });
      if (beside_.ended) beside_.ended(scenario, so_far);
    };
    o.checkpoint = [this](const auto& make, CheckpointMoment moment) { offer(make, moment); };
    return o;
  }

 private:
  void offer(const std::function<results::Checkpoint()>& make, CheckpointMoment moment) {
    switch (moment) {
      case CheckpointMoment::on_the_way:
        if (base::seconds_since(kept_) > options_.checkpoint_s) keep(make());
        return;
      case CheckpointMoment::before_stop:
        return keep(make());
      case CheckpointMoment::at_end:
        if (keeping_.result_too && went_on_) keep(make());
    }
  }

  void keep(results::Checkpoint checkpoint) {
    set_taken_s(checkpoint, keeping_.taken_before_s + base::seconds_since(began_));
    make_folder_for_march(keeping_.folder);
    results::write_checkpoint(keeping_.folder, wrapped(std::move(checkpoint), keeping_.identity, rows_));
    kept_ = base::Clock::now();
  }

  const Observer& beside_;
  const MarchOptions& options_;
  const MarchKeeping& keeping_;
  std::vector<Sample> rows_;
  bool went_on_ = false;  // in this call
  base::Clock::time_point began_ = base::Clock::now(), kept_ = began_;
};

}  // namespace

std::optional<Resumption> kept_march(const MarchKeeping& keeping, std::string& note) try {
  std::optional<results::Checkpoint> checkpoint = results::read_checkpoint(keeping.folder, 0, note);
  if (!checkpoint || results::json_or_discarded(checkpoint->notes).value("identity", "") != keeping.identity)
    return std::nullopt;
  return unwrapped(std::move(*checkpoint));
} catch (const std::exception& error) {  // sealed, but not by this program
  note += fmt::format("{}{}: {}", note.empty() ? "" : "; ", keeping.folder.string(), error.what());
  return std::nullopt;
}

RunResult march_and_keep(const Prepared& prepared, const Observer& observer, const MarchOptions& options,
                         const MarchKeeping& keeping, const Resumption* from, std::string& note) {
  if (from) try {
      Keeper keeper(observer, options, keeping, from);
      return march(prepared, keeper.observer(), options, from);
    } catch (const std::invalid_argument& error) {  // before its first step
      note += fmt::format("{}{}: {}", note.empty() ? "" : "; ", keeping.folder.string(), error.what());
    }
  Keeper keeper(observer, options, keeping, nullptr);
  return march(prepared, keeper.observer(), options);
}

std::string kept_identity(const fs::path& folder) try {
  std::string ignored;
  const auto checkpoint = results::read_checkpoint(folder, 0, ignored);
  return checkpoint ? results::json_or_discarded(checkpoint->notes).value("identity", "") : std::string();
} catch (const std::exception&) {
  return {};
}

void forget_march(const fs::path& folder) {
  results::remove_checkpoints(folder);
  std::error_code ignored;  // a folder that holds anything else stays
  fs::remove(folder, ignored);
}

}  // namespace rift::simulation
