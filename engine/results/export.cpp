#include "engine/results/export.hpp"

#include "engine/base/files.hpp"
#include "engine/base/ownership.hpp"
#include "engine/base/world_error.hpp"
#include "engine/results/archive.hpp"
#include "engine/results/journal_index.hpp"
#include "engine/results/records.hpp"
#include "engine/results/run_folder.hpp"
#include "engine/results/series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <numeric>
#include <set>
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
    if (!frame.rotation.empty()) document.array(lane_name("rotation", frame.lane, lanes), frame.rotation);
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

namespace {

namespace fs = std::filesystem;
using Vector = std::array<float, 3>;

Vector deformed(const Geometry& geometry, const Frame& frame, std::size_t i) {
  Vector p = geometry.position[i];
  for (int axis = 0; axis < 3 && !frame.displacement.empty(); ++axis) p[axis] += frame.displacement[i][axis];
  return p;
}

/// Free boundaries that hold all elements as deformed.
std::string box_of(const Geometry& geometry, const Frame& frame) {
  Vector low{1e30F, 1e30F, 1e30F}, high{-1e30F, -1e30F, -1e30F};
  for (std::size_t i = 0; i < geometry.position.size(); ++i) {
    const Vector p = deformed(geometry, frame, i);
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], p[axis] - geometry.radius[i]);
      high[axis] = std::max(high[axis], p[axis] + geometry.radius[i]);
    }
  }
  std::string text = "ITEM: BOX BOUNDS ff ff ff\n";
  for (int axis = 0; axis < 3; ++axis) text += fmt::format("{} {}\n", low[axis], high[axis]);
  return text;
}

std::string head_of(const Frame& frame, const char* counted, std::size_t count) {
  return fmt::format("ITEM: TIMESTEP\n{}\nITEM: NUMBER OF {}\n{}\n", frame.step, counted, count);
}

std::string numbers(const Vector& v) { return fmt::format(" {} {} {}", v[0], v[1], v[2]); }

std::string atoms_of(const Geometry& geometry, const Frame& frame) {
  std::string text = head_of(frame, "ATOMS", geometry.position.size()) + box_of(geometry, frame);
  text += "ITEM: ATOMS id type radius x y z";
  if (!frame.displacement.empty()) text += " ux uy uz";
  if (!frame.velocity.empty()) text += " vx vy vz";
  if (!frame.elastic_energy.empty()) text += " elastic_energy";
  text += "\n";
  for (std::size_t i = 0; i < geometry.position.size(); ++i) {
    text += fmt::format("{} 1 {}", i + 1, geometry.radius[i]) + numbers(deformed(geometry, frame, i));
    if (!frame.displacement.empty()) text += numbers(frame.displacement[i]);
    if (!frame.velocity.empty()) text += numbers(frame.velocity[i]);
    if (!frame.elastic_energy.empty()) text += fmt::format(" {}", frame.elastic_energy[i]);
    text += "\n";
  }
  return text;
}

std::string beams_of(const Geometry& geometry, const Frame& frame) {
  std::vector<float> factor(geometry.beam.size(), 1.0F);
  for (std::size_t k = 0; k < geometry.crossing.size(); ++k)
    factor[geometry.crossing[k]] = frame.damage_factor[k];
  const auto bearing = std::count_if(factor.begin(), factor.end(), [](float f) { return f > 0; });
  std::string text = head_of(frame, "ENTRIES", static_cast<std::size_t>(bearing)) + box_of(geometry, frame);
  text += "ITEM: ENTRIES index atom1 atom2 factor\n";
  for (std::size_t b = 0; b < factor.size(); ++b)
    if (factor[b] > 0)
      text +=
          fmt::format("{} {} {} {}\n", b + 1, geometry.beam[b][0] + 1, geometry.beam[b][1] + 1, factor[b]);
  return text;
}

void export_lane(const JournalIndex& journal, std::int32_t lane, const fs::path& folder,
                 std::set<std::string>& written) {
  const auto name = [&](const char* stem) {
    return folder / *written.insert(lane_name(stem, lane, journal.lanes()) + ".dump").first;
  };
  const auto& entries = journal.frames(lane);
  base::PendingText atoms(name("run"));
  if (entries.empty()) atoms.append(atoms_of(journal.geometry(), {}));
  for (const FrameEntry& entry : entries) atoms.append(atoms_of(journal.geometry(), journal.frame(entry)));
  atoms.commit();
  if (entries.empty() || journal.frame(entries.front()).damage_factor.empty()) return;
  base::PendingText beams(name("beams"));
  for (const FrameEntry& entry : entries)
    if (const Frame frame = journal.frame(entry); !frame.damage_factor.empty())
      beams.append(beams_of(journal.geometry(), frame));
  beams.commit();
}

}  // namespace

