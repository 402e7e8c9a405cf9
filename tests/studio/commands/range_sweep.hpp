#pragma once

#include "engine/scene/parameters.hpp"
#include "engine/scene/toml_text.hpp"
#include "tests/engine/scene/range_ends.hpp"
#include "tests/studio/run_rift.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

namespace rift::studio {

/// A key and a value that --set takes.
struct Given {
  std::string key, value;
};

namespace sweep {

namespace fs = std::filesystem;
using Json = nlohmann::json;

inline std::string table(const std::string& key) { return key.substr(0, key.find('.')); }

/// What a key needs beside it to count at all; and what it excludes, of the plate's own keys.
inline std::vector<Given> companions(const std::string& key) {
  if (key.starts_with("material.micro_"))
    return {{"material.stiffness", "explicit"},
            {"material.micro_young_modulus", "100 GPa"},
            {"material.micro_poisson_ratio", "0.3"},
            {"material.micro_radius_ratio", "0.3"}};
  if (key == "damping.alpha") return {{"damping.region", "all"}};
  if (key == "damping.surface_width") return {{"damping.region", "surface"}, {"damping.alpha", "0.01"}};
  if (key.starts_with("loading.ramp_") || key == "loading.hold_steps")
    return {{"loading.method", "ramp"}, {"loading.ramp_steps", "2000"}, {"loading.hold_steps", "200"}};
  if (key == "output.gauge_length") return {{"output.gauges", "[[36e-3, 9e-3]]"}};
  if (key == "crack.toughness_window") return {{"crack.toughness", R"([["0 c_r", 1e4], ["0.9 c_r", 1e4]])"}};
  if (key == "crack.history_gap") return {{"crack.history", "[[0, 1e-3], [10e-6, 12e-3], [20e-6, 24e-3]]"}};
  if (key.starts_with("calibration."))
    return {{"material.stiffness", "calibrated"},
            {"calibration.sizes", "[100]"},
            {"calibration.packings", "1"},
            {"calibration.elements", "300"},
            {"calibration.radius_ratios", "[0.2, 0.9]"}};
  return {};
}

/// 48 x 12 mm, without what the given keys exclude.
inline std::string plate(const std::vector<Given>& given) {
  std::vector<Given> keys{{"specimen.length", "\"48 mm\""}, {"specimen.height", "\"12 mm\""},
                          {"specimen.layers", "2"},         {"specimen.elements", "700"},
                          {"specimen.coordination", "5.7"}, {"loading.displacement", "\"0.6 mm\""},
                          {"output.samples", "50"},         {"output.frames", "4"}};
  const auto drop = [&](const std::string& name) {
    std::erase_if(keys, [&](const Given& g) { return g.key == name; });
  };
  for (const Given& g : given) {
    if (g.key == "specimen.thickness") drop("specimen.layers");
    if (g.key == "specimen.solid_fraction") drop("specimen.coordination");
    if (g.key == "loading.force" || g.key == "loading.curve") drop("loading.displacement");
  }
  std::string text;
  for (const char* name : {"specimen", "loading", "crack", "output"}) {
    text += fmt::format("[{}]\n", name);
    for (const Given& g : keys)
      if (table(g.key) == name) text += g.key.substr(g.key.find('.') + 1) + " = " + g.value + "\n";
  }
  return text;
}

/// Words of libraries, not of the program.
inline std::string raw_text(const std::string& text) {
  for (const char* raw : {"json.exception", "type_error", "std::", "vector::", "basic_string", "bad_alloc",
                          "terminate called", "Assertion", "Eigen", "HDF5", "stod", "stoi"})
    if (text.find(raw) != std::string::npos) return raw;
  return {};
}

/// Whether a message names the key; or, of a specimen, whose keys only together say whether it can be packed,
/// one of its other keys.
inline bool names(const std::string& message, const std::string& key) {
  const bool packed = key.starts_with("specimen.");
  return message.find(packed ? "specimen." : key) != std::string::npos;
}

/// What in a finished run must be a number, and is not.
inline std::string not_a_number(const fs::path& folder) {
  const Json summary = Json::parse(read_text(folder / "summary.json"), nullptr, false);
  if (!summary.is_object()) return "summary.json cannot be read";
  const Json& scenario = summary.at("scenarios").at(0);
  for (const char* name : {"mean_radius_m",
                           "thickness_m",
                           "density_kg_m3",
                           "rayleigh_speed_m_s",
                           "micro_young_modulus_pa",
                           "strip_modulus_pa",
                           "solid_fraction",
                           "dt_s",
                           "dt_critical_s",
                           "dt_fraction",
                           "steps",
                           "g_i0_j_m2",
                           "displacement_m",
                           "grip_force_n",
                           "energy_initial_j",
                           "energy_elastic_j",
                           "energy_fracture_j",
                           "energy_kinetic_translation_j",
                           "energy_kinetic_rotation_j",
                           "work_external_j",
                           "ledger_residual"})
    if (!scenario.at(name).is_number()) return std::string("summary.json: ") + name + " is no number";
  if (scenario.at("steps").get<double>() < 0.0) return "a negative number of steps";
  const std::string series = read_text(folder / "series.csv");
  for (const char* word : {"nan", "inf"})
    if (series.find(word) != std::string::npos) return std::string("series.csv holds ") + word;
  return {};
}

inline std::string shown(const std::vector<Given>& given) {
  std::string text;
  for (const Given& g : given) text += (text.empty() ? "" : " and ") + g.key + "=" + g.value;
  return text;
}

}  // namespace sweep

/// A few values far from each other that the key itself takes; for pairs.
std::vector<std::string> far_values(const scene::Parameter& row);

/// How often `check` and `run` came to what.
struct Tally {
  int runs = 0, finished = 0, refused = 0, diverged = 0, stopped = 0;
};

/// Drives `rift check` and `rift run` on a plate of 700 elements with these keys and looks at what comes of
/// it. Allowed: done, with numbers that are numbers; refused by a message that names one of the keys;
/// diverged, with the step and the reason; or, of what would take long, stopped within seconds of SIGTERM.
/// Both commands must agree on what they refuse.
class RangeSweep {
 public:
  /// @param limit_s  after which a run is stopped
  explicit RangeSweep(int limit_s) : limit_s_(limit_s) {}
  /// @return what is wrong, or empty
  std::string complaint(const std::vector<Given>& given);
  Tally tally;

