#include "engine/claims/readings.hpp"

#include "engine/base/numbers.hpp"
#include "engine/fracture/release_rate.hpp"
#include "engine/study/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace rift::claims {
namespace {

constexpr double fast = 0.8 + 1e-9;  // [c_r]: above it the ratio becomes constant late
constexpr int samples = 200;         // windows other than the presets' are read between samples
constexpr const char* corotational = "corotational";

/// Energy that has left the lattice at the crack up to each sample, and where the tip was.
struct Released {
  std::vector<double> tip, energy;  // [m], [J]
};

Released released_in(const SeriesTable& s, Kinetic kinetic) {
  Released r;
  for (std::size_t k = 0; k < s.phase.size(); ++k) {
    if (s.phase[k] != "fracture") continue;
    const auto of = [&](const char* name) { return s.at(name)[k]; };
    double energy = of("work_external_j") - of("energy_elastic_j") - of("energy_kinetic_translation_j") +
                    of("energy_step_correction_j") - of("energy_numerical_damping_j") -
                    of("energy_contact_j");
    if (kinetic == Kinetic::all) energy -= of("energy_kinetic_rotation_j");
    r.tip.push_back(of("tip_m")), r.energy.push_back(energy);
  }
  return r;
}

/// Linear between samples; NaN beyond them.
double energy_at(const Released& r, double tip) {
  constexpr double same_length = 1e-6;  // [m]
  if (r.tip.size() < 2 || tip < r.tip.front() - same_length || tip > r.tip.back() + same_length) return NAN;
  const auto after = std::lower_bound(r.tip.begin() + 1, r.tip.end() - 1, tip);
  const auto k = static_cast<std::size_t>(after - r.tip.begin());
  const double part = (tip - r.tip[k - 1]) / (r.tip[k] - r.tip[k - 1]);
  return std::lerp(r.energy[k - 1], r.energy[k], part);
}

double ratio_between(const Released& r, const SummaryRow& row, double from, double to) {
  const double unit = row.thickness_m * (to - from) * row.length_m * row.g_i0_j_m2;
  return (energy_at(r, to * row.length_m) - energy_at(r, from * row.length_m)) / unit;
}

bool is_matched(const SummaryRow& row, double matched_coordination) {
  constexpr double of_presets = 6.0;
  return std::abs(row.coordination - matched_coordination) < std::abs(row.coordination - of_presets);
}

Beams beams_of(const SummaryRow& row, double matched_coordination) {
  if (row.stiffness == "in-situ") return Beams::in_situ;
  return is_matched(row, matched_coordination) ? Beams::matched : Beams::bulk;
}

SummaryRow read_again(SummaryRow row, const SeriesTable& series, const Reading& reading) {
  constexpr int parts = fracture::sub_windows;
  const auto window = window_of(reading.window, row);
  const Released r = released_in(series, reading.kinetic);
  std::vector<double> part;
  for (int k = 0; k < parts; ++k)
    part.push_back(ratio_between(r, row, std::lerp(window[0], window[1], static_cast<double>(k) / parts),
                                 std::lerp(window[0], window[1], static_cast<double>(k + 1) / parts)));
  const double middle = 0.5 * (window[0] + window[1]);
  row.ratio = ratio_between(r, row, window[0], window[1]);
  row.ratio_trend = ratio_between(r, row, middle, window[1]) - ratio_between(r, row, window[0], middle);
  row.ratio_scatter = base::deviation_of(part);
  row.error_broberg = row.ratio - row.broberg;
  row.window_over_length = window;
  return row;
}

}  // namespace

const char* name_of(Kinetic kinetic) { return kinetic == Kinetic::all ? "all" : "translation"; }

const char* name_of(WindowChoice window) {
  constexpr const char* names[] = {"default", "text", "early"};
  return names[static_cast<std::size_t>(window)];
}

const char* name_of(Beams beams) {
  constexpr const char* names[] = {"in-situ", "bulk", "bulk, matched"};
  return names[static_cast<std::size_t>(beams)];
}

Reading project_reading(Beams beams) { return {.beams = beams}; }

Reading letter_of_paper(Beams beams) {
  return {.kinetic = Kinetic::translation,
          .kinematics = corotational,
          .window = WindowChoice::text,
          .beams = beams};
}

std::string title_of(const Reading& reading) {
  if (reading == project_reading(reading.beams)) return "project";
  return reading == letter_of_paper(reading.beams) ? "letter" : "";
}

std::vector<Reading> all_readings() {
  std::vector<Reading> all;
  for (const Beams beams : {Beams::in_situ, Beams::bulk, Beams::matched})
    for (const char* kinematics : {"linear", corotational})
      for (const Kinetic kinetic : {Kinetic::all, Kinetic::translation})
        for (const WindowChoice window :
             {WindowChoice::default_window, WindowChoice::text, WindowChoice::early})
          all.push_back({kinetic, kinematics, window, beams});
  return all;
}

std::array<double, 2> window_of(WindowChoice window, const SummaryRow& row) {
  if (window == WindowChoice::default_window) return row.window_over_length;
  if (window == WindowChoice::early) return {0.1, 0.2};
  if (row.crack_velocity_over_cr > fast) return {0.4, 0.5};
  return row.technique == "simple" ? std::array{0.2, 0.3} : std::array{0.1, 0.2};
}

double ratio_over(const SeriesTable& series, const SummaryRow& row, Kinetic kinetic,
                  const std::array<double, 2>& window) {
  return ratio_between(released_in(series, kinetic), row, window[0], window[1]);
}

Evidence evidence_under(const Evidence& all, const Reading& reading, double matched_coordination) {
  Evidence evidence{.rows = {}, .elements = all.elements, .series = all.series, .one_size = true};
  for (const SummaryRow& row : all.rows)
    if (row.kinematics == reading.kinematics && beams_of(row, matched_coordination) == reading.beams)
      evidence.rows.push_back(read_again(row, all.series(row), reading));
  return evidence;
}

std::vector<std::string> reading_presets() {
  return {"fig07_snrt_velocity", "fig08_snrt_damping", "fig08_snrt_surface", "fig11_relaxation",
          "fig12_damage_zone"};
}

std::vector<const Claim*> claims_of_readings() {
  std::vector<const Claim*> chosen;
  for (const char* name : {"fig06", "fig07", "fig08", "fig11", "fig12", "fig13", "fig15", "sec2_linear",
                           "sec3_specimens", "sec5_residual", "sec5_bending"})
    chosen.push_back(find_claim(name));
  return chosen;
}

PaperStudy study_of_readings(const PaperStudy& quick, double matched_coordination) {
  PaperStudy all;
  all.preset = quick.preset;
  all.preset.name = "readings";
  all.preset.study.clear();
  for (const scene::StudyRow& row : quick.preset.study) {
    scene::Scene scene = row.scene;
    scene.output.samples = samples;
    for (const lattice::Kinematics kinematics :
         {lattice::Kinematics::linear, lattice::Kinematics::corotational}) {
      scene.solver.kinematics = kinematics;
      all.preset.study.push_back(study::study_row_of(scene));
      if (scene.material.stiffness != scene::StiffnessChoice::bulk) continue;
      scene::Scene looser = scene;
      looser.specimen.coordination = matched_coordination;
      all.preset.study.push_back(study::study_row_of(looser));
    }
  }
  return all;
}

std::string verdict_of_both(const Judgement& project, const Judgement& letter) {
  if (project.verdict == letter.verdict) return name_of(project.verdict);
  return fmt::format("depends on the reading: {} by the project's, {} by the paper's letter",
                     name_of(project.verdict), name_of(letter.verdict));
}

}  // namespace rift::claims
