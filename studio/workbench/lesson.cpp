#include "studio/workbench/lesson.hpp"

#include "engine/base/files.hpp"
#include "engine/scene/issue.hpp"
#include "engine/simulation/record.hpp"
#include "studio/reports/report.hpp"
#include "studio/text/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rift::studio {
namespace {

double kinetic(const results::LaneSummary& lane) {
  return lane.energy_kinetic_translation_j + lane.energy_kinetic_rotation_j;
}

/// 0: the first is clearly larger; 1: the second; 2: they are within a twentieth.
int larger(double first, double second) {
  if (std::abs(first - second) <= 0.05 * std::max(std::abs(first), std::abs(second))) return 2;
  return first > second ? 0 : 1;
}

Answer of_node_release(const Lanes& s) {
  return {larger(s[0].ratio, s[1].ratio),
          fmt::format("Simple release shows {:.3f} of the static rate, progressive release {:.3f}; Broberg's "
                      "theory says {:.3f}. {:.1f} J of kinetic energy remain in the first plate, {:.1f} J in "
                      "the second: the energy of the ringing did not reach the crack.",
                      s[0].ratio, s[1].ratio, s[0].broberg, kinetic(s[0]), kinetic(s[1]))};
}

Answer of_damping(const Lanes& s) {
  const double undamped = s[0].ratio, damped = s[2].ratio;
  return {
      larger(damped, undamped) == 0   ? 0
      : larger(damped, undamped) == 1 ? 1
                                      : 2,
      fmt::format(
          "With the damping energy counted as released, the ratio is {:.3f} undamped, {:.3f} damped along "
          "the crack and {:.3f} damped everywhere; the part of the released beams is {:.3f}, {:.3f} and "
          "{:.3f}. Broberg's theory says {:.3f}: damping counts ringing as if it were fracture.",
          undamped, s[1].ratio, damped, s[0].ratio_fracture, s[1].ratio_fracture, s[2].ratio_fracture,
          s[0].broberg)};
}

Answer of_velocity(const Lanes& s) {
  std::string numbers;
  bool falls = true, grows = true;
  for (std::size_t k = 0; k < s.size(); ++k) {
    numbers += fmt::format("{}{:.3f} at {:g} c_R (Broberg {:.3f})", k == 0 ? "" : ", ", s[k].ratio,
                           s[k].crack_velocity_over_cr, s[k].broberg);
    if (k == 0) continue;
    falls = falls && s[k].ratio < s[k - 1].ratio;
    grows = grows && s[k].ratio > s[k - 1].ratio;
  }
  return {falls   ? 0
          : grows ? 1
                  : 2,
          fmt::format("The ratio is {}. A fast crack leaves more of the energy behind as waves: a larger "
                      "part of it remains kinetic energy.",
                      numbers)};
}

const std::vector<Lesson>& table() {
  static const std::vector<Lesson> all{
      {"node-release",
       "Why nodes must not be released at once",
       "teach_node_release",
       true,
       {"A plate is pulled and held. A crack runs through it at a velocity that we prescribe, and we ask how "
        "much energy is released per square metre of new crack area: the dynamic energy release rate G_ID, "
        "over the static one, G_I0.",
        "A lattice is cut beam by beam. Simple node release removes a beam at the moment when the tip "
        "reaches it. Its force vanishes from one step to the next, and its neighbours vibrate like a plucked "
        "string.\n\nProgressive release reduces the stiffness of a beam gradually while the tip approaches, "
        "over a damage zone of some mean radii.\n\nBoth are run side by side. A terminal with pixels shows a "
        "picture of all elements: behind the tip of the first plate neighbouring elements move against each "
        "other, which cells, each the mean of several elements, smooth out."},
       "Both plates share one clock. The colours show the vertical velocity: look behind the tips (the "
       "dots). The curves below are the release-rate ratios, the horizontal lines are theory.",
       "Same plate, same pull, same velocity. Which of the two shows the larger G_ID / G_I0?",
       {"simple release", "progressive release", "both are equal within 5 %"},
       of_node_release,
       "No energy was lost: the energy balance of both plates closes. But vibrations of the lattice at "
       "wavelengths of a few elements have no counterpart in a continuum, and their energy is missing at the "
       "crack tip."},
      {"damping",
       "Can damping repair simple release?",
       "teach_damping",
       false,
       {"Simple release leaves a plate that rings. An obvious cure is to damp the beams: either those along "
        "the crack, or all of them.",
        "Dampers dissipate kinetic energy. How should it be counted? The crack set it free, and the plate no "
        "longer holds it: the paper counts it as released."},
       "Three plates, all cut by simple release: undamped, damped along the crack, damped everywhere. Press "
       "tab to look at one after the other, and watch the kinetic energies in the table.",
       "We count the damping energy as released. What does damping everywhere do to G_ID / G_I0?",
       {"it grows", "it falls", "it stays within 5 %"},
       of_damping,
       "The ratio comes closer to the theory, but for the wrong reason: the beams released as much as "
       "before. A cure has to prevent the ringing, not absorb it."},
      {"velocity",
       "What a faster crack leaves behind",
       "teach_velocity",
       false,
       {"The energy that a crack releases flows to its tip from the surrounding plate, at the speed of "
        "waves. The Rayleigh speed c_R is the speed of waves along a free surface, and a crack consists of "
        "two new surfaces.",
        "Broberg (1960) computed the release rate of a crack that runs at a constant velocity through an "
        "unbounded plate: a curve from 1 at rest to 0 at c_R."},
       "Four cracks share one clock, at 0.2, 0.4, 0.6 and 0.9 c_R. Press tab to change the upper plate. The "
       "fast cracks finish first.",
       "What does G_ID / G_I0 do when the crack is faster?",
       {"it falls", "it grows", "neither"},
       of_velocity,
       "In an unbounded plate no energy reaches the tip at c_R: that is why cracks in brittle plates do not "
       "reach c_R, and branch at lower velocities. In a strip (s) all of it arrives at any velocity; here "
       "the "
       "ratio falls because the beams send more of it away as short waves, the faster the crack."}};
  return all;
}

/// What theory says of a lane, in its colour: of an unbounded plate by Broberg; the strip's limit is of all.
void add_theory(Chart& chart, const Lanes& lanes) {
  double end = 0.0;
  for (const ChartSeries& series : chart.series) end = std::max(end, series.x.back());
  std::vector<double> velocities;
  for (std::size_t k = 0; k < lanes.size(); ++k) {
    const double v = lanes[k].crack_velocity_over_cr;
    if (!std::isfinite(lanes[k].broberg) ||
        std::find(velocities.begin(), velocities.end(), v) != velocities.end())
      continue;
    velocities.push_back(v);
    ChartSeries line = level(fmt::format("Broberg, {:g} c_R", v), lanes[k].broberg, 0.0, end);
    line.colour = static_cast<int>(k);
    chart.series.push_back(std::move(line));
    if (velocities.size() == 1 && std::isfinite(lanes[k].freund))
      chart.series.push_back(level(fmt::format("Freund, {:g} c_R", v), lanes[k].freund, 0.0, end));
  }
  chart.series.push_back(level("strip", 1.0, 0.0, end));
}

NamedChart lesson_chart(const Live& live, const Lanes& lanes) {
  Chart chart{.title = "Release rate against tip position",
              .x_label = "tip position [mm]",
              .y_label = "G_{ID} / G_{I0} [-]",
              .x_range = {.min = 0.0}};
  for (std::size_t k = 0; k < live.lanes.size(); ++k) {
    // The title's c_R and r_l are written as a chart wants them.
    ChartSeries series = series_of(live.lanes[k].title, ChartSeries::Style::line, static_cast<int>(k),
                                   live.lanes[k].rates, [](const results::RatePoint& p) {
                                     return ChartPoint{1e3 * p.tip_m, p.ratio};
                                   });
    if (!series.x.empty()) chart.series.push_back(std::move(series));
  }
  if (!chart.series.empty()) add_theory(chart, lanes);
  return {"rates",
          "Of the run on the screen, sample by sample, without any smoothing; dashed: theory, which needs a "
          "constant velocity.",
          std::move(chart)};
}

}  // namespace

