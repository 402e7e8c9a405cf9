#include "engine/claims/claims.hpp"

#include "engine/claims/judges.hpp"
#include "engine/claims/lattice_efficiency.hpp"
#include "engine/scene/derived.hpp"
#include "engine/study/identity.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace rift::claims {
namespace {

Claim picture(std::string name, std::string artefact, std::string text, std::string preset,
              std::vector<double> at) {
  Claim claim{std::move(name), std::move(artefact), std::move(text), {std::move(preset)}};
  claim.standing = "a picture";
  claim.pictures_at = std::move(at);
  return claim;
}

Claim cylinders_picture() {
  Claim claim = picture("fig16", "Fig. 16", "Cylinders of 750, 5,500 and 35,000 elements, drawn.",
                        "fig16_cylinders", {0});
  claim.calibration = true;
  return claim;
}

Claim of_cylinders(std::string name, std::string artefact, std::string text, std::string preset,
                   Judgement (*judge)(const Evidence&)) {
  Claim claim{std::move(name), std::move(artefact), std::move(text), {std::move(preset)}, judge};
  claim.calibration = true;
  return claim;
}

std::vector<Claim> figures() {
  return {
      {"fig01",
       "Fig. 1",
       "The analytic correction factor falls quasi-linearly from 1 at 0 to 0 at c_r (Broberg).",
       {},
       judges::fig01},
      picture("fig02", "Fig. 2", "A discrete lattice: elements and their beams, drawn.", "fig02_lattice",
              {0}),
      picture("fig03", "Fig. 3", "The plate's geometry with its boundary conditions, drawn.",
              "fig03_geometry", {0}),
      picture("fig04", "Fig. 4",
              "Frames of the running crack, coloured by vertical displacement, the tip marked.",
              "fig04_frames", {0.25, 0.6, 0.95}),
      {"fig05",
       "Fig. 5",
       "Energy balance at 0.2 c_r: tension to 0.47 ms, stabilisation to 0.71 ms, fracture to 1.16 ms; "
       "kinetic and "
       "fracture energy rise as elastic energy falls; inertia of the loading below 1 % of the total.",
       {"fig05_energy_balance"},
       judges::fig05},
      {"fig06",
       "Fig. 6",
       "S-NRT: the ratio is quasi-constant after 20 % of the length for most velocities and tends to 0 at "
       "1.0 c_r.",
       {"fig06_snrt_position"},
       judges::fig06},
      {"fig07",
       "Fig. 7",
       "S-NRT agrees with the analytic curve only in 0.6-1.0 c_r; below 0.4 at 0.01 c_r.",
       {"fig07_snrt_velocity"},
       judges::fig07},
      {"fig08",
       "Fig. 8",
       "S-NRT damped at the crack surface (< 6 % of beams) or everywhere: closer than undamped; too low in "
       "0.01-0.4 c_r, too high in 0.4-0.8 c_r; total damping better than surface damping in 0.01-0.4 c_r.",
       {"fig07_snrt_velocity", "fig08_snrt_damping", "fig08_snrt_surface"},
       judges::fig08},
      {"fig09",
       "Fig. 9",
       "The damage zone: beams are intact from L_CZM ahead of the tip on, soften within, and are gone at the "
       "tip.",
       {},
       judges::fig09},
      {"fig10",
       "Fig. 10",
       "The three relaxation schemes (eqs. 9-11): from 1 to 0 over the zone, square root above linear above "
       "quadratic.",
       {},
       judges::fig10},
      {"fig11",
       "Fig. 11",
       "P-NRT at r_l = 1: linear and quadratic are near the analytic curve; square root is too low in "
       "0.05-0.4 c_r.",
       {"fig11_relaxation"},
       judges::fig11},
      {"fig12",
       "Fig. 12",
       "Linear scheme: r_l = 1 is best; 1.5 too high in 0.2-0.8 c_r; 0.5 too low in 0.01-0.6 c_r.",
       {"fig12_damage_zone"},
       judges::fig12},
      {"fig13",
       "Fig. 13",
       "P-NRT (linear, r_l = 1): tends to 1 at 0.01 c_r; constant from 10-20 % of the length, above 0.8 c_r "
       "from "
       "about 40 %.",
       {"fig13_pnrt_position"},
       judges::fig13},
      {"fig14",
       "Fig. 14",
       "5,000, 20,000 and 80,000 elements: almost no influence; between the last two 0.002 at 0.05 c_r and "
       "0.018 "
       "at 1.0 c_r.",
       {"fig14_elements"},
       judges::fig14},
      {"fig15",
       "Fig. 15",
       "P-NRT is best of all; too low below 0.4 c_r; at 1.0 c_r above 0 and tending to it with more "
       "elements.",
       {"fig15_all", "fig08_snrt_damping", "fig08_snrt_surface", "fig14_elements"},
       judges::fig15},
      cylinders_picture(),
      of_cylinders(
          "fig17", "Fig. 17",
          "E and nu of compressed cylinders, five packings each, converge: within 2.5 % above 15,000 "
          "elements; micro parameters are scanned, interpolated and selected.",
          "fig17_calibration", judges::fig17),
  };
}

std::vector<Claim> tables() {
  return {
      {"table1",
       "Table 1",
       "The velocity Verlet scheme, which conserves K + U - C: with it the books of the whole test of Fig. 5 "
       "close to "
       "1e-10 of the energy (its second order is among the tests).",
       {"fig05_energy_balance"},
       judges::table1},
      of_cylinders("table2", "Table 2",
                   "E_M = 10.3 GPa, nu_M = 0.3 from E_mu = 356 GPa, nu_mu = 0.3, r_mu = 0.3.",
                   "table2_elastic_parameters", judges::table2),
  };
}

std::vector<Claim> sections() {
  return {
      {"sec2_linear",
       "Section 2.4",
       "The fracture energy grows linearly with the crack over the window.",
       {"sec2_linear"},
       judges::sec2_linear},
      {"sec3_specimens",
       "Section 3",
       "Three specimens differ negligibly.",
       {"sec3_specimens"},
       judges::sec3_specimens},
      {"sec3_damping",
       "Section 3.2",
       "So small a damping changes the structure's behaviour almost nowhere: only frequencies near the "
       "highest "
       "are damped.",
       {"sec3_damping"},
       judges::sec3_damping},
      {"sec4_time_step",
       "Section 4.2",
       "L_CZM = 0.49 mm = 0.0024 L; a beam takes about 100 steps to degrade at 0.1 c_r and 10 at 1.0 c_r; a "
       "smaller time step changes nothing.",
       {"sec4_time_step", "fig13_pnrt_position"},
       judges::sec4_time_step},
      {"sec4_longer",
       "Section 4.2",
       "A longer plate will not offer better results.",
       {"sec4_longer", "fig13_pnrt_position"},
       judges::sec4_longer},
      {"sec5_paths",
       "Section 5",
       "One specimen serves many paths: at 0.4, 0.5, 0.6 H the ratio is the same "
       "within scatter.",
       {"sec5_paths"},
       judges::sec5_paths},
      {"sec5_residual",
       "Section 5",
       "Broken beams keep a minimum of energy.",
       {"sec5_residual"},
       judges::sec5_residual},
      {"sec5_bending",
       "Section 5",
       "Slight out-of-plane bending at low velocity: at most 5 % of the thickness, and more at 0.1 c_r and "
       "below than at 0.5 c_r and above.",
       {"sec5_bending", "fig13_pnrt_position"},
       judges::sec5_bending},
  };
}

std::vector<Claim> all_claims() {
  std::vector<Claim> all = figures();
  for (const auto part : {tables, sections, beyond_the_paper})
    for (Claim& claim : part()) all.push_back(std::move(claim));
  return all;
}

}  // namespace

