#include "engine/scene/steering.hpp"

#include "engine/scene/issue.hpp"
#include "engine/scene/preset.hpp"
#include "engine/scene/scenarios.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

namespace rift::scene {
namespace {

constexpr std::array<std::string_view, 5> steerable{"technique", "relaxation", "damage_zone_ratio",
                                                    "damping_alpha", "crack_velocity"};

bool is_steerable(std::string_view axis) {
  return std::find(steerable.begin(), steerable.end(), axis) != steerable.end();
}

std::string names_of_steerable() {
  return listed(std::vector<std::string>(steerable.begin(), steerable.end()), "and");
}

/// One velocity that holds to the end takes over at the tip.
std::string turn_to(std::vector<VelocityPiece>& before, const std::vector<VelocityPiece>& wished,
                    double tip) {
  if (wished.size() != 1) return "expected one velocity";
  std::vector<VelocityPiece> pieces;
  for (const VelocityPiece& piece : before) {
    pieces.push_back(piece);
    if (piece.until && *piece.until < tip) continue;
    pieces.back().until = tip;
    break;
  }
  pieces.push_back(wished.front());
  before = std::move(pieces);
  return {};
}

struct SteeringReader {
  Preset& preset;
  std::vector<Issue> issues;
  int lanes;

  void say(const TomlEntry& entry, std::string text) {
    issues.push_back(
        {preset.name, entry.line, "steering." + entry.name, std::move(text), shown(entry.value)});
  }
};

/// A whole number of a [[steering]] table, or nothing where it is not there or wrong.
std::optional<std::int64_t> whole(SteeringReader& reading, const TomlRow& row, std::string_view name,
                                  std::int64_t lowest, std::int64_t highest) {
  for (const TomlEntry& entry : row.entries) {
    if (entry.name != name) continue;
    const auto* number = std::get_if<std::int64_t>(&entry.value.held);
    if (number && *number >= lowest && *number <= highest) return *number;
    reading.say(entry, fmt::format("must be a whole number in [{}, {}]", lowest, highest));
    return std::nullopt;
  }
  if (name == "step")
    reading.issues.push_back({reading.preset.name, row.line, "steering.step", "is missing", ""});
  return std::nullopt;
}

std::string text_of(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value.held)) return *text;
  if (const auto* number = std::get_if<double>(&value.held)) return fmt::format("{}", *number);
  return shown(value);
}

void take_row(SteeringReader& reading, const TomlRow& row) {
  const std::size_t issues = reading.issues.size();
  const auto lane = whole(reading, row, "lane", 0, reading.lanes - 1).value_or(0);
  const auto step = whole(reading, row, "step", 0, std::int64_t{1} << 40);
  std::vector<Change> changes;
  for (const TomlEntry& entry : row.entries) {
    if (entry.name == "lane" || entry.name == "step") continue;
    if (!is_steerable(entry.name)) {
      reading.say(entry, fmt::format("cannot be steered: the steerable keys are {}", names_of_steerable()));
      continue;
    }
    Change change{static_cast<int>(lane), step.value_or(0), entry.name, text_of(entry.value)};
    Scene scene = default_scene();
    scene.crack.technique = fracture::Technique::progressive;
    if (std::string wrong = steer(scene, change, 0.0); !wrong.empty()) reading.say(entry, std::move(wrong));
    changes.push_back(std::move(change));
  }
  if (changes.empty() && reading.issues.size() == issues)
    reading.issues.push_back({reading.preset.name, row.line, "steering",
                              fmt::format("changes nothing: name one of {}", names_of_steerable()), ""});
  auto& all = reading.preset.steering;
  all.insert(all.end(), changes.begin(), changes.end());
}

bool is_text(const Change& change) {
  const bool number =
      !change.value.empty() && change.value.find_first_not_of("0123456789.+-eE") == std::string::npos;
  return !number;
}

}  // namespace

std::span<const std::string_view> steerable_axes() { return steerable; }

std::string steer(Scene& scene, const Change& change, double tip) {
  const Axis* axis = find_axis(change.axis);
  if (axis == nullptr || !is_steerable(change.axis))
    return fmt::format("cannot be steered: the steerable keys are {}", names_of_steerable());
  if (!applies(scene, *axis)) return "does not apply to simple release: change the technique first";
  Scene wished = scene;
  if (std::string wrong = assign(wished, parameter_of(*axis), value_from_text(change.value)); !wrong.empty())
    return wrong;
  if (change.axis == "crack_velocity") {
    if (!scene.crack.history.empty()) return "follows a measured history: its velocity is not steered";
    std::vector<VelocityPiece> pieces = scene.crack.velocity;
    if (std::string wrong = turn_to(pieces, wished.crack.velocity, tip); !wrong.empty()) return wrong;
    wished.crack.velocity = std::move(pieces);
  }
  if (change.axis == "damping_alpha" && wished.damping.alpha > 0 &&
      wished.damping.region == DampingRegion::none)
    wished.damping.region = DampingRegion::surface;
  scene = std::move(wished);
  return {};
}

std::vector<Issue> take_steering(Preset& preset, const TomlDocument& document) {
  SteeringReader reading{preset, {}, std::max(1, static_cast<int>(preset.lanes.size()))};
  for (const TomlTable& table : document.tables)
    if (table.name == "steering")
      reading.issues.push_back(
          {preset.name, table.line, "", "changes are a list of tables: write [[steering]]"});
  for (const TomlRow& row : document.rows) {
    if (row.list != "steering") continue;
    if (!preset.study.empty()) {
      reading.issues.push_back(
          {preset.name, row.line, "steering", "a study is not steered: steer a run", ""});
      return std::move(reading.issues);
    }
    take_row(reading, row);
  }
  std::stable_sort(preset.steering.begin(), preset.steering.end(), [](const Change& a, const Change& b) {
    return std::pair{a.lane, a.step} < std::pair{b.lane, b.step};
  });
  return std::move(reading.issues);
}

std::string steering_text(const std::vector<Change>& changes) {
  std::string out;
  for (const Change& c : changes)
    out += fmt::format("\n[[steering]]\nlane = {}\nstep = {}\n{} = {}\n", c.lane, c.step, c.axis,
                       is_text(c) ? fmt::format("\"{}\"", c.value) : c.value);
  return out;
}

}  // namespace rift::scene
