#include "engine/scene/values_text.hpp"

#include "engine/scene/needs.hpp"

namespace rift::scene {

std::string value_that_counts(const Scene& scene, const Parameter& row) {
  const Scene::Loading& loading = scene.loading;
  const bool other_crack = row.key == "crack.velocity" && !scene.crack.history.empty();
  const bool other_load =
      row.key == "loading.displacement" && (loading.force || loading.traction || !loading.curve.row.empty());
  return other_crack || other_load ? std::string{} : toml_value(scene, row);
}

bool is_used(const Scene& scene, const Parameter& row) {
  return !row.key.starts_with("calibration.") || needs_calibration(scene);
}

std::string values_text(const Scene& scene, bool (*wanted)(const Parameter&)) {
  std::string text;
  for (const Parameter& row : parameters()) {
    if (!wanted(row) || !is_used(scene, row)) continue;
    const std::string value = value_that_counts(scene, row);
    if (!value.empty()) text.append(row.key).append(" = ").append(value).append("\n");
  }
  return text;
}

}  // namespace rift::scene
