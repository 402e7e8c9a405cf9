#include "studio/screen/live_of_run.hpp"

#include "engine/fracture/release_rate.hpp"
#include "engine/results/archive.hpp"
#include "engine/results/lane_summary.hpp"
#include "engine/results/records.hpp"
#include "engine/scene/derived.hpp"
#include "engine/scene/preset.hpp"
#include "engine/simulation/march.hpp"
#include "engine/theory/references.hpp"

#include <algorithm>

namespace rift::studio {
namespace {

using Header = nlohmann::ordered_json;

fracture::RateScale scale_of(const Header& header, int lane) {
  fracture::RateScale scale{.thickness = header.value("thickness_m", 0.0),
                            .g_i0 = header.value("g_i0_j_m2", 0.0),
                            .length = header.value("length_m", 0.0),
                            .tips = header.value("tips", 1)};
  const Header scales = header.value("rate_scales", Header::array());  // not in runs of before 0.2
  if (lane >= static_cast<int>(scales.size())) return scale;
  scale.g_i0 = scales[lane].value("g_i0_j_m2", 0.0);
  scale.g_i0_slope = scales[lane].value("g_i0_slope_j_m3", 0.0);
  return scale;
}

/// Broberg's factor at the lane's velocity, Freund's and the strip's.
void add_references(LiveLane& lane, double v, const scene::Scene& scene) {
  if (!(v > 0 && v <= 1)) return;
  lane.broberg = theory::broberg(v, scene.material.poisson_ratio, scene.material.plane).g;
  lane.freund = theory::freund(v, scene.material.poisson_ratio, scene.material.plane).g;
  lane.strip = theory::strip(v, scene.material.poisson_ratio, scene.material.plane).g;
}

}  // namespace

Live live_of_header(const Header& header, const std::filesystem::path& run) {
  Live live;
  live.name = run.filename().empty() ? run.parent_path().filename().string() : run.filename().string();
  live.length = header.value("length_m", 0.0);
  live.height = header.value("height_m", 0.0);
  live.pulled = header.value("displacement_m", 0.0);
  // What a strip that is let go shows: a part of strain times wave speed.
  if (live.height > 0)
    live.fastest = 0.5 * live.pulled / live.height * header.value("rayleigh_speed_m_s", 0.0);
  live.steps = header.value("steps", std::int64_t{0});
  const auto scenarios = results::lane_summaries_of(header.value("scenarios", Header::array()));
  const std::vector<std::string> titles = results::lane_titles(scenarios);
  const scene::Preset preset =
      scene::read_preset_text(header.value("preset", std::string{}), "the run's preset");
  const scene::Scene& scene = preset.scene;
  live.ledger_limit = simulation::ledger_limit(scene.solver.kinematics, scene.solver.precision);
  for (std::size_t k = 0; k < titles.size(); ++k) {
    LiveLane& lane = live.lanes.emplace_back();
    lane.title = titles[k];
    lane.scale = scale_of(header, static_cast<int>(k));
    const auto window = scene::window_over_length(k < preset.lanes.size() ? preset.lanes[k] : scene);
    lane.window = {window[0] * live.length, window[1] * live.length};
    add_references(lane, scenarios[k].crack_velocity_over_cr, scene);
  }
  return live;
}

void take_results(Live& live, const Header& summary) {
  const auto lanes = results::lane_summaries_of(summary.value("scenarios", Header::array()));
  for (std::size_t k = 0; k < std::min(lanes.size(), live.lanes.size()); ++k)
    live.lanes[k].ended = LiveLane::Ratio{lanes[k].ratio, lanes[k].ratio_scatter};
}

LiveOfRun::LiveOfRun(const std::filesystem::path& run)
    : journal_(run / results::journal_name),
      header_(Header::parse(journal_.header_json())),
      live_(live_of_header(header_, run)) {
  live_.geometry = &journal_.geometry();
  live_.lanes.resize(journal_.lanes());
  for (int k = 0; k < journal_.lanes(); ++k) read_lane(k);
  read_progress();
}

bool LiveOfRun::look() {
  const auto size = [&] {
    std::size_t rows = journal_.summary_json() ? 1 : 0;
    for (int k = 0; k < journal_.lanes(); ++k) rows += journal_.samples(k).size() + journal_.frames(k).size();
    return rows;
  };
  const std::size_t before = size();
  journal_.extend();
  if (size() == before) return false;
  for (int k = 0; k < journal_.lanes(); ++k) read_lane(k);
  read_progress();
  return true;
}

void LiveOfRun::read_lane(int k) {
  LiveLane& lane = live_.lanes[k];
  lane.samples.clear();
  for (const results::Sample& s : journal_.samples(k))
    if (s.phase == results::Phase::fracture) lane.samples.push_back(s);
  if (lane.samples.size() > 2) lane.rates = fracture::rate_curve(lane.samples, lane.scale);
  if (journal_.frames(k).empty()) return;
  const results::FrameEntry& last = journal_.frames(k).back();
  results::Frame frame = journal_.frame(last);
  lane.displacement = std::move(frame.displacement);
  lane.velocity = std::move(frame.velocity);
  if (header_.contains("path")) lane.tips = results::tips_at(header_, last.tip_m);
}

void LiveOfRun::read_progress() {
  std::int64_t step = 0;
  for (int k = 0; k < journal_.lanes(); ++k)
    if (!journal_.samples(k).empty()) step = std::max(step, journal_.samples(k).back().step);
  const auto now = Clock::now();
  const double seconds = std::chrono::duration<double>(now - looked_).count();
  if (live_.step > 0 && step > live_.step && seconds > 0) {
    const double speed = static_cast<double>(step - live_.step) / seconds;
    live_.steps_per_s = live_.steps_per_s > 0 ? 0.8 * live_.steps_per_s + 0.2 * speed : speed;
  }
  looked_ = now;
  live_.step = step;
  live_.done = live_.steps > 0 ? static_cast<double>(step) / static_cast<double>(live_.steps) : 0;
  live_.state = state();
  if (const auto& text = journal_.summary_json()) {
    const Header summary = Header::parse(*text, nullptr, false);
    if (summary.is_object()) take_results(live_, summary);
  }
  const bool going = live_.state == "running" && live_.steps_per_s > 0;
  if (!going) live_.steps_per_s = 0;
  live_.seconds_left = going ? static_cast<double>(live_.steps - step) / live_.steps_per_s : -1;
}

std::string LiveOfRun::state() const {
  if (journal_.state() == results::JournalState::damaged) return "damaged: " + journal_.reason();
  if (!journal_.summary_json()) return "running";
  std::string worst = "finished";
  const Header summary = Header::parse(*journal_.summary_json(), nullptr, false);
  if (!summary.is_object() || !summary.contains("scenarios")) return worst;
  for (const results::LaneSummary& lane : results::lane_summaries_of(summary["scenarios"]))
    if (!lane.outcome.empty() && lane.outcome != "finished") worst = lane.outcome;
  return worst;
}

}  // namespace rift::studio