std::string_view theory_page() {
  return "Three theories stand beside the computed ratio; their lines are those of the lane that is shown. "
         "Broberg (B): a crack that grows from nothing in an unbounded plate. Freund (F): a half-infinite crack "
         "there. Strip (s): a long clamped strip, in which all the energy stored ahead reaches the tip at any "
         "velocity below c_R, so that the ratio is 1.\n\n"
         "Our plate is a strip, but of beams: where its ratio stays below 1, the rest of the energy leaves the "
         "tip as waves that no continuum has. A ratio near Broberg's does not confirm his theory.\n\n"
         "On the screen a curve ends in a letter: e elastic, k kinetic, f fracture, d damping energy; B, F and s "
         "the theories; a digit is the lane.";
}

std::span<const Lesson> lessons() { return table(); }

const Lesson& lesson_of(const std::string& name) {
  std::vector<std::string> names;
  for (const Lesson& lesson : table()) {
    if (lesson.name == name) return lesson;
    names.emplace_back(lesson.name);
  }
  const std::string nearest = scene::nearest_name(name, names);
  throw scene::InputError(
      {scene::Issue{.file = "rift studio",
                    .key = {},
                    .text = fmt::format("no lesson '{}'{}: the lessons are {}", scene::printable(name),
                                        nearest.empty() ? "" : fmt::format(", did you mean '{}'?", nearest),
                                        scene::listed(names, "and"))}});
}

