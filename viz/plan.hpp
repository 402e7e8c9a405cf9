#pragma once

#include "engine/results/journal_index.hpp"
#include "viz/field.hpp"
#include "viz/job.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

/// From what the user asks for to what the renderer is told.
namespace rift::viz {

/// The user asked for something that cannot be: names what there is instead. Exit code 2.
struct BadRequest : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What is asked for. What is not given is as the run's preset has it ([film]).
struct Request {
  std::vector<std::filesystem::path> runs;
  std::vector<int> lanes;  // none: all, up to four panes
  std::optional<std::string> title, field, colours, camera, beams, chart;
  std::optional<double> magnification, close_up_m;
  std::optional<std::array<double, 2>> range;  // in the unit that is shown
  bool range_of_moment = false;
  std::optional<View> view;  // of the free camera, which it chooses
  std::optional<bool> boundaries;
  bool large_text = false, texts = true;
  int width = 1280, height = 720;
};

/// A lane of a run, open for reading.
struct Shown {
  std::filesystem::path run;
  std::int32_t lane = 0;
  std::shared_ptr<results::JournalIndex> journal;
  nlohmann::ordered_json header;

  [[nodiscard]] const std::vector<results::FrameEntry>& frames() const { return journal->frames(lane); }
};

/// What will be drawn.
struct Plan {
  Job job;
  std::vector<double> times_s;     // of every moment since the crack's start, ascending
  std::vector<double> tips_m;      // of the pane that gives the clock, at these times
  std::vector<std::string> notes;  // for the user
  bool range_known = true;         // or read off the frames that there are
};

/// Opens the lanes that are asked for. Throws BadRequest, or WorldError where a run cannot be read.
/// @param[out] notes  for the user
[[nodiscard]] std::vector<Shown> open_lanes(const Request& request, std::vector<std::string>& notes);

/// Reads what the picture of opened lanes needs to be planned. The clock is that of the pane that lasts
/// longest. Throws BadRequest.
[[nodiscard]] Plan plan_of(const Request& request, const std::vector<Shown>& shown);

/// Both together.
[[nodiscard]] Plan plan_of(const Request& request);

/// The clock of these lanes, read again: of runs that go on.
void choose_clock(Plan& plan, const std::vector<Shown>& shown);

/// `count` of the moments, evenly chosen, first and last among them. Throws BadRequest where there are not so
/// many: a frame is a stored moment, never something between two.
[[nodiscard]] std::vector<double> evenly_chosen(const std::vector<double>& times_s, int count);

}  // namespace rift::viz
