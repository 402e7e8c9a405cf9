#include "engine/results/archive.hpp"

#include "engine/base/files.hpp"
#include "engine/base/ownership.hpp"
#include "engine/base/text.hpp"
#include "engine/base/world_error.hpp"
#include "engine/results/hdf5.hpp"
#include "engine/results/journal_index.hpp"
#include "engine/results/json_input.hpp"
#include "engine/results/records.hpp"
#include "engine/results/run_folder.hpp"
#include "engine/results/series.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace rift::results {
namespace {

using hdf5::Group;
using hdf5::Growing;
using hdf5::Numbers;

template <typename T, std::size_t K>
std::span<const T> flat(const std::vector<std::array<T, K>>& rows) {
  return {rows.empty() ? nullptr : rows.front().data(), rows.size() * K};
}

/// Chunks of at most 64 Ki rows that divide a frame as evenly as can be.
std::size_t chunk_rows(std::size_t frame_rows) {
  const std::size_t parts = frame_rows / 65536 + 1;
  return (frame_rows + parts - 1) / parts;
}

/// `cells` cells of `size` points each, numbered as in `connectivity`.
void write_topology(Group& vtk, const std::string& name, std::int64_t cells, std::int64_t size,
                    const std::vector<std::int64_t>& connectivity) {
  auto group = vtk.group(name);
  group.write("NumberOfCells", std::vector{cells});
  group.write("NumberOfConnectivityIds", std::vector{static_cast<std::int64_t>(connectivity.size())});
  group.write("Connectivity", connectivity);
  std::vector<std::int64_t> offsets(static_cast<std::size_t>(cells) + 1);
  for (std::size_t i = 0; i < offsets.size(); ++i) offsets[i] = static_cast<std::int64_t>(i) * size;
  group.write("Offsets", offsets);
}

/// Elements as points with a vertex each, beams as lines; stored once, whatever the number of steps.
void write_geometry(Group& vtk, const Geometry& geometry) {
  vtk.attribute("Version", std::vector<std::int64_t>{2, 0});
  vtk.ascii_attribute("Type", "PolyData");
  const auto elements = static_cast<std::int64_t>(geometry.position.size());
  vtk.write("NumberOfPoints", std::vector{elements});
  vtk.write("Points", flat(geometry.position), 3);

  std::vector<std::int64_t> vertices(geometry.position.size());
  std::iota(vertices.begin(), vertices.end(), 0);
  const auto ends = flat(geometry.beam);
  write_topology(vtk, "Vertices", elements, 1, vertices);
  write_topology(vtk, "Lines", static_cast<std::int64_t>(geometry.beam.size()), 2,
                 {ends.begin(), ends.end()});
  write_topology(vtk, "Polygons", 0, 0, {});
  write_topology(vtk, "Strips", 0, 0, {});
}

/// One array over time: the rows of all its steps on end, and where each step's rows begin.
struct TimeField {
  Growing rows;
  std::vector<std::int64_t> offsets;

  /// Steps of which nothing was heard show the last rows before them, or else the first there will be.
  void pad(std::size_t steps) { offsets.resize(steps, offsets.empty() ? 0 : offsets.back()); }
  void append(std::size_t step, const Numbers& values) {
    pad(step);
    offsets.push_back(static_cast<std::int64_t>(rows.rows()));
    rows.append(values);
  }
};

/// The arrays of PointData or of CellData, each made when its first values come.
class TimeFields {
 public:
  TimeFields(Group& group, std::size_t step_rows, std::size_t columns)
      : group_(group), step_rows_(step_rows), columns_(columns) {}

  void append(const std::string& name, std::size_t step, const Numbers& values) {
    auto field = fields_.find(name);
    if (field == fields_.end()) {
      auto rows = group_.growing(name, values.type, chunk_rows(step_rows_), columns_);
      field = fields_.emplace(name, TimeField{std::move(rows), {}}).first;
    }
    field->second.append(step, values);
  }
  void write_offsets(Group& offsets, std::size_t steps) {
    for (auto& [name, field] : fields_) {
      field.pad(steps);
      offsets.write(name, field.offsets);
    }
  }

