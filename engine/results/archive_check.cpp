#include "engine/results/archive_check.hpp"

#include "engine/base/child_process.hpp"
#include "engine/base/text.hpp"
#include "engine/results/hdf5.hpp"
#include "engine/results/json_input.hpp"
#include "engine/results/series.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <exception>
#include <optional>

namespace rift::results {
namespace {

using hdf5::InputFile;
using hdf5::Stored;

/// One look at one archive; what is wrong is noted and the rest looked at all the same.
class Inspection {
 public:
  explicit Inspection(const InputFile& file) : file_(file), contents_(file.contents()) {}

  ArchiveCheck all() {
    read_everything();
    look_at("the geometry", [&] { geometry(); });
    look_at("the steps", [&] { steps(); });
    look_at("the series", [&] { check_.samples = table("series", series_columns()); });
    look_at("the events", [&] { events(); });
    look_at("the rates", [&] { rates(); });
    look_at("the gauges", [&] { gauges(); });
    look_at("the lattice", [&] { lattice(); });
    require(contents_.count("scene/header") != 0, "scene/header is missing");
    return std::move(check_);
  }

 private:
  void require(bool holds, const std::string& problem) {
    if (!holds) check_.problems.push_back(problem);
  }

  template <class Look>
  void look_at(const char* what, const Look& look) try {
    look();
  } catch (const std::exception& error) {
    check_.problems.push_back(fmt::format("{}: {}", what, error.what()));
  }

  void read_everything() {
    for (const auto& entry : contents_)
      look_at(entry.first.c_str(), [&] { check_.digest[entry.first] = file_.digest(entry.first); });
  }

  const Stored* find(const std::string& name) const {
    const auto found = contents_.find(name);
    return found == contents_.end() ? nullptr : &found->second;
  }
  /// Rows of a dataset that must be there, of so many columns; -1 where it is not such a one.
  std::int64_t rows(const std::string& name, std::uint64_t columns = 1) {
    const Stored* stored = find(name);
    require(stored != nullptr, name + " is missing");
    if (!stored) return -1;
    const bool fits = stored->shape.size() == (columns == 1 ? 1 : 2) && stored->columns() == columns;
    require(fits, fmt::format("{} has another shape than an archive's", name));
    return fits ? static_cast<std::int64_t>(stored->rows()) : -1;
  }
  /// The only number of a dataset.
  std::int64_t number(const std::string& name) {
    const std::vector<std::int64_t> values =
        rows(name) == 1 ? file_.integers(name) : std::vector<std::int64_t>{};
    require(values.size() == 1, name + " is not one number");
    return values.size() == 1 ? values.front() : -1;
  }
  void expect_rows(const std::string& name, std::int64_t expected, std::uint64_t columns = 1) {
    const std::int64_t seen = rows(name, columns);
    require(seen < 0 || seen == expected, fmt::format("{} has {} rows in place of {}", name, seen, expected));
  }
  void expect_within(const std::string& name, std::int64_t end) {
    if (!find(name)) return;
    for (const std::int64_t k : file_.integers(name))
      if (k < 0 || k >= end)
        return require(false, fmt::format("{} points to {}, outside of [0, {})", name, k, end));
  }

  void geometry() {
    const std::vector<std::int64_t> version = file_.attribute("VTKHDF", "Version");
    require(version.size() == 2 && version[0] == 2, "/VTKHDF is not of version 2");
    require(file_.text_attribute("VTKHDF", "Type") == "PolyData", "/VTKHDF is not of type PolyData");
    check_.elements = rows("VTKHDF/Points", 3);
    require(number("VTKHDF/NumberOfPoints") == check_.elements, "NumberOfPoints is not that of Points");
    expect_rows("VTKHDF/PointData/radius", check_.elements);
    for (const char* kind : {"Vertices", "Lines", "Polygons", "Strips"}) cells(std::string("VTKHDF/") + kind);
    check_.beams = number("VTKHDF/Lines/NumberOfCells");
  }

  void cells(const std::string& kind) {
    const std::int64_t cells = number(kind + "/NumberOfCells");
    const std::int64_t ids = number(kind + "/NumberOfConnectivityIds");
    expect_rows(kind + "/Connectivity", ids);
    expect_within(kind + "/Connectivity", check_.elements);
    const std::int64_t ends = rows(kind + "/Offsets");
    require(cells >= 0 && ends - 1 == cells, kind + "/Offsets are not one more than the cells");
    expect_within(kind + "/Offsets", ids + 1);
  }

