#pragma once

#include "engine/results/schema.hpp"

#include <cstdint>
#include <filesystem>
#include <span>

namespace rift::results {

/// Writes one moment as a VTK XML PolyData file (.vtp): elements as vertices, beams as lines, radius, and of
/// each frame the fields it has, named as in the archive. Binary, appended raw, little-endian, 64-bit sizes;
/// read by every ParaView and by VTK from 5.10 on. The file appears whole or not at all. Throws WorldError.
/// @param frames  of one moment, a lane each; none: the geometry alone
/// @param lanes   of the run: with several, names carry their lane
void write_vtp(const std::filesystem::path& path, const Geometry& geometry, std::span<const Frame> frames,
               std::int32_t lanes);

}  // namespace rift::results