 private:
  Ran rift(const std::string& command, const std::filesystem::path& preset, const std::vector<Given>& given);
  TemporaryFolder folder_;
  int limit_s_;
};

inline std::vector<std::string> far_values(const scene::Parameter& row) {
  constexpr std::size_t most = 4;
  constexpr double apart = 10.0;
  std::vector<std::string> values;
  std::vector<double> numbers;
  for (const std::string& value : scene::ends_of(row)) {
    scene::Scene scene = scene::default_scene();
    double number = std::strtod(value.c_str(), nullptr);
    const bool near = std::any_of(numbers.begin(), numbers.end(), [&](double other) {
      return number == other || (number / other < apart && number / other > 1.0 / apart);
    });
    if (near || value.front() == '[' || values.size() == most) continue;
    if (!scene::assign(scene, row, scene::value_from_text(value)).empty()) continue;
    values.push_back(value), numbers.push_back(number);
  }
  return values;
}

inline Ran RangeSweep::rift(const std::string& command, const sweep::fs::path& preset,
                            const std::vector<Given>& given) {
  std::string words =
      fmt::format("env XDG_CACHE_HOME='{}' timeout --preserve-status -s TERM -k 30 {} '" RIFT_EXE
                  "' {} '{}' --threads 1 --quiet",
                  (folder_.path() / "cache").string(), limit_s_, command, preset.string());
  if (command == "run") words += " --out '" + (folder_.path() / "out").string() + "'";
  for (const Given& g : given) words += fmt::format(" --set '{}={}'", g.key, g.value);
  ++tally.runs;
  return run_shell(words);
}

inline std::string RangeSweep::complaint(const std::vector<Given>& given) {
  constexpr int stopped = 128 + 15, killed = 128 + 9;
  std::vector<Given> all;
  for (const Given& g : given)
    for (const Given& companion : sweep::companions(g.key))
      if (std::none_of(given.begin(), given.end(), [&](const Given& o) { return o.key == companion.key; }))
        all.push_back(companion);
  all.insert(all.end(), given.begin(), given.end());
  const sweep::fs::path preset = folder_.path() / "plate.toml", out = folder_.path() / "out";
  write_text(preset, sweep::plate(all));
  sweep::fs::remove_all(out);
  int refused = 0, undecided = 0;
  for (const char* command : {"check", "run"}) {
    const Ran ran = rift(command, preset, all);
    const auto say = [&](const std::string& what) {
      return fmt::format("{} {}: {} (exit {})\n{}", command, sweep::shown(given), what, ran.exit_code,
                         ran.err);
    };
    if (ran.exit_code == killed) return say("did not hear SIGTERM");
    if (const std::string raw = sweep::raw_text(ran.err); !raw.empty()) return say("raw text '" + raw + "'");
    switch (ran.exit_code) {
      case 0:
        ++tally.finished;
        if (command != std::string("run")) break;
        if (const std::string wrong = sweep::not_a_number(out); !wrong.empty()) return say(wrong);
        break;
      case 2:
        ++tally.refused, ++refused;
        if (std::none_of(given.begin(), given.end(),
                         [&](const Given& g) { return sweep::names(ran.err, g.key); }))
          return say("names none of the keys");
        break;
      case 3:
        ++tally.diverged;
        if (sweep::Json::parse(read_text(out / "summary.json"))
                .at("scenarios")[0]
                .at("outcome_where")
                .is_null())
          return say("does not say where it diverged");
        break;
      case stopped:
        ++tally.stopped, ++undecided;
        break;
      default:
        return say("none of the outcomes allowed");
    }
  }
  if (refused == 1 && undecided == 0) return sweep::shown(given) + ": refused by one of check and run only";
  return {};
}

}  // namespace rift::studio
