#include "engine/simulation/kept_march.hpp"

#include "engine/base/text.hpp"
#include "engine/base/world_error.hpp"
#include "engine/results/json_input.hpp"
#include "engine/results/series.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <system_error>
#include <vector>

namespace rift::simulation {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const scene::Change& c) {
  return {{"lane", c.lane}, {"step", c.step}, {"axis", c.axis}, {"value", c.value}};
}

Json json_of(const LaneResult& r) {
  Json changes = Json::array();
  for (const scene::Change& c : r.changes) changes.push_back(json_of(c));
  return {{"outcome", static_cast<int>(r.outcome)},
          {"steps", r.steps},
          {"where", r.where},
          {"worst_residual", r.worst_residual},  // null where it is no number
          {"prestress_kinetic", r.prestress_kinetic},
          {"energy_at_crack_start", r.energy_at_crack_start},
          {"wall_s", r.wall_s},
          {"arrested_m", r.arrested_m},  // null where it is no number
          {"changes", changes},
          {"wake",
           {{"cell_m", r.wake.cell_m},
            {"kinetic_j", r.wake.kinetic_j},
            {"rotation_j", r.wake.rotation_j},
            {"out_of_plane_m", r.wake.out_of_plane_m}}}};
}

LaneResult lane_of(const Json& j) {
  LaneResult r;
  const int outcome = j.at("outcome");
  if (outcome < 0 || outcome > static_cast<int>(Outcome::diverged))
    throw std::invalid_argument("its notes tell of an outcome that there is not");
  r.outcome = static_cast<Outcome>(outcome);
  r.steps = j.at("steps");
  r.where = j.at("where");
  const Json& worst = j.at("worst_residual");
  r.worst_residual = worst.is_null() ? std::numeric_limits<double>::quiet_NaN() : worst.get<double>();
  r.prestress_kinetic = j.at("prestress_kinetic");
  r.energy_at_crack_start = j.at("energy_at_crack_start");
  r.wall_s = j.at("wall_s");
  if (const Json& arrested = j.at("arrested_m"); !arrested.is_null()) r.arrested_m = arrested;
  for (const Json& c : j.at("changes"))
    r.changes.push_back({c.at("lane"), c.at("step"), c.at("axis"), c.at("value")});
  const Json& wake = j.at("wake");
  r.wake = {wake.at("cell_m"), wake.at("kinetic_j"), wake.at("rotation_j"), wake.at("out_of_plane_m")};
  return r;
}

Json json_of(const Rest& r) {
  return {{"since", r.since}, {"driving", r.driving}, {"reference", r.reference},
          {"sum", r.sum},     {"looks", r.looks},     {"restarted_m", r.restarted_m}};
}

Rest rest_of(const Json& j) {
  return {.since = j.at("since"),
          .driving = j.at("driving"),
          .reference = j.at("reference"),
          .sum = j.at("sum"),
          .looks = j.at("looks"),
          .restarted_m = j.at("restarted_m")};
}

}  // namespace

std::string to_json(const MarchNotes& n) {
  Json slots = Json::array(), lanes = Json::array();
  for (const LaneSlot& s : n.slots)
    slots.push_back({{"scenario", s.scenario},
                     {"next_sample", s.next_sample},
                     {"next_frame", s.next_frame},
                     {"framed_at", s.framed_at},
                     {"rest", json_of(s.rest)},
                     {"since_s", s.since_s}});
  for (const LaneResult& r : n.lane) lanes.push_back(json_of(r));
  return base::json_text(Json{{"lanes", n.lanes},
                              {"instructions", n.instructions},
                              {"dt", n.dt},
                              {"marched", n.marched},
                              {"lane_steps", n.lane_steps},
                              {"next_scenario", n.next_scenario},
                              {"cracking", n.cracking},
                              {"wall_prestress_s", n.wall_prestress_s},
                              {"wall_fracture_s", n.wall_fracture_s},
                              {"seats", slots},
                              {"lane", lanes}});
}

MarchNotes march_notes(const std::string& text) try {
  const Json j = results::json_or_discarded(text);
  MarchNotes n;
  n.lanes = j.at("lanes");
  n.instructions = j.at("instructions");
  n.dt = j.at("dt");
  n.marched = j.at("marched");
  n.lane_steps = j.at("lane_steps");
  n.next_scenario = j.at("next_scenario");
  n.cracking = j.value("cracking", true);
  n.wall_prestress_s = j.at("wall_prestress_s");
  n.wall_fracture_s = j.at("wall_fracture_s");
  for (const Json& s : j.at("seats"))
    n.slots.push_back({s.at("scenario"), s.at("next_sample"), s.at("next_frame"), s.at("framed_at"),
                       s.contains("rest") ? rest_of(s.at("rest")) : Rest{}, s.value("since_s", 0.0)});
  for (const Json& r : j.at("lane")) n.lane.push_back(lane_of(r));
  return n;
} catch (const Json::exception& error) {
  throw std::invalid_argument(std::string("its notes are not of a checkpoint: ") + error.what());
}

void set_taken_s(results::Checkpoint& checkpoint, double seconds) {
  Json notes = results::json_or_discarded(checkpoint.notes);
  notes["taken_s"] = seconds;
  checkpoint.notes = base::json_text(notes);
}

double taken_s(const results::Checkpoint& checkpoint) {
  const Json notes = results::json_or_discarded(checkpoint.notes);
  return notes.is_object() && notes.contains("taken_s") && notes["taken_s"].is_number()
             ? notes["taken_s"].get<double>()
             : 0.0;
}

namespace {

namespace fs = std::filesystem;
using results::Sample;
using KeepingClock = std::chrono::steady_clock;

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
      throw std::invalid_argument("a row of it has a step, a phase or a lane that there is not");
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
  checkpoint.notes =
      base::json_text(Json{{"identity", identity}, {"march", results::json_or_discarded(checkpoint.notes)}});
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
    from.books.push_back(row_from(&found->second[k]));
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
    if (from) rows_ = from->books;
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
        if (KeepingClock::now() - kept_ > std::chrono::duration<double>(options_.checkpoint_s)) keep(make());
        return;
      case CheckpointMoment::before_stop:
        return keep(make());
      case CheckpointMoment::at_end:
        if (keeping_.result_too && went_on_) keep(make());
    }
  }

  void keep(results::Checkpoint checkpoint) {
    set_taken_s(checkpoint, keeping_.taken_before_s +
                                std::chrono::duration<double>(KeepingClock::now() - began_).count());
    make_folder_for_march(keeping_.folder);
    results::write_checkpoint(keeping_.folder, wrapped(std::move(checkpoint), keeping_.identity, rows_));
    kept_ = KeepingClock::now();
  }

  const Observer& beside_;
  const MarchOptions& options_;
  const MarchKeeping& keeping_;
  std::vector<Sample> rows_;
  bool went_on_ = false;  // in this call
  KeepingClock::time_point began_ = KeepingClock::now(), kept_ = began_;
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
