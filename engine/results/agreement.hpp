#pragma once

#include "engine/results/schema.hpp"

#include <cstdint>
#include <filesystem>
#include <string>

/// What the records of one journal must agree on.
namespace rift::results {

/// "lanes" of a run's header; 0 where it names none.
[[nodiscard]] std::int32_t lanes_of_header(const std::string& header_json);

/// Throws WorldError where a field of the frame has not as many values as the geometry has elements or
/// crossing beams.
void check_fit(const std::filesystem::path& path, const Geometry& geometry, const Frame& frame);

}  // namespace rift::results