fs::path export_ovito(const fs::path& run_folder) {
  const JournalIndex journal(run_folder / journal_name);
  const fs::path folder = run_folder / "ovito";
  const base::OwnedFolder owned(folder);
  std::set<std::string> written;
  for (std::int32_t lane = 0; lane < journal.lanes(); ++lane) export_lane(journal, lane, folder, written);
  remove_other_exports(folder, "ovito", written);
  return folder;
}

namespace {

std::string events_csv(const JournalScan& scan) {
  std::string text = "beam,lane" + names_of(event_columns) + "\n";
  for (const auto& event : scan.events)
    text += base::csv_fields(event.beam, event.lane) + numbers_of(event, event_columns) + "\n";
  return text;
}

std::string rate_csv(const JournalScan& scan) {
  std::string text = "lane,tip_m" + names_of(rate_columns) + "\n";
  for (const auto& curve : scan.rates)
    for (const auto& point : curve.points)
      text += base::csv_fields(curve.lane, point.tip_m) + numbers_of(point, rate_columns) + "\n";
  return text;
}

std::string crack_csv(const JournalScan& scan) {
  std::string text = "step,time_s,lane,tip_m,velocity_m_s\n";
  for (const auto& sample : scan.samples)
    if (sample.phase == Phase::fracture)
      text += base::csv_row(sample.step, sample.time_s, sample.lane, sample.tip_m, sample.velocity_m_s);
  return text;
}

}  // namespace

fs::path export_csv(const fs::path& run_folder) {
  const auto scan = scan_journal(run_folder / journal_name);
  base::OwnedFolder owned(run_folder / "csv");
  const fs::path& folder = owned.path();
  base::write_whole_file(folder / "series.csv", series_csv(scan.samples, scan.rates));
  base::write_whole_file(folder / "events.csv", events_csv(scan));
  base::write_whole_file(folder / "rate.csv", rate_csv(scan));
  base::write_whole_file(folder / "crack.csv", crack_csv(scan));
  return folder;
}

fs::path export_pvd(const fs::path& run_folder) {
  const auto journal = run_folder / journal_name;
  const base::HeldFile held(journal);
  const auto scan = scan_journal(journal);
  if (!scan.geometry) throw base::WorldError("export", journal, "it holds no geometry");
  base::OwnedFolder owned(run_folder / "pvd");
  const fs::path& folder = owned.path();

  std::string entries;
  std::set<std::string> written{"run.pvd"};
  int count = 0;
  const auto add = [&](double time_s, std::span<const Frame> frames) {
    const auto name = fmt::format("frame_{:06}.vtp", count++);
    write_vtp(folder / name, *scan.geometry, frames, scan.lanes);
    written.insert(name);
    entries +=
        fmt::format("    <DataSet timestep=\"{}\" group=\"\" part=\"0\" file=\"{}\"/>\n", time_s, name);
  };
  for_each_moment(journal, *scan.geometry,
                  [&](std::span<const Frame> frames) { add(frames.front().time_s, frames); });
  if (count == 0) add(0.0, {});
  check_same_run(held);

  const auto collection = folder / "run.pvd";
  base::write_whole_file(
      collection,
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n  <Collection>\n" +
          entries + "  </Collection>\n</VTKFile>\n");
  remove_other_exports(folder, "pvd", written);
  return collection;
}

fs::path export_vtkhdf(const fs::path& run_folder) {
  const RunState state = inspect_run(run_folder);
  if (state.condition == RunCondition::not_a_run) throw base::WorldError("export", run_folder, state.reason);
  if (state.condition == RunCondition::finished && state.has_archive) {
    if (const fs::path former = run_folder / "paraview";
        fs::exists(former))  // of the run before it had ended
      remove_other_exports(base::OwnedFolder(former).path(), "paraview", {});
    return run_folder / archive_name;
  }
  base::OwnedFolder owned(run_folder / "paraview");
  assemble_archive(run_folder, owned.path() / archive_name);
  return owned.path() / archive_name;
}

}  // namespace rift::results
