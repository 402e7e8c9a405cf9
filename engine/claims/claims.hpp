#pragma once

#include "engine/calibration/cylinders.hpp"
#include "engine/claims/curve.hpp"
#include "engine/scene/preset.hpp"
#include "engine/study/store.hpp"

#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace rift::claims {

using study::SeriesTable;

/// What the specimen of a scenario shows of itself in static pulls, as simulation::OwnConstants has it.
struct OwnPlate {
  double poisson_ratio = 0, rayleigh_speed = 0, height = 0;  // [-]; [m/s], of long waves; [m], between grips
};

/// A claim is judged by the scenarios of one stiffness and their series, or by cylinders.
struct Evidence {
  std::vector<SummaryRow> rows;
  int elements = paper_elements;                              // of the plate that stands for the paper's
  std::function<SeriesTable(const SummaryRow&)> series = {};  // empty where it is not stored
  std::function<OwnPlate(const SummaryRow&)> own = {};        // empty where it is not measured
  std::vector<calibration::CylinderResult> cylinders = {};    // of all sizes, with the paper's beams
  bool one_size = false;  // no plates of more or fewer elements: parts of claims about these are left out
};

/// A claim of the paper, one artefact each.
struct Claim {
  std::string name;                // "fig07", as `rift reproduce` knows it
  std::string artefact;            // "Fig. 7"
  std::string text;                // what the paper says
  std::vector<std::string> needs;  // presets whose scenarios it looks at
  /// The verdict for one stiffness; empty for a picture.
  std::function<Judgement(const Evidence&)> judge = {};
  std::string standing = {};  // of a picture: what stands for a verdict
  /// A claim that is a picture shows the preset that it needs at these fractions of its moments.
  std::vector<double> pictures_at = {};
  /// It looks at cylinders that its one preset calibrates, with the paper's beams, and not at cracked plates.
  bool calibration = false;
  bool beyond = false;  // not the paper's but a finding of our own, with in-situ beams only
};

/// The claims about the paper's figures and tables, and about its sections, each beside its judge.
std::vector<Claim> claims_of_figures();
std::vector<Claim> claims_of_sections();

/// All claims, in the order of the paper's artefacts and then of its sections, and what goes beyond it.
const std::vector<Claim>& claims();

/// The claim of a name, or null.
const Claim* find_claim(std::string_view name);

/// The rows of a selection, and their curve; its elements are those of the evidence unless it names others.
std::vector<SummaryRow> rows_in(const Evidence& evidence, Selection selection);
Curve curve_in(const Evidence& evidence, Selection selection);

/// Progressive release on lattices of `factor` times the elements.
Curve curve_of_elements(const Evidence& evidence, double factor);

/// Several presets as one study, so that scenarios of equal lattice and step march side by side whichever
/// figure they belong to.
struct PaperStudy {
  scene::Preset preset;                        // its study: each scene once, all axes named
  std::map<std::string, std::vector<int>> of;  // rows of each preset, by its name (the file's stem)
};

/// A fourth of the elements, scenes still larger than 10,000 elements left out, steps given in seconds four
/// times as long and the ramp in as much time; 0.01 c_r, two thirds of all the work, with the first specimen
/// only.
enum class Effort { full, quick };

/// Elements of the plate that stands for the paper's.
int plate_elements(Effort effort);

/// Merges presets without issues. One without a study stands for its own scene with both stiffnesses, without
/// frames.
PaperStudy merge_presets(const std::vector<std::pair<std::string, scene::Preset>>& presets, Effort effort);

}  // namespace rift::claims