 private:
  Group& group_;
  std::size_t step_rows_;
  std::size_t columns_;
  std::map<std::string, TimeField> fields_;
};

/// The Steps group of a mesh that never changes: all its offsets stay at the one copy there is.
void write_steps(Group& steps, const std::vector<double>& times) {
  const std::size_t count = times.size();
  steps.attribute("NSteps", static_cast<std::int64_t>(count));
  steps.write("Values", times);
  steps.write("NumberOfParts", std::vector<std::int64_t>(count, 1));
  for (const char* name : {"PartOffsets", "PointOffsets"})
    steps.write(name, std::vector<std::int64_t>(count, 0));
  const std::vector<std::int64_t> per_topology(4 * count, 0);  // vertices, lines, polygons, strips
  for (const char* name : {"CellOffsets", "ConnectivityIdOffsets"}) steps.write(name, per_topology, 4);
}

void write_vtkhdf(Group& root, const std::filesystem::path& journal, const JournalScan& scan) {
  const auto& geometry = *scan.geometry;
  auto vtk = root.group("VTKHDF");
  write_geometry(vtk, geometry);
  auto point_data = vtk.group("PointData");
  auto cell_data = vtk.group("CellData");
  point_data.write("radius", geometry.radius);
  if (scan.frames == 0) return;

  const std::size_t cells = geometry.position.size() + geometry.beam.size();
  TimeFields vectors(point_data, geometry.position.size(), 3),
      numbers(point_data, geometry.position.size(), 0), of_cells(cell_data, cells, 0);
  std::vector<double> times;
  for_each_moment(journal, geometry, [&](std::span<const Frame> frames) {
    const std::size_t step = times.size();
    times.push_back(frames.front().time_s);
    for (const auto& frame : frames) {
      const auto name = [&](const char* field) { return lane_name(field, frame.lane, scan.lanes); };
      if (!frame.displacement.empty()) vectors.append(name("displacement"), step, flat(frame.displacement));
      if (!frame.velocity.empty()) vectors.append(name("velocity"), step, flat(frame.velocity));
      if (!frame.rotation.empty()) vectors.append(name("rotation"), step, flat(frame.rotation));
      if (!frame.elastic_energy.empty()) numbers.append(name("elastic_energy"), step, frame.elastic_energy);
      if (frame.damage_factor.empty()) continue;
      const auto spread = cell_fields(geometry, frame);
      of_cells.append(name("damage_factor"), step, spread.damage_factor);
      of_cells.append(name("broken"), step, spread.broken);
    }
  });

  auto steps = vtk.group("Steps");
  write_steps(steps, times);
  auto point_offsets = steps.group("PointDataOffsets");
  auto cell_offsets = steps.group("CellDataOffsets");
  point_offsets.write("radius", std::vector<std::int64_t>(times.size(), 0));
  vectors.write_offsets(point_offsets, times.size());
  numbers.write_offsets(point_offsets, times.size());
  of_cells.write_offsets(cell_offsets, times.size());
}

/// One member of each row, as a dataset.
template <typename Rows, typename Get>
void write_member(Group& group, const std::string& name, const Rows& rows, Get get) {
  std::vector<std::decay_t<decltype(std::invoke(get, rows.front()))>> values;
  values.reserve(rows.size());
  for (const auto& row : rows) values.push_back(std::invoke(get, row));
  group.write(name, values);
}

template <typename Rows, typename Columns>
void write_columns(Group& group, const Rows& rows, const Columns& columns) {
  for (const auto& column : columns) write_member(group, column.name, rows, column.value);
}

void write_series(Group& root, const JournalScan& scan) {
  auto series = root.group("series");
  write_member(series, "step", scan.samples, &Sample::step);
  write_member(series, "time_s", scan.samples, &Sample::time_s);
  write_member(series, "phase", scan.samples,
               [](const Sample& s) { return static_cast<std::uint8_t>(s.phase); });
  write_member(series, "lane", scan.samples, &Sample::lane);
  write_columns(series, scan.samples, sample_columns);
  const auto matched = match_rates(scan.samples, scan.rates);
  for (const auto& column : rate_columns)
    write_member(series, column.name, matched, [&](const RatePoint* point) {
      return point ? point->*column.value : std::numeric_limits<double>::quiet_NaN();
    });
}

void write_crack(Group& root, const JournalScan& scan) {
  auto crack = root.group("crack");
  std::map<std::int32_t, const RateCurve*>
      last;  // where a lane's curve was computed again, the later one holds
  for (const auto& curve : scan.rates) last[curve.lane] = &curve;
  for (const auto& [lane, curve] : last) {
    auto group = crack.group(fmt::format("lane{}", lane));
    write_member(group, "tip_m", curve->points, &RatePoint::tip_m);
    write_columns(group, curve->points, rate_columns);
  }
}

void write_events(Group& root, const JournalScan& scan) {
  auto events = root.group("events");
  write_member(events, "beam", scan.events, &ReleaseEvent::beam);
  write_member(events, "lane", scan.events, &ReleaseEvent::lane);
  write_columns(events, scan.events, event_columns);
}

void write_gauges(Group& root, const JournalScan& scan) {
  if (scan.gauges.empty()) return;
  auto gauges = root.group("gauges");
  write_member(gauges, "step", scan.gauges, &GaugeRow::step);
  write_member(gauges, "time_s", scan.gauges, &GaugeRow::time_s);
  write_member(gauges, "lane", scan.gauges, &GaugeRow::lane);
  write_member(gauges, "gauge", scan.gauges, &GaugeRow::gauge);
  write_columns(gauges, scan.gauges, gauge_columns);
}

/// What it takes to rebuild the run: elements, beams with their ends, axes and lengths, the crack's beams.
void write_lattice(Group& scene, const JournalScan& scan) {
  const Mechanics& m = scan.mechanics;
  const Geometry& geometry = *scan.geometry;
  if (m.centre.size() != geometry.position.size() || m.axial.size() != geometry.beam.size() || m.centre.empty())
    return;
  std::vector<std::array<double, 3>> axis;
  std::vector<double> length;
  for (const auto& [i, j] : geometry.beam) {
    std::array<double, 3> n{};
    for (int c = 0; c < 3; ++c) n[c] = m.centre[j][c] - m.centre[i][c];
    length.push_back(std::hypot(n[0], n[1], n[2]));
    for (double& component : n) component /= length.back();
    axis.push_back(n);
  }
  auto lattice = scene.group("lattice");
  lattice.write("centre_m", flat(m.centre), 3);
  lattice.write("radius_m", m.radius);
  lattice.write("mass_kg", m.mass);
  lattice.write("inertia_kg_m2", m.inertia);
  lattice.write("grip", m.grip);
  lattice.write("ends", flat(geometry.beam), 2);
  lattice.write("axis", flat(axis), 3);
  lattice.write("length_m", length);
  lattice.write("axial_n_m", m.axial);
  lattice.write("bending_n_m", m.bending);
  lattice.write("twist_n_m", m.twist);
  // Of beams that break by themselves no path says where the tip meets them.
  if (m.crossing_position.size() != geometry.crossing.size()) return;
  lattice.write("crossing", geometry.crossing);
  lattice.write("crossing_position_m", m.crossing_position);
}

/// Each entry of the header as a text of its own, numbers and nested entries as JSON.
void write_scene(Group& root, const JournalScan& scan) {
  auto scene = root.group("scene");
  const auto header = json_or_discarded<nlohmann::json>(scan.header_json);
  if (header.is_object()) {
    for (const auto& [key, value] : header.items()) {
      std::string name = key;
      std::replace_if(
          name.begin(), name.end(), [](char c) { return c == '/' || c == '.'; }, '_');
      if (name.empty() || name == "header" || name == "summary" || name == "lattice") continue;
      scene.write_text(name, value.is_string() ? value.get<std::string>() : base::json_text(value));
    }
  }
  scene.write_text("header", scan.header_json);
  write_lattice(scene, scan);
  if (scan.summary_json) scene.write_text("summary", *scan.summary_json);
}

}  // namespace

void assemble_archive(const std::filesystem::path& run_folder, const std::filesystem::path& target) {
  const auto journal = run_folder / journal_name;
  const base::HeldFile held(journal);
  const auto scan = scan_journal(journal);
  if (!scan.geometry) throw base::WorldError("assemble an archive from", journal, "it holds no geometry");

  base::PendingFile pending(target.empty() ? run_folder / archive_name : target);
  hdf5::File file(pending.temporary());
  {
    auto root = file.root();
    write_vtkhdf(root, journal, scan);
    write_series(root, scan);
    write_crack(root, scan);
    write_events(root, scan);
    write_gauges(root, scan);
    write_scene(root, scan);
  }
  file.close();
  check_same_run(held);
  pending.commit();
}

}  // namespace rift::results
