#pragma once

#include "engine/study/curve.hpp"
#include "engine/study/store.hpp"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace rift::study {

/// What a claim is judged by: the scenarios of one stiffness, and their series.
struct Evidence {
  std::vector<SummaryRow> rows;
  int elements = paper_elements;                              // of the plate that stands for the paper's
  std::function<SeriesTable(const SummaryRow&)> series = {};  // empty where it is not stored
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
  /// Of a claim that is a picture: at which fractions of the moments of the preset that it needs.
  std::vector<double> pictures_at = {};
  /// It looks at cylinders that its one preset calibrates, with the paper's beams, and not at cracked plates.
  bool calibration = false;
  bool beyond = false;  // not the paper's but a finding of our own, with in-situ beams only
};

/// All claims, in the order of the paper's artefacts and then of its sections, and what goes beyond it.
const std::vector<Claim>& claims();

/// The claim of a name, or null.
const Claim* find_claim(std::string_view name);

/// The curve of a selection, whose elements are those of the evidence unless it names others.
Curve curve_in(const Evidence& evidence, Selection selection);

/// Progressive release on lattices of `factor` times the elements.
Curve curve_of_elements(const Evidence& evidence, double factor);

}  // namespace rift::study
