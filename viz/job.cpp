#include "viz/job.hpp"

#include "engine/base/text.hpp"
#include "engine/results/json_input.hpp"

#include <nlohmann/json.hpp>

#include <stdexcept>

namespace rift::viz {

NLOHMANN_JSON_SERIALIZE_ENUM(
    Camera, {{Camera::plate, "plate"}, {Camera::tip, "tip"}, {Camera::side, "side"}, {Camera::free, "free"}})
NLOHMANN_JSON_SERIALIZE_ENUM(Beams,
                             {{Beams::none, "none"}, {Beams::crossing, "crossing"}, {Beams::all, "all"}})
NLOHMANN_JSON_SERIALIZE_ENUM(Chart,
                             {{Chart::none, "none"}, {Chart::growing, "growing"}, {Chart::whole, "whole"}})

// The run's path byte by byte, as numbers: JSON text holds UTF-8 alone, and a path anything.
static void to_json(nlohmann::json& json, const Pane& pane) {
  const std::string& path = pane.run.native();
  json = {{"run", std::vector<unsigned char>(path.begin(), path.end())},
          {"lane", pane.lane},
          {"title", pane.title}};
}

static void from_json(const nlohmann::json& json, Pane& pane) {
  const auto path = json.at("run").get<std::vector<unsigned char>>();
  pane = {std::string(path.begin(), path.end()), json.at("lane"), json.at("title")};
}

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(View, x, y, height, turn, tilt)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Look, field, range, range_of_moment, colours, camera, view, beams, spheres,
                                   magnification, close_up_m, chart, boundaries, texts, large_text, title,
                                   scheme)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Job, panes, look, width, height)

namespace {

/// An enum of JSON takes its first value for what it does not know: here that is an error.
template <typename Enum>
Enum named(const std::string& word) {
  const auto value = nlohmann::json(word).get<Enum>();
  if (nlohmann::json(value) != word) throw std::invalid_argument("unknown word '" + word + "'");
  return value;
}

}  // namespace

Camera camera_named(const std::string& word) { return named<Camera>(word); }
Beams beams_named(const std::string& word) { return named<Beams>(word); }
Chart chart_named(const std::string& word) { return named<Chart>(word); }
std::string word_of(Camera camera) { return nlohmann::json(camera).get<std::string>(); }
std::string word_of(Beams beams) { return nlohmann::json(beams).get<std::string>(); }
std::string word_of(Chart chart) { return nlohmann::json(chart).get<std::string>(); }

std::string to_json(const Job& job) { return base::json_text(nlohmann::json(job)); }

Job job_from_json(std::string_view text) {
  try {
    return results::json_or_discarded<nlohmann::json>(text).get<Job>();
  } catch (const nlohmann::json::exception& error) {
    throw std::invalid_argument(error.what());
  }
}

}  // namespace rift::viz
