#include "viz/plan.hpp"

#include "engine/results/archive.hpp"
#include "engine/results/lane_summary.hpp"
#include "viz/field.hpp"
#include "viz/order.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>

namespace rift::viz {
namespace {

using Header = nlohmann::ordered_json;
namespace fs = std::filesystem;

std::shared_ptr<results::JournalIndex> open(const fs::path& run, std::vector<std::string>& notes) {
  const fs::path path = run / results::journal_name;
  if (!fs::exists(run)) throw BadRequest(fmt::format("{}: no such run", run.string()));
  if (!fs::exists(path))
    throw BadRequest(fmt::format("{} holds no run: no {}", run.string(), results::journal_name));
  auto journal = std::make_shared<results::JournalIndex>(path);
  if (journal->state() == results::JournalState::damaged)
    notes.push_back(fmt::format("{} is damaged ({}): only the frames before the damage are shown",
                                path.string(), journal->reason()));
  return journal;
}

std::set<std::string> stored_in(const Shown& shown) {
  const results::Frame frame = shown.journal->frame(shown.frames().front());
  std::set<std::string> stored;
  if (!frame.displacement.empty()) stored.insert("displacement");
  if (!frame.velocity.empty()) stored.insert("velocity");
  if (!frame.damage_factor.empty()) stored.insert("damage");
  if (!frame.elastic_energy.empty()) stored.insert("energy");
  if (!frame.rotation.empty()) stored.insert("rotation");
  return stored;
}

void check_stored(const Shown& shown, const Field& field, const Look& look) {
  if (shown.frames().empty())
    throw BadRequest(
        fmt::format("{} holds no frames: run it with --set output.frames=100", shown.run.string()));
  std::set<std::string> stored = stored_in(shown);
  std::string missing;
  if (!stored.contains(std::string(field.stored))) missing = field.stored;
  if (look.beams != Beams::none && !stored.contains("damage")) missing = "damage";
  if (missing.empty()) return;
  std::vector<std::string_view> names;
  for (const Field& other : fields())
    if (stored.contains(std::string(other.stored))) names.push_back(other.name);
  stored.insert(missing);
  throw BadRequest(
      fmt::format("{} holds no {}; its fields are {}. Run it with --set 'output.fields=[\"{}\"]'",
                  shown.run.string(), missing == field.stored ? fmt::format("field {}", field.name) : missing,
                  fmt::join(names, ", "), fmt::join(stored, "\", \"")));
}

const Field& field_named(const std::string& name) {
  if (const Field* field = find_field(name)) return *field;
  std::vector<std::string_view> names;
  for (const Field& field : fields()) names.push_back(field.name);
  throw BadRequest(fmt::format("no field is called '{}': {}", name, fmt::join(names, ", ")));
}

/// The look that the first run's preset asks for, and over it what the user asks for.
Look look_for(const Request& request, const Header& header) {
  const Header film = header.value("film", Header::object());
  Look look;
  look.title = request.title.value_or(film.value("title", std::string{}));
  const std::string own_field = film.value("field", look.field);
  look.field = request.field.value_or(own_field);
  // The preset's colours are those of its own field.
  look.colours = request.colours.value_or(look.field == own_field ? film.value("colours", look.colours) : "");
  look.camera = camera_named(request.camera.value_or(film.value("camera", std::string("plate"))));
  if (request.view) look.camera = Camera::free, look.view = *request.view;
  look.beams = beams_named(request.beams.value_or(film.value("beams", std::string("none"))));
  look.magnification = request.magnification.value_or(film.value("magnification", look.magnification));
  look.close_up_m = request.close_up_m.value_or(film.value("close_up_m", look.close_up_m));
  look.chart = request.chart              ? chart_named(*request.chart)
               : film.value("chart", true) ? Chart::growing
                                           : Chart::none;
  look.boundaries = request.boundaries.value_or(film.value("boundaries", look.boundaries));
  look.large_text = request.large_text;
  look.texts = request.texts;
  look.range_of_moment = request.range_of_moment;
  return look;
}

std::array<double, 2> joined(const std::array<double, 2>& a, const std::array<double, 2>& b) {
  return {std::min(a[0], b[0]), std::max(a[1], b[1])};
}

/// Over moments spread evenly over the frames of all panes.
std::array<double, 2> range_in(const std::vector<Shown>& shown, const Field& field) {
  constexpr std::size_t most_moments = 24;
  std::array<double, 2> range{1e300, -1e300};
  for (const Shown& pane : shown) {
    const auto& frames = pane.frames();
    const std::size_t moments = std::min(most_moments, frames.size());
    std::vector<float> values;
    for (std::size_t k = 0; k < moments; ++k) {
      const std::size_t at = moments == 1 ? 0 : k * (frames.size() - 1) / (moments - 1);
      const auto more =
          values_of(field, pane.journal->frame(frames[at]), pane.journal->geometry(), pane.header);
      values.insert(values.end(), more.begin(), more.end());
    }
    range = joined(range, range_of(field, values));
  }
  if (range[1] > range[0]) return range;
  return {range[0] - field.unit_in_si, range[0] + field.unit_in_si};  // all the same: any range shows it
}

void choose_range(Plan& plan, const Request& request, const std::vector<Shown>& shown, const Field& field) {
  if (request.range_of_moment) return;
  if (request.range) {
    const auto [low, high] = *request.range;
    if (!(low < high)) throw BadRequest(fmt::format("--range {},{}: must rise", low, high));
    plan.job.look.range = {low * field.unit_in_si, high * field.unit_in_si};
    return;
  }
  std::array<double, 2> range{1e300, -1e300};
  for (const Shown& pane : shown)
    if (const auto known = known_range(field, pane.header)) {
      range = joined(range, *known);
    } else {
      plan.range_known = false;
    }
  plan.job.look.range = plan.range_known ? range : range_in(shown, field);
}

std::vector<results::LaneSummary> scenarios_of(const std::vector<Shown>& shown) {
  std::vector<results::LaneSummary> scenarios;
  for (const Shown& pane : shown) {
    const auto all = results::lane_summaries_of(pane.header.value("scenarios", Header::array()));
    scenarios.push_back(pane.lane < static_cast<int>(all.size()) ? all[pane.lane] : results::LaneSummary{});
  }
  return scenarios;
}

/// Text in pictures has no subscripts: "0.5 c_R" is in words, and r_l a length in mean radii.
std::string in_words(const std::string& title) {
  static const std::regex speed(" c_R"), zone("r_l = ([^ ,]+)");
  return std::regex_replace(std::regex_replace(title, speed, " × Rayleigh speed"), zone, "damage zone $1 R");
}

std::vector<Pane> panes_of(const std::vector<Shown>& shown) {
  const std::vector<std::string> titles = results::lane_titles(scenarios_of(shown));
  std::vector<Pane> panes;
  for (std::size_t k = 0; k < shown.size(); ++k)
    panes.push_back({shown[k].run, shown[k].lane, in_words(titles[k])});
  return panes;
}

/// The scheme's parameters that the lanes share; what sets them apart stands in their titles.
std::string scheme_of(const std::vector<results::LaneSummary>& lanes) {
  const results::LaneSummary& first = lanes.front();
  const auto shared = [&](auto member) {
    return std::all_of(lanes.begin(), lanes.end(),
                       [&](const results::LaneSummary& s) { return s.*member == first.*member; });
  };
  std::vector<std::string> parts;
  if (shared(&results::LaneSummary::relaxation_name) && !first.relaxation_name.empty())
    parts.push_back(first.relaxation_name + " relaxation");
  if (shared(&results::LaneSummary::damage_zone_ratio))  // NaN of simple release is shared by none
    parts.push_back(fmt::format("damage zone {:g} R", first.damage_zone_ratio));
  if (shared(&results::LaneSummary::damping_alpha))
    parts.push_back(first.damping_alpha > 0 ? fmt::format("damping {:g} of critical", first.damping_alpha)
                                            : std::string("no damping"));
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// What all panes have in common, in a sentence: "A measured crack in a plate of 200 × 40 mm, E = 10 GPa".
std::string title_of(const std::vector<Shown>& shown, const std::vector<results::LaneSummary>& lanes) {
  const auto shared = [&](const char* key) {
    const double first = shown.front().header.value(key, NAN);
    return std::all_of(shown.begin(), shown.end(),
                       [&](const Shown& pane) { return pane.header.value(key, NAN) == first; });
  };
  const std::string& course = lanes.front().crack_course;
  const bool alike = std::all_of(lanes.begin(), lanes.end(), [&](const results::LaneSummary& lane) {
    return lane.crack_course == course;
  });
  const Header& header = shown.front().header;
  std::string title = !alike                  ? "A crack in a plate"
                      : course == "measured"  ? "A measured crack in a plate"
                      : course == "by itself" ? "A predicted crack in a plate"
                                              : "A crack in a plate";
  if (shared("length_m") && shared("height_m"))
    title += fmt::format(" of {:.4g} × {:.4g} mm", 1e3 * header.at("length_m").get<double>(),
                         1e3 * header.at("height_m").get<double>());
  if (shared("young_modulus_pa"))
    title += fmt::format(", E = {:.4g} GPa", 1e-9 * header.at("young_modulus_pa").get<double>());
  return title;
}

}  // namespace

std::vector<Shown> open_lanes(const Request& request, std::vector<std::string>& notes) {
  std::vector<Shown> shown;
  for (const fs::path& run : request.runs) {
    const auto journal = open(run, notes);
    const Header header = Header::parse(journal->header_json());
    if (!header.contains("path"))
      throw BadRequest(fmt::format(
          "{} was written by an older version, which does not store the crack's path: run it again",
          run.string()));
    std::vector<int> lanes = request.lanes;
    for (int k = 0; request.lanes.empty() && k < journal->lanes(); ++k) lanes.push_back(k);
    for (const int lane : lanes) {
      if (lane < 0 || lane >= journal->lanes())
        throw BadRequest(fmt::format("{} has no lane {}: its lanes are 0 to {}", run.string(), lane,
                                     journal->lanes() - 1));
      shown.push_back({run, lane, journal, header});
    }
  }
  if (shown.size() > most_panes)
    throw BadRequest(fmt::format("{} lanes, and a frame shows up to {}: choose some with --lane",
                                 shown.size(), most_panes));
  return shown;
}

void choose_clock(Plan& plan, const std::vector<Shown>& shown) {
  plan.times_s.clear();
  plan.tips_m.clear();
  const auto lasts = [](const Shown& pane) {
    return pane.frames().back().time_s - pane.frames().front().time_s;
  };
  const Shown& longest = *std::max_element(
      shown.begin(), shown.end(), [&](const Shown& a, const Shown& b) { return lasts(a) < lasts(b); });
  for (const results::FrameEntry& frame : longest.frames()) {
    plan.times_s.push_back(frame.time_s - longest.frames().front().time_s);
    plan.tips_m.push_back(frame.tip_m);
  }
}

Plan plan_of(const Request& request) {
  std::vector<std::string> notes;
  Plan plan = plan_of(request, open_lanes(request, notes));
  plan.notes = std::move(notes);
  return plan;
}

Plan plan_of(const Request& request, const std::vector<Shown>& shown) {
  Plan plan;
  plan.job.look = look_for(request, shown.front().header);
  plan.job.width = request.width;
  plan.job.height = request.height;
  const Field& field = field_named(plan.job.look.field);
  for (const Shown& pane : shown) check_stored(pane, field, plan.job.look);
  plan.job.panes = panes_of(shown);
  plan.job.look.scheme = scheme_of(scenarios_of(shown));
  if (plan.job.look.title.empty()) plan.job.look.title = title_of(shown, scenarios_of(shown));
  choose_range(plan, request, shown, field);
  choose_clock(plan, shown);
  return plan;
}

std::vector<double> evenly_chosen(const std::vector<double>& times_s, int count) {
  const auto stored = static_cast<int>(times_s.size());
  if (count > stored)
    throw BadRequest(
        fmt::format("--frames {}: the run holds {} frames, and frames are not interpolated; run it with "
                    "--set output.frames={}",
                    count, stored, count));
  std::vector<double> chosen;
  for (int k = 0; k < count; ++k)
    chosen.push_back(
        times_s[count == 1 ? stored - 1 : static_cast<std::size_t>(k) * (stored - 1) / (count - 1)]);
  return chosen;
}

}  // namespace rift::viz
