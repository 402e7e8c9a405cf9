#include "engine/results/vtp.hpp"

#include "engine/base/files.hpp"
#include "engine/results/cell_fields.hpp"
#include "engine/results/journal_scan.hpp"

#include <fmt/format.h>

#include <numeric>
#include <string>
#include <string_view>
#include <vector>

namespace rift::results {
namespace {

/// The XML part, which says where each array lies, and the bytes it speaks of.
struct Document {
  std::string xml;
  std::string appended;

  void array(std::string_view type, std::string_view name, int components, const void* data,
             std::uint64_t bytes) {
    xml += fmt::format(
        R"(        <DataArray type="{}" Name="{}" NumberOfComponents="{}" format="appended" offset="{}"/>)"
        "\n",
        type, name, components, appended.size());
    appended.append(reinterpret_cast<const char*>(&bytes), sizeof(bytes));
    if (bytes > 0) appended.append(static_cast<const char*>(data), bytes);
  }
  void array(std::string_view name, const std::vector<std::array<float, 3>>& v) {
    array("Float32", name, 3, v.data(), v.size() * sizeof(v[0]));
  }
  void array(std::string_view name, const std::vector<float>& v) {
    array("Float32", name, 1, v.data(), v.size() * sizeof(v[0]));
  }
  void array(std::string_view name, const std::vector<std::int64_t>& v) {
    array("Int64", name, 1, v.data(), v.size() * sizeof(v[0]));
  }
  void array(std::string_view name, const std::vector<std::uint8_t>& v) {
    array("UInt8", name, 1, v.data(), v.size());
  }
};

void write_cells(Document& document, std::string_view name, const std::vector<std::int64_t>& connectivity,
                 std::int64_t size) {
  std::vector<std::int64_t> ends(connectivity.size() / static_cast<std::size_t>(size));
  for (std::size_t i = 0; i < ends.size(); ++i) ends[i] = static_cast<std::int64_t>(i + 1) * size;
  document.xml += fmt::format("      <{}>\n", name);
  document.array("connectivity", connectivity);
  document.array("offsets", ends);
  document.xml += fmt::format("      </{}>\n", name);
}

void write_topology(Document& document, const Geometry& geometry) {
  std::vector<std::int64_t> vertices(geometry.position.size());
  std::iota(vertices.begin(), vertices.end(), 0);
  std::vector<std::int64_t> lines;
  lines.reserve(2 * geometry.beam.size());
  for (const auto& beam : geometry.beam) lines.insert(lines.end(), beam.begin(), beam.end());
  write_cells(document, "Verts", vertices, 1);
  write_cells(document, "Lines", lines, 2);
}

}  // namespace

void write_vtp(const std::filesystem::path& path, const Geometry& geometry, std::span<const Frame> frames,
               std::int32_t lanes) {
  Document document;
  document.xml = fmt::format(R"(<?xml version="1.0"?>
<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
  <PolyData>
    <Piece NumberOfPoints="{}" NumberOfVerts="{}" NumberOfLines="{}" NumberOfStrips="0" NumberOfPolys="0">
      <PointData>
)",
                             geometry.position.size(), geometry.position.size(), geometry.beam.size());
  document.array("radius", geometry.radius);
  for (const auto& frame : frames) {
    if (!frame.displacement.empty())
      document.array(lane_name("displacement", frame.lane, lanes), frame.displacement);
    if (!frame.velocity.empty()) document.array(lane_name("velocity", frame.lane, lanes), frame.velocity);
    if (!frame.elastic_energy.empty())
      document.array(lane_name("elastic_energy", frame.lane, lanes), frame.elastic_energy);
  }
  document.xml += "      </PointData>\n      <CellData>\n";
  for (const auto& frame : frames) {
    if (frame.damage_factor.empty()) continue;
    const auto fields = cell_fields(geometry, frame);
    document.array(lane_name("damage_factor", frame.lane, lanes), fields.damage_factor);
    document.array(lane_name("broken", frame.lane, lanes), fields.broken);
  }
  document.xml += "      </CellData>\n      <Points>\n";
  document.array("Points", geometry.position);
  document.xml += "      </Points>\n";
  write_topology(document, geometry);
  document.xml += "    </Piece>\n  </PolyData>\n  <AppendedData encoding=\"raw\">\n_";
  base::write_whole_file(path, document.xml + document.appended + "\n  </AppendedData>\n</VTKFile>\n");
}

}  // namespace rift::results
