#include "engine/results/agreement.hpp"

#include "engine/base/world_error.hpp"
#include "engine/results/json_input.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rift::results {

std::int32_t lanes_of_header(const std::string& header_json) {
  const auto header = json_or_discarded(header_json);
  if (!header.is_object()) return 0;
  const auto lanes = header.find("lanes");
  return lanes != header.end() && lanes->is_number_integer() ? lanes->get<std::int32_t>() : 0;
}

void check_fit(const std::filesystem::path& path, const Geometry& geometry, const Frame& frame) {
  const auto fits = [](const auto& field, std::size_t count) {
    return field.empty() || field.size() == count;
  };
  const std::size_t elements = geometry.position.size();
  if (!fits(frame.displacement, elements) || !fits(frame.velocity, elements) ||
      !fits(frame.elastic_energy, elements) || !fits(frame.damage_factor, geometry.crossing.size()))
    throw base::WorldError("use", path,
                           fmt::format("the frame of step {} does not fit the geometry", frame.step));
}

}  // namespace rift::results
