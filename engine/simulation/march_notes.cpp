#include "engine/simulation/march_notes.hpp"

#include "engine/base/json_text.hpp"
#include "engine/results/json_input.hpp"

#include <nlohmann/json.hpp>

#include <limits>
#include <stdexcept>

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
  Json seats = Json::array(), lanes = Json::array();
  for (const MarchNotes::Seat& s : n.seats)
    seats.push_back({{"scenario", s.scenario},
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
                              {"seats", seats},
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
    n.seats.push_back({s.at("scenario"), s.at("next_sample"), s.at("next_frame"), s.at("framed_at"),
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

}  // namespace rift::simulation
