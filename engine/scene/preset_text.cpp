#include "engine/scene/parameters.hpp"
#include "engine/scene/preset.hpp"

#include <fmt/format.h>

namespace rift {

std::string preset_text(const Scene& scene) {
  std::string out = "# The effective preset; docs/parameters.md says more.\n";
  std::string table;
  for (const Parameter& row : parameters()) {
    if (table_of(row) != table) {
      table = table_of(row);
      out += fmt::format("\n[{}]\n", table);
    }
    const std::string value = toml_value(scene, row);
    out += fmt::format("# {} Allowed: {}.\n", row.doc, allowed(row));
    out += value.empty() ? fmt::format("# {} is not given\n", name_of(row))
                         : fmt::format("{} = {}\n", name_of(row), value);
  }
  return out;
}

}  // namespace rift