const std::vector<Claim>& claims() {
  static const std::vector<Claim> table = all_claims();
  return table;
}

const Claim* find_claim(std::string_view name) {
  const auto found =
      std::find_if(claims().begin(), claims().end(), [&](const Claim& c) { return c.name == name; });
  return found == claims().end() ? nullptr : &*found;
}

Curve curve_in(const Evidence& evidence, Selection selection) {
  if (selection.elements == 0) selection.elements = evidence.elements;
  return curve_of(evidence.rows, selection);
}

Curve curve_of_elements(const Evidence& evidence, double factor) {
  Selection selection;
  selection.elements = static_cast<int>(std::lround(factor * evidence.elements));
  return curve_of(evidence.rows, selection);
}
namespace {

constexpr int coarser = 4;  // fewer elements in quick; the step of a scene that gives one grows as much
constexpr int most_quick_elements = 10000;
constexpr double slowest = 0.011;  // [c_r]

/// The scenes that a preset asks for.
std::vector<scene::Scene> scenes_of(const scene::Preset& preset) {
  std::vector<scene::Scene> scenes;
  for (const scene::StudyRow& row : preset.study) scenes.push_back(row.scene);
  if (!scenes.empty()) return scenes;
  for (const scene::StiffnessChoice stiffness :
       {scene::StiffnessChoice::bulk, scene::StiffnessChoice::in_situ}) {
    scenes.push_back(preset.scene);
    scenes.back().material.stiffness = stiffness;
    scenes.back().output.frames = 0;
  }
  return scenes;
}

/// The scene as --quick computes it; nothing where it leaves it out.
std::optional<scene::Scene> quick_scene(scene::Scene scene) {
  scene.specimen.elements /= coarser;
  if (scene.specimen.elements > most_quick_elements) return std::nullopt;
  if (scene::highest_velocity(scene) < slowest && scene.specimen.seed != 1) return std::nullopt;
  if (scene.solver.dt) {
    *scene.solver.dt *= coarser;
    scene.loading.ramp_steps /= coarser;
    scene.loading.hold_steps /= coarser;
  }
  return scene;
}

}  // namespace

int plate_elements(Effort effort) {
  return effort == Effort::quick ? paper_elements / coarser : paper_elements;
}

PaperStudy merge_presets(const std::vector<std::pair<std::string, scene::Preset>>& presets, Effort effort) {
  PaperStudy merged;
  if (!presets.empty()) merged.preset.scene = presets.front().second.scene;
  merged.preset.name = "reproduction";
  std::map<std::string, int> row_of_scene;  // by the scene as text
  for (const auto& [name, preset] : presets) {
    std::vector<int>& rows = merged.of[name];
    for (const scene::Scene& scene : scenes_of(preset)) {
      const std::optional<scene::Scene> wanted =
          effort == Effort::quick ? quick_scene(scene) : std::optional<scene::Scene>(scene);
      if (!wanted) continue;
      const auto [known, fresh] =
          row_of_scene.emplace(scene::preset_text(*wanted), static_cast<int>(merged.preset.study.size()));
      if (fresh) merged.preset.study.push_back(study::study_row_of(*wanted));
      if (std::find(rows.begin(), rows.end(), known->second) == rows.end()) rows.push_back(known->second);
    }
  }
  return merged;
}

}  // namespace rift::claims