Table lesson_table(const Lanes& lanes) {
  Table t{{"lane", "G_ID / G_I0", "from beams", "Broberg", "fracture J", "kinetic J", "damping J"}, {}};
  const std::vector<std::string> titles = results::lane_titles(lanes);
  for (std::size_t k = 0; k < lanes.size(); ++k) {
    const results::LaneSummary& s = lanes[k];
    t.rows.push_back({titles[k], number_cell(s.ratio, "{:.3f}"), number_cell(s.ratio_fracture, "{:.3f}"),
                      number_cell(s.broberg, "{:.3f}"), number_cell(s.energy_fracture_j, "{:.1f}"),
                      number_cell(kinetic(s), "{:.1f}"), number_cell(s.energy_damping_j, "{:.1f}")});
  }
  return t;
}

void write_handout(const Lesson& lesson, const Lanes& lanes, const Live& live, const LessonPicture& picture,
                   const std::filesystem::path& file) {
  std::string body =
      html_made({fmt::format("rift studio --lesson {}", lesson.name), {lanes.front().version, {}}, {}});
  for (const std::string_view page : lesson.before) body += html_paragraph(page);
  body += html_paragraph(theory_page());
  body += html_section(
      "What the run shows",
      html_paragraph(lesson.watch) +
          (picture.trouble.empty()
               ? html_picture(
                     picture.png,
                     "The plates at one moment, in colours of their vertical velocity; a dot is a tip.")
               : html_paragraph("No picture: " + picture.trouble)));
  std::optional<base::WorldError> no_chart;  // the page says why
  const std::string curves =
      html_figures({lesson_chart(live, lanes)}, file.parent_path() / "charts", no_chart);
  std::string question = html_paragraph(lesson.question);
  for (std::size_t k = 0; k < lesson.choices.size(); ++k)
    question += html_paragraph(fmt::format("{}. {}", k + 1, lesson.choices[k]));
  body += html_section("The question", question);
  const Answer answer = lesson.answer(lanes);
  body += html_section(
      "The answer of this run",
      html_paragraph(fmt::format("{}. {}. {}", answer.right + 1, lesson.choices[answer.right], answer.why)) +
          html_table(lesson_table(lanes)) + curves);
  body += html_section("What follows", html_paragraph(lesson.after));
  const scene::Preset preset = simulation::preset_of_run(file.parent_path());
  body += html_scenes(preset.lanes.empty() ? std::vector{preset.scene} : preset.lanes);
  body += html_paragraph(fmt::format("The run is that of rift run {}.", lesson.preset));
  base::write_whole_file(file, html_page(lesson.title, body));
}

}  // namespace rift::studio