  void steps() {
    const bool changing = find("VTKHDF/Steps/Values") != nullptr;
    if (changing) {
      check_.moments = rows("VTKHDF/Steps/Values");
      const std::vector<std::int64_t> said = file_.attribute("VTKHDF/Steps", "NSteps");
      require(said.size() == 1 && said[0] == check_.moments, "Steps@NSteps is not that of its Values");
    }
    const std::int64_t cells = check_.elements + check_.beams;
    for (const auto& [name, stored] : contents_) {
      fields(name, stored, "PointData/", check_.elements);
      fields(name, stored, "CellData/", cells);
    }
  }

  /// A field over time holds whole frames, and its offsets point at them.
  void fields(const std::string& name, const Stored& stored, const std::string& group,
              std::int64_t per_frame) {
    const std::string prefix = "VTKHDF/" + group;
    if (!name.starts_with(prefix) || name == "VTKHDF/PointData/radius") return;
    const auto all = static_cast<std::int64_t>(stored.rows());
    require(per_frame > 0 && all % per_frame == 0, name + " does not hold whole frames");
    std::string offsets = "VTKHDF/Steps/" + group;
    offsets.insert(offsets.size() - 1, "Offsets");
    offsets += name.substr(prefix.size());
    expect_rows(offsets, check_.moments);
    expect_within(offsets, all - per_frame + 1);
  }

  /// Older archives lack the columns that came last.
  std::vector<std::string> series_columns() const {
    std::vector<std::string> names{"step", "time_s", "phase", "lane"};
    for (const auto& column : sample_columns)
      if ((column.value != &Sample::contact_j && column.value != &Sample::grip_force_n) ||
          contents_.contains(std::string("series/") + column.name))
        names.emplace_back(column.name);
    for (const auto& column : rate_columns) names.emplace_back(column.name);
    return names;
  }

  /// Columns of one length, which is returned.
  std::int64_t table(const std::string& group, const std::vector<std::string>& columns) {
    const std::int64_t length = rows(group + "/" + columns.front());
    for (const std::string& column : columns) expect_rows(fmt::format("{}/{}", group, column), length);
    return length;
  }

  void events() {
    std::vector<std::string> columns{"beam", "lane"};
    for (const auto& column : event_columns) {
      const bool since_later = column.value == &ReleaseEvent::x_m || column.value == &ReleaseEvent::y_m ||
                               column.value == &ReleaseEvent::tension;
      if (!since_later || contents_.contains(std::string("events/") + column.name))
        columns.emplace_back(column.name);
    }
    check_.events = table("events", columns);
    expect_within("events/beam", check_.beams);
  }

  void rates() {
    std::vector<std::string> columns{"tip_m"};
    for (const auto& column : rate_columns) columns.emplace_back(column.name);
    std::string last;
    for (const auto& [name, stored] : contents_) {
      if (!name.starts_with("crack/") || name.rfind('/') <= 6) continue;
      const std::string lane = name.substr(0, name.rfind('/'));
      if (lane != std::exchange(last, lane)) table(lane, columns);
    }
  }

  /// Only where the scene has any.
  void gauges() {
    if (!contents_.contains("gauges/step")) return;
    std::vector<std::string> columns{"step", "time_s", "lane", "gauge"};
    for (const auto& column : gauge_columns) columns.emplace_back(column.name);
    table("gauges", columns);
  }

  /// Archives of rift 0.1 have none.
  void lattice() {
    if (!contents_.contains("scene/lattice/centre_m")) return;
    const std::string group = "scene/lattice/";
    expect_rows(group + "centre_m", check_.elements, 3);
    for (const char* name : {"radius_m", "mass_kg", "inertia_kg_m2", "grip"})
      expect_rows(group + name, check_.elements);
    expect_rows(group + "ends", check_.beams, 2);
    expect_rows(group + "axis", check_.beams, 3);
    for (const char* name : {"length_m", "axial_n_m", "bending_n_m", "twist_n_m"})
      expect_rows(group + name, check_.beams);
    expect_within(group + "ends", check_.elements);
    if (!contents_.contains(group + "crossing")) return;
    expect_within(group + "crossing", check_.beams);
    expect_rows(group + "crossing_position_m", rows(group + "crossing"));
  }

  const InputFile& file_;
  const std::map<std::string, Stored> contents_;
  ArchiveCheck check_;
};

}  // namespace

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ArchiveCheck, problems, digest, moments, samples, events, elements, beams)

ArchiveCheck check_archive(const std::filesystem::path& path) try {
  const InputFile file(path);
  return Inspection(file).all();
} catch (const std::exception& error) {
  return {{error.what()}, {}};
}

ArchiveCheck check_archive_in_child(const std::filesystem::path& path, unsigned seconds) {
  const base::SandboxResult result =
      base::run_in_sandbox([&] { return base::json_text(nlohmann::json(check_archive(path))); }, seconds);
  if (result.text) return json_or_discarded(*result.text).get<ArchiveCheck>();
  return {{fmt::format("reading {} was given up: {}", path.string(), result.death)}, {}};
}

}  // namespace rift::results
