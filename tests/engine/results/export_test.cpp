#include "engine/results/export.hpp"

#include "engine/base/ownership.hpp"
#include "engine/base/world_error.hpp"
#include "engine/results/journal.hpp"
#include "tests/engine/results/small_run.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <map>

namespace rift::results {
namespace {

namespace fs = std::filesystem;

/// A reader of its own for .vtp files: knows the VTK XML rules and nothing of how ours are written.
struct Vtp {
  struct Array {
    std::string type, section;
    int components = 0;
    std::string bytes;
    template <typename T>
    [[nodiscard]] std::vector<T> as() const {
      std::vector<T> values(bytes.size() / sizeof(T));
      std::memcpy(values.data(), bytes.data(), bytes.size());
      return values;
    }
  };
  std::map<std::string, std::string> piece, file;
  std::map<std::string, Array> arrays;  // by section/name
};

std::map<std::string, std::string> attributes_of(const std::string& tag) {
  std::map<std::string, std::string> attributes;
  for (std::size_t at = 0, equal; (equal = tag.find("=\"", at)) != std::string::npos;) {
    const std::size_t space = tag.rfind(' ', equal);
    const std::size_t end = tag.find('"', equal + 2);
    attributes[tag.substr(space + 1, equal - space - 1)] = tag.substr(equal + 2, end - equal - 2);
    at = end + 1;
  }
  return attributes;
}

Vtp parse_vtp(const fs::path& path) {
  const auto text = read_text(path);
  const auto data = text.find('_', text.find("<AppendedData encoding=\"raw\">")) + 1;
  Vtp vtp;
  std::string section;
  for (std::size_t at = 0; (at = text.find('<', at)) < data;) {
    const std::size_t end = text.find('>', at);
    const auto tag = text.substr(at + 1, end - at - 1);
    const auto name = tag.substr(0, tag.find_first_of(" /"));
    at = end;
    auto attributes = attributes_of(tag);
    if (name == "VTKFile") vtp.file = attributes;
    if (name == "Piece") vtp.piece = attributes;
    if (name != "DataArray") {
      if (!name.empty()) section = name;
      continue;
    }
    EXPECT_EQ(attributes["format"], "appended");
    const std::size_t from = data + std::stoull(attributes["offset"]);
    std::uint64_t size = 0;
    std::memcpy(&size, text.data() + from, sizeof(size));
    EXPECT_LE(from + 8 + size, text.size());
    vtp.arrays[section + "/" + attributes["Name"]] = {attributes["type"], section,
                                                      std::stoi(attributes["NumberOfComponents"]),
                                                      text.substr(from + 8, size)};
  }
  EXPECT_NE(text.find("</AppendedData>\n</VTKFile>"), std::string::npos);
  return vtp;
}

TEST(ExportPvd, AFrameReadsBackWhole) {
  const TemporaryFolder scratch;
  small_run::write_journal(scratch.path(), {RunHeader{"{}"}, small_run::geometry(), small_run::frame(1, 0)});
  EXPECT_EQ(export_pvd(scratch.path()), scratch / "pvd/run.pvd");
  auto vtp = parse_vtp(scratch / "pvd/frame_000000.vtp");

  EXPECT_EQ(vtp.file["type"], "PolyData");
  EXPECT_EQ(vtp.file["header_type"], "UInt64");
  EXPECT_EQ(vtp.file["byte_order"], "LittleEndian");
  EXPECT_EQ(vtp.piece["NumberOfPoints"], "4");
  EXPECT_EQ(vtp.piece["NumberOfVerts"], "4");
  EXPECT_EQ(vtp.piece["NumberOfLines"], "3");
  EXPECT_EQ(vtp.piece["NumberOfPolys"], "0");
  EXPECT_EQ(vtp.piece["NumberOfStrips"], "0");

  EXPECT_EQ(vtp.arrays["Points/Points"].as<float>(),
            (std::vector<float>{0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0.5F, 0.25F}));
  EXPECT_EQ(vtp.arrays["Points/Points"].components, 3);
  using Ids = std::vector<std::int64_t>;
  EXPECT_EQ(vtp.arrays["Verts/connectivity"].type, "Int64");
  EXPECT_EQ(vtp.arrays["Verts/connectivity"].as<std::int64_t>(), (Ids{0, 1, 2, 3}));
  EXPECT_EQ(vtp.arrays["Verts/offsets"].as<std::int64_t>(), (Ids{1, 2, 3, 4}));
  EXPECT_EQ(vtp.arrays["Lines/connectivity"].as<std::int64_t>(), (Ids{0, 1, 1, 2, 2, 3}));
  EXPECT_EQ(vtp.arrays["Lines/offsets"].as<std::int64_t>(), (Ids{2, 4, 6}));

  EXPECT_EQ(vtp.arrays["PointData/radius"].as<float>(), small_run::geometry().radius);
  const auto displacement = vtp.arrays["PointData/displacement"].as<float>();
  ASSERT_EQ(displacement.size(), 12U);
  EXPECT_EQ(displacement[10], 103.25F) << "element 3, y";
  EXPECT_EQ(vtp.arrays["PointData/displacement"].components, 3);
  EXPECT_EQ(vtp.arrays["PointData/velocity"].as<float>()[0], -100.0F);
  EXPECT_EQ(vtp.arrays["PointData/elastic_energy"].as<float>(), small_run::frame(1, 0).elastic_energy);
  EXPECT_EQ(vtp.arrays["CellData/damage_factor"].as<float>(), (std::vector<float>{1, 1, 1, 1, 1, 0.25F, 0}));
  EXPECT_EQ(vtp.arrays["CellData/broken"].type, "UInt8");
  EXPECT_EQ(vtp.arrays["CellData/broken"].as<std::uint8_t>(),
            (std::vector<std::uint8_t>{0, 0, 0, 0, 0, 0, 1}));
}

TEST(ExportVtkhdf, IsTheRunsOwnOrMadeOfWhatIsWhole) {
  const TemporaryFolder scratch;
  small_run::write_journal(scratch.path(), {RunHeader{"{}"}, small_run::geometry(), small_run::frame(1, 0)});
  EXPECT_EQ(export_vtkhdf(scratch.path()), scratch / "paraview/run.vtkhdf");
  EXPECT_GT(fs::file_size(scratch / "paraview/run.vtkhdf"), 1000U);
  EXPECT_FALSE(fs::exists(scratch / "run.vtkhdf")) << "that is of a run that has ended";
  const TemporaryFolder finished;
  small_run::write_journal(finished.path(),
                           {RunHeader{"{}"}, small_run::geometry(), small_run::frame(1, 0), RunEnd{"{}"}});
  write_text(finished / "run.vtkhdf", "its own");
  EXPECT_EQ(export_vtkhdf(finished.path()), finished / "run.vtkhdf");
  EXPECT_EQ(read_text(finished / "run.vtkhdf"), "its own");
  fs::create_directories(finished / "paraview");
  write_text(finished / "paraview/run.vtkhdf", "of the run before it had ended");
  EXPECT_EQ(export_vtkhdf(finished.path()), finished / "run.vtkhdf");
  EXPECT_FALSE(fs::exists(finished / "paraview/run.vtkhdf"));
}

TEST(ExportPvd, TheCollectionNamesEachMomentAndItsTime) {
  const TemporaryFolder scratch;
  small_run::write_journal(
      scratch.path(), {RunHeader{"{}"}, small_run::geometry(), small_run::frame(0, 0), small_run::frame(0, 1),
                       small_run::frame(3, 0), small_run::frame(3, 1)});
  const auto text = read_text(export_pvd(scratch.path()));
  EXPECT_NE(text.find("<VTKFile type=\"Collection\""), std::string::npos);
  EXPECT_NE(text.find("timestep=\"0\" group=\"\" part=\"0\" file=\"frame_000000.vtp\""), std::string::npos)
      << text;
  EXPECT_NE(text.find("timestep=\"3e-06\" group=\"\" part=\"0\" file=\"frame_000001.vtp\""),
            std::string::npos)
      << text;
  EXPECT_FALSE(fs::exists(scratch / "pvd/frame_000002.vtp"));
  const auto vtp = parse_vtp(scratch / "pvd/frame_000001.vtp");
  EXPECT_EQ(vtp.arrays.at("PointData/displacement_lane1").as<float>()[0], 310.0F);
  EXPECT_EQ(vtp.arrays.at("CellData/broken_lane0").as<std::uint8_t>().size(), 7U);
}

TEST(ExportPvd, LeavesNoFrameOfAnEarlierExport) {
  const TemporaryFolder scratch;
  fs::create_directories(scratch / "pvd");
  write_text(scratch / "pvd/frame_000007.vtp", "earlier");
  write_text(scratch / "pvd/notes.txt", "mine");
  small_run::write_journal(scratch.path(), {RunHeader{"{}"}, small_run::geometry(), small_run::frame(0, 0)});
  export_pvd(scratch.path());
  EXPECT_TRUE(fs::exists(scratch / "pvd/frame_000000.vtp"));
  EXPECT_FALSE(fs::exists(scratch / "pvd/frame_000007.vtp"));
  EXPECT_TRUE(fs::exists(scratch / "pvd/notes.txt"));
}

TEST(Export, IntoAFolderThatAnotherProcessWritesIsRefused) {
  const TemporaryFolder scratch;
  small_run::write_journal(scratch.path(), {RunHeader{"{}"}, small_run::geometry(), small_run::frame(0, 0)});
  fs::create_directories(scratch / "csv");
  const base::FolderLock lock(scratch / "csv");
  EXPECT_THROW(export_csv(scratch.path()), base::WorldError);
}

TEST(ExportPvd, WithoutFramesShowsTheGeometry) {
  const TemporaryFolder scratch;
  small_run::write_journal(scratch.path(), {RunHeader{"{}"}, small_run::geometry()});
  export_pvd(scratch.path());
  const auto vtp = parse_vtp(scratch / "pvd/frame_000000.vtp");
  EXPECT_EQ(vtp.arrays.at("PointData/radius").as<float>().size(), 4U);
  EXPECT_FALSE(vtp.arrays.contains("PointData/displacement"));
}

TEST(ExportCsv, WritesEachTable) {
  const TemporaryFolder scratch;
  auto loading = small_run::sample(0, 0, 0.01);
  loading.phase = Phase::loading;
  small_run::write_journal(scratch.path(),
                           {RunHeader{"{}"}, small_run::geometry(), loading, small_run::sample(2, 0, 0.02),
                            ReleaseEvent{2, 0, 2e-8, 0.015, 3e-9, 0.014, 0.02, 0.75},
                            RateCurve{0, {{0.02, 0.5, 0.25, 0.625, 0.75}}}});
  EXPECT_EQ(export_csv(scratch.path()), scratch / "csv");
  EXPECT_EQ(read_text(scratch / "csv/events.csv"),
            "beam,lane,time_s,position_m,energy_j,x_m,y_m,tension\n2,0,2e-08,0.015,3e-09,0.014,0.02,0.75\n");
  EXPECT_EQ(read_text(scratch / "csv/rate.csv"),
            "lane,tip_m,ratio,ratio_fracture,ratio_paper,ratio_difference\n0,0.02,0.5,0.25,0.625,"
            "0.75\n");
  EXPECT_EQ(read_text(scratch / "csv/crack.csv"),
            "step,time_s,lane,tip_m,velocity_m_s\n2,2e-08,0,0.02,1100.1\n");
  const auto series = read_text(scratch / "csv/series.csv");
  EXPECT_NE(series.find("\n0,0,loading,0,0.01,"), std::string::npos) << series;
  EXPECT_TRUE(series.ends_with(",0.5,0.25,0.625,0.75\n")) << series;
}

TEST(Export, SaysWhatIsMissing) {
  const TemporaryFolder scratch;
  try {
    export_csv(scratch.path());
    FAIL() << "exported nothing";
  } catch (const base::WorldError& error) {
    EXPECT_EQ(error.what(),
              "cannot open " + (scratch / "journal.rift").string() + ": No such file or directory");
  }
  EXPECT_FALSE(fs::exists(scratch / "csv"));
  small_run::write_journal(scratch.path(), {RunHeader{"{}"}});
  EXPECT_THROW(export_pvd(scratch.path()), base::WorldError);
}

TEST(Export, WorksFromARunThatWasCutShort) {
  const TemporaryFolder scratch;
  small_run::write_journal(scratch.path(), {RunHeader{"{}"}, small_run::geometry(), small_run::frame(0, 0),
                                            small_run::frame(1, 0)});
  const auto bytes = read_text(scratch / "journal.rift");
  write_text(scratch / "journal.rift", bytes.substr(0, bytes.size() - 1));
  export_pvd(scratch.path());
  EXPECT_TRUE(fs::exists(scratch / "pvd/frame_000000.vtp"));
  EXPECT_FALSE(fs::exists(scratch / "pvd/frame_000001.vtp"));
}

}  // namespace
}  // namespace rift::results
