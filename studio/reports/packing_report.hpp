#pragma once

#include "engine/packing/structure.hpp"
#include "engine/scene/scene.hpp"
#include "engine/simulation/record.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>

namespace rift::studio {

/// What `rift pack` reports.
struct PackedSpecimen {
  std::string command;
  scene::Scene scene;
  simulation::BuildInfo build;
  packing::Box box;
  packing::Packing packing;
  int rattlers = 0;
  std::size_t beams = 0;
  double wall_s = 0;
  bool from_cache = false;
};

nlohmann::ordered_json packing_json(const PackedSpecimen& specimen);
std::string packing_text(const nlohmann::ordered_json& summary, bool color);

/// report.html, summary.json, elements.csv (x, y, z, radius [m]) and charts/. Throws WorldError.
void write_packing_report(const PackedSpecimen& specimen, const nlohmann::ordered_json& summary,
                          const std::filesystem::path& folder);

}  // namespace rift::studio
