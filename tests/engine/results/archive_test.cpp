#include "engine/results/archive.hpp"

#include "engine/base/world_error.hpp"
#include "engine/results/journal.hpp"
#include "tests/engine/results/small_run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

// Debian keeps the header of the serial library aside; the archive is read back with the C API itself.
#if __has_include(<hdf5.h>)
#include <hdf5.h>
#else
#include <hdf5/serial/hdf5.h>
#endif

namespace rift::results {
namespace {

namespace fs = std::filesystem;

/// A dataset as it lies in the file.
struct Dataset {
  std::vector<hsize_t> shape;
  H5T_class_t type_class;
  std::size_t type_size;
  std::vector<double> values;
};

class Archive {
 public:
  explicit Archive(const fs::path& folder)
      : file_(H5Fopen((folder / "run.vtkhdf").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)) {
    EXPECT_GE(file_, 0);
  }
  Archive(const Archive&) = delete;
  Archive& operator=(const Archive&) = delete;
  ~Archive() { H5Fclose(file_); }

  [[nodiscard]] hid_t id() const { return file_; }
  [[nodiscard]] bool has(const std::string& path) const {
    for (std::size_t slash = path.find('/', 1);; slash = path.find('/', slash + 1)) {
      if (H5Lexists(file_, path.substr(0, slash).c_str(), H5P_DEFAULT) <= 0) return false;
      if (slash == std::string::npos) return true;
    }
  }
  [[nodiscard]] Dataset dataset(const std::string& path) const {
    Dataset result{};
    if (!has(path)) {
      ADD_FAILURE() << path << " is missing";
      return result;
    }
    const hid_t id = H5Dopen2(file_, path.c_str(), H5P_DEFAULT);
    const hid_t type = H5Dget_type(id);
    const hid_t space = H5Dget_space(id);
    result.type_class = H5Tget_class(type);
    result.type_size = H5Tget_size(type);
    result.shape.resize(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
    H5Sget_simple_extent_dims(space, result.shape.data(), nullptr);
    result.values.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    EXPECT_GE(H5Dread(id, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, result.values.data()), 0) << path;
    H5Sclose(space);
    H5Tclose(type);
    H5Dclose(id);
    return result;
  }
  [[nodiscard]] std::vector<double> values(const std::string& path) const { return dataset(path).values; }
  [[nodiscard]] std::string text(const std::string& path) const {
    const hid_t id = H5Dopen2(file_, path.c_str(), H5P_DEFAULT);
    const hid_t type = H5Dget_type(id);
    std::string text(H5Tget_size(type), '\0');
    H5Dread(id, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data());
    H5Tclose(type);
    H5Dclose(id);
    return text;
  }

 private:
  hid_t file_;
};

using Numbers = std::vector<double>;
using Shape = std::vector<hsize_t>;

/// One lane, three moments.
std::vector<Record> one_lane() {
  return {RunHeader{R"({"version":"0.1.0","preset":"[crack]\n","seed":7,"machine":{"simd":"avx2"}})"},
          small_run::geometry(),
          small_run::frame(0, 0),
          small_run::sample(1, 0, 0.01),
          small_run::frame(1, 0),
          small_run::sample(2, 0, 0.02),
          ReleaseEvent{2, 0, 2e-8, 0.015, 3e-9},
          small_run::frame(2, 0),
          RateCurve{0, {{0.02, 0.5, 0.25, 0.625, 0.75}}},
          RunEnd{R"({"scenarios":[]})"}};
}

TEST(Archive, DeclaresItselfAsVtkhdfAsksFor) {
  const TemporaryFolder scratch;
  small_run::write_journal(scratch.path(), one_lane());
  assemble_archive(scratch.path());
  const Archive archive(scratch.path());

  const hid_t group = H5Gopen2(archive.id(), "/VTKHDF", H5P_DEFAULT);
  const hid_t type = H5Aopen(group, "Type", H5P_DEFAULT);
  const hid_t text_type = H5Aget_type(type);
  EXPECT_EQ(H5Tget_class(text_type), H5T_STRING);
  EXPECT_EQ(H5Tis_variable_str(text_type), 0);
  EXPECT_EQ(H5Tget_cset(text_type), H5T_CSET_ASCII);
  ASSERT_EQ(H5Tget_size(text_type), 8U);
  char text[9] = {};
  H5Aread(type, text_type, text);
  EXPECT_STREQ(text, "PolyData");
  H5Tclose(text_type);
  H5Aclose(type);

  const hid_t version = H5Aopen(group, "Version", H5P_DEFAULT);
  const hid_t space = H5Aget_space(version);
  hsize_t count = 0;
  ASSERT_EQ(H5Sget_simple_extent_ndims(space), 1);
  H5Sget_simple_extent_dims(space, &count, nullptr);
  ASSERT_EQ(count, 2U);
  std::int64_t numbers[2] = {};
  H5Aread(version, H5T_NATIVE_INT64, numbers);
  EXPECT_EQ(numbers[0], 2);
  EXPECT_EQ(numbers[1], 0);
  H5Sclose(space);
  H5Aclose(version);
  H5Gclose(group);
}

TEST(Archive, StoresTheLatticeOnce) {
  const TemporaryFolder scratch;
  small_run::write_journal(scratch.path(), one_lane());
  assemble_archive(scratch.path());
  const Archive archive(scratch.path());

  const auto points = archive.dataset("/VTKHDF/Points");
  EXPECT_EQ(points.shape, (Shape{4, 3}));
  EXPECT_EQ(points.type_class, H5T_FLOAT);
  EXPECT_EQ(points.values, (Numbers{0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0.5, 0.25}));
  EXPECT_EQ(archive.values("/VTKHDF/NumberOfPoints"), Numbers{4});
  EXPECT_EQ(archive.dataset("/VTKHDF/NumberOfPoints").shape, Shape{1});

  const std::map<std::string, std::vector<Numbers>> topologies{
      // cells, connectivity ids, connectivity, offsets
      {"Vertices", {{4}, {4}, {0, 1, 2, 3}, {0, 1, 2, 3, 4}}},
      {"Lines", {{3}, {6}, {0, 1, 1, 2, 2, 3}, {0, 2, 4, 6}}},
      {"Polygons", {{0}, {0}, {}, {0}}},
      {"Strips", {{0}, {0}, {}, {0}}},
  };
  for (const auto& [name, expected] : topologies) {
    SCOPED_TRACE(name);
    std::size_t i = 0;
    for (const char* part : {"NumberOfCells", "NumberOfConnectivityIds", "Connectivity", "Offsets"}) {
      const auto dataset = archive.dataset("/VTKHDF/" + name + "/" + part);
      EXPECT_EQ(dataset.values, expected[i++]) << part;
      EXPECT_EQ(dataset.type_class, H5T_INTEGER) << part;
      EXPECT_EQ(dataset.shape.size(), 1U) << part;
    }
  }
  EXPECT_EQ(archive.dataset("/VTKHDF/PointData/radius").shape, Shape{4});
}

TEST(Archive, StepsLeadToEachMomentsRows) {
  const TemporaryFolder scratch;
  small_run::write_journal(scratch.path(), one_lane());
  assemble_archive(scratch.path());
  const Archive archive(scratch.path());
  const std::string steps = "/VTKHDF/Steps/";

  const hid_t group = H5Gopen2(archive.id(), "/VTKHDF/Steps", H5P_DEFAULT);
  const hid_t attribute = H5Aopen(group, "NSteps", H5P_DEFAULT);
  std::int64_t count = 0;
  H5Aread(attribute, H5T_NATIVE_INT64, &count);
  EXPECT_EQ(count, 3);
  H5Aclose(attribute);
  H5Gclose(group);

  EXPECT_EQ(archive.values(steps + "Values"), (Numbers{0, 1e-6, 2e-6}));
  EXPECT_EQ(archive.values(steps + "NumberOfParts"), (Numbers{1, 1, 1}));
  EXPECT_EQ(archive.values(steps + "PartOffsets"), (Numbers{0, 0, 0}));
  EXPECT_EQ(archive.values(steps + "PointOffsets"), (Numbers{0, 0, 0}));
  for (const char* name : {"CellOffsets", "ConnectivityIdOffsets"}) {
    EXPECT_EQ(archive.dataset(steps + name).shape, (Shape{3, 4})) << name;
    EXPECT_EQ(archive.values(steps + name), Numbers(12, 0.0)) << name;
  }
  EXPECT_EQ(archive.values(steps + "PointDataOffsets/radius"), (Numbers{0, 0, 0}));
  EXPECT_EQ(archive.values(steps + "PointDataOffsets/displacement"), (Numbers{0, 4, 8}));
  EXPECT_EQ(archive.values(steps + "PointDataOffsets/velocity"), (Numbers{0, 4, 8}));
  EXPECT_EQ(archive.values(steps + "CellDataOffsets/damage_factor"), (Numbers{0, 7, 14}));
  EXPECT_EQ(archive.values(steps + "CellDataOffsets/broken"), (Numbers{0, 7, 14}));

  const auto displacement = archive.dataset("/VTKHDF/PointData/displacement");
  ASSERT_EQ(displacement.shape, (Shape{12, 3}));
  EXPECT_EQ(displacement.type_size, 4U);
  EXPECT_EQ(displacement.values[3 * 8 + 1], 200.25) << "step 2, element 0, y";
  EXPECT_EQ(archive.values(steps + "PointDataOffsets/elastic_energy"), (Numbers{0, 4, 8}));
  EXPECT_EQ(archive.dataset("/VTKHDF/PointData/elastic_energy").values[9], 0.5) << "step 2, element 1";
  const auto factor = archive.dataset("/VTKHDF/CellData/damage_factor");
  EXPECT_EQ(factor.shape, Shape{21});
  EXPECT_EQ(Numbers(factor.values.begin(), factor.values.begin() + 14),
            (Numbers{1, 1, 1, 1, 1, 1, 0.5, 1, 1, 1, 1, 1, 0.25, 0}));
  const auto broken = archive.dataset("/VTKHDF/CellData/broken");
  EXPECT_EQ(broken.type_class, H5T_INTEGER);
  EXPECT_EQ(broken.type_size, 1U);
  EXPECT_EQ(Numbers(broken.values.begin(), broken.values.begin() + 14),
            (Numbers{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1}));
}

TEST(Archive, EachLaneHasItsArraysAndTheStepsAreShared) {
  const TemporaryFolder scratch;
  small_run::write_journal(
      scratch.path(), {RunHeader{"{}"}, small_run::geometry(), small_run::frame(0, 0), small_run::frame(0, 1),
                       small_run::frame(1, 0), small_run::frame(2, 0), small_run::frame(2, 1)});
  assemble_archive(scratch.path());
  const Archive archive(scratch.path());
  EXPECT_FALSE(archive.has("/VTKHDF/PointData/displacement"));
  EXPECT_EQ(archive.values("/VTKHDF/Steps/Values").size(), 3U);
  EXPECT_EQ(archive.dataset("/VTKHDF/PointData/displacement_lane0").shape, (Shape{12, 3}));
  EXPECT_EQ(archive.dataset("/VTKHDF/PointData/displacement_lane1").shape, (Shape{8, 3}));
  EXPECT_EQ(archive.values("/VTKHDF/Steps/PointDataOffsets/displacement_lane0"), (Numbers{0, 4, 8}));
  EXPECT_EQ(archive.values("/VTKHDF/Steps/PointDataOffsets/displacement_lane1"), (Numbers{0, 0, 4}))
      << "a lane without a frame shows its last one";
  EXPECT_EQ(archive.values("/VTKHDF/Steps/CellDataOffsets/broken_lane1"), (Numbers{0, 0, 7}));
  EXPECT_EQ(archive.values("/VTKHDF/PointData/displacement_lane1")[12], 210.0) << "step 2, lane 1, element 0";
}

TEST(Archive, HoldsOnlyTheFieldsThatWereAskedFor) {
  const TemporaryFolder scratch;
  auto frame = small_run::frame(1, 0);
  frame.velocity.clear();
  frame.damage_factor.clear();
  auto late = small_run::frame(2, 0);
  late.damage_factor.clear();
  small_run::write_journal(scratch.path(), {small_run::geometry(), frame, late});
  assemble_archive(scratch.path());
  const Archive archive(scratch.path());
  EXPECT_TRUE(archive.has("/VTKHDF/PointData/displacement"));
  EXPECT_FALSE(archive.has("/VTKHDF/CellData/damage_factor"));
  EXPECT_FALSE(archive.has("/VTKHDF/CellData/broken"));
  EXPECT_FALSE(archive.has("/VTKHDF/Steps/CellDataOffsets/broken"));
  EXPECT_EQ(archive.values("/VTKHDF/Steps/PointDataOffsets/velocity"), (Numbers{0, 0}))
      << "one offset a step, also before the field's first rows";
}

TEST(Archive, WithoutFramesIsStatic) {
  const TemporaryFolder scratch;
  small_run::write_journal(scratch.path(), {RunHeader{"{}"}, small_run::geometry()});
  assemble_archive(scratch.path());
  const Archive archive(scratch.path());
  EXPECT_EQ(archive.dataset("/VTKHDF/Points").shape, (Shape{4, 3}));
  EXPECT_TRUE(archive.has("/VTKHDF/PointData/radius"));
  EXPECT_FALSE(archive.has("/VTKHDF/Steps"));
  EXPECT_FALSE(archive.has("/VTKHDF/PointData/displacement"));
}

TEST(Archive, HoldsTheBooksBesideTheMesh) {
  const TemporaryFolder scratch;
  small_run::write_journal(scratch.path(), one_lane());
  assemble_archive(scratch.path());
  const Archive archive(scratch.path());
  EXPECT_EQ(archive.values("/series/step"), (Numbers{1, 2}));
  EXPECT_EQ(archive.values("/series/phase"), (Numbers{2, 2}));
  EXPECT_EQ(archive.values("/series/lane"), (Numbers{0, 0}));
  EXPECT_EQ(archive.values("/series/tip_m"), (Numbers{0.01, 0.02}));
  EXPECT_EQ(archive.values("/series/energy_elastic_j"), Numbers(2, 0.1 + 0.2));
  EXPECT_EQ(archive.values("/series/ledger_residual"), Numbers(2, 5e-12));
  EXPECT_TRUE(std::isnan(archive.values("/series/ratio").at(0)));
  EXPECT_EQ(archive.values("/series/ratio").at(1), 0.5);
  EXPECT_EQ(archive.values("/crack/lane0/tip_m"), Numbers{0.02});
  EXPECT_EQ(archive.values("/crack/lane0/ratio_paper"), Numbers{0.625});
  EXPECT_EQ(archive.values("/events/beam"), Numbers{2});
  EXPECT_EQ(archive.values("/events/lane"), Numbers{0});
  EXPECT_EQ(archive.values("/events/time_s"), Numbers{2e-8});
  EXPECT_EQ(archive.values("/events/position_m"), Numbers{0.015});
  EXPECT_EQ(archive.values("/events/energy_j"), Numbers{3e-9});
  EXPECT_EQ(archive.text("/scene/preset"), "[crack]\n");
  EXPECT_EQ(archive.text("/scene/version"), "0.1.0");
  EXPECT_EQ(archive.text("/scene/seed"), "7");
  EXPECT_EQ(archive.text("/scene/machine"), R"({"simd":"avx2"})");
  EXPECT_EQ(archive.text("/scene/summary"), R"({"scenarios":[]})");
}

TEST(Archive, FieldsOverTimeAreCompressed) {
  const TemporaryFolder scratch;
  small_run::write_journal(scratch.path(), one_lane());
  assemble_archive(scratch.path());
  const Archive archive(scratch.path());
  const hid_t dataset = H5Dopen2(archive.id(), "/VTKHDF/PointData/displacement", H5P_DEFAULT);
  const hid_t creation = H5Dget_create_plist(dataset);
  EXPECT_EQ(H5Pget_layout(creation), H5D_CHUNKED);
  EXPECT_EQ(H5Pget_nfilters(creation), 2);
  H5Pclose(creation);
  H5Dclose(dataset);
}

// 1/3 is no float; the last beam goes from (2, 0, 0) to (3, 0.5, 0.25).
TEST(Archive, HoldsTheLatticeInDoublePrecisionAndTheRotationsAskedFor) {
  const double third = 1.0 / 3.0;
  const Mechanics mechanics{.centre = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0.5, 0.25}},
                            .radius = {0.5, 0.4, 0.3, 0.2},
                            .mass = {third, 2, 3, 4},
                            .inertia = {5, 6, 7, third},
                            .grip = {1, 0, 0, 2},
                            .axial = {third, 9, 10},
                            .bending = {11, third, 13},
                            .twist = {14, 15, third},
                            .crossing_position = {0.01, third}};
  Frame frame = small_run::frame(1, 0);
  frame.elastic_energy.clear();  // its place before the rotations is kept
  for (int i = 0; i < 4; ++i) frame.rotation.push_back({0.5F, static_cast<float>(i), 0});
  std::vector<Record> records = one_lane();
  records.insert(records.begin() + 2, {mechanics, frame});
  const TemporaryFolder scratch;
  small_run::write_journal(scratch.path(), records);
  assemble_archive(scratch.path());
  const Archive archive(scratch.path());
  EXPECT_EQ(archive.dataset("/scene/lattice/centre_m").shape, (Shape{4, 3}));
  EXPECT_EQ(archive.dataset("/scene/lattice/mass_kg").type_size, sizeof(double));
  EXPECT_EQ(archive.values("/scene/lattice/mass_kg"), (Numbers{third, 2, 3, 4}));
  EXPECT_EQ(archive.values("/scene/lattice/inertia_kg_m2"), (Numbers{5, 6, 7, third}));
  EXPECT_EQ(archive.values("/scene/lattice/grip"), (Numbers{1, 0, 0, 2}));
  EXPECT_EQ(archive.values("/scene/lattice/ends"), (Numbers{0, 1, 1, 2, 2, 3}));
  EXPECT_EQ(archive.values("/scene/lattice/axial_n_m"), (Numbers{third, 9, 10}));
  EXPECT_EQ(archive.values("/scene/lattice/bending_n_m"), (Numbers{11, third, 13}));
  EXPECT_EQ(archive.values("/scene/lattice/twist_n_m"), (Numbers{14, 15, third}));
  EXPECT_EQ(archive.values("/scene/lattice/crossing"), (Numbers{1, 2}));
  EXPECT_EQ(archive.values("/scene/lattice/crossing_position_m"), (Numbers{0.01, third}));
  const double length = std::sqrt(1.3125);
  EXPECT_NEAR(archive.values("/scene/lattice/length_m")[2], length, 1e-15);
  EXPECT_NEAR(archive.values("/scene/lattice/axis")[7], 0.5 / length, 1e-15);
  EXPECT_EQ(archive.values("/VTKHDF/PointData/rotation"), (Numbers{0.5, 0, 0, 0.5, 1, 0, 0.5, 2, 0, 0.5, 3, 0}));
}

// Beams that break by themselves have no positions along a path: the rest of the lattice is there all the same.
TEST(Archive, OfACrackWithoutAPathHoldsTheLatticeWithoutCrossings) {
  const Mechanics mechanics{.centre = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0.5, 0.25}},
                            .radius = {0.5, 0.4, 0.3, 0.2},
                            .mass = {1, 2, 3, 4},
                            .inertia = {5, 6, 7, 8},
                            .grip = {1, 0, 0, 2},
                            .axial = {8, 9, 10},
                            .bending = {11, 12, 13},
                            .twist = {14, 15, 16},
                            .crossing_position = {}};
  std::vector<Record> records = one_lane();
  records.insert(records.begin() + 2, mechanics);
  const TemporaryFolder scratch;
  small_run::write_journal(scratch.path(), records);
  assemble_archive(scratch.path());
  const Archive archive(scratch.path());
  EXPECT_EQ(archive.values("/scene/lattice/mass_kg"), (Numbers{1, 2, 3, 4}));
  EXPECT_FALSE(archive.has("/scene/lattice/crossing"));
}

TEST(Archive, OfAJournalWithoutALatticeHasNone) {
  const TemporaryFolder scratch;
  small_run::write_journal(scratch.path(), one_lane());
  assemble_archive(scratch.path());
  EXPECT_FALSE(Archive(scratch.path()).has("/scene/lattice"));
}

TEST(Archive, LargeFramesComeBackWhole) {
  // More rows than a chunk holds, with chunks that do not end where frames do.
  constexpr std::size_t count = 150001;
  Geometry geometry{std::vector<std::array<float, 3>>(count), std::vector<float>(count, 1.0F), {}, {}};
  std::vector<Record> records{RunHeader{"{}"}, geometry};
  for (int step = 0; step < 2; ++step) {
    Frame frame{step, static_cast<double>(step), 0, 0, {}, {}, {}, {}, {}};
    for (std::size_t i = 0; i < count; ++i)
      frame.displacement.push_back({static_cast<float>(i), 1, static_cast<float>(step)});
    records.emplace_back(frame);
  }
  const TemporaryFolder scratch;
  small_run::write_journal(scratch.path(), records);
  assemble_archive(scratch.path());
  const Archive archive(scratch.path());
  const auto displacement = archive.dataset("/VTKHDF/PointData/displacement");
  ASSERT_EQ(displacement.shape, (Shape{2 * count, 3}));
  for (std::size_t row = 0; row < 2 * count; ++row) {
    ASSERT_EQ(displacement.values[3 * row], static_cast<double>(row % count));
    ASSERT_EQ(displacement.values[3 * row + 2], row < count ? 0.0 : 1.0);
  }
}

TEST(Archive, ComesFromWhatIsWholeOfADamagedJournal) {
  const TemporaryFolder scratch;
  small_run::write_journal(scratch.path(), one_lane());
  auto bytes = read_text(scratch / "journal.rift");
  write_text(scratch / "journal.rift", bytes.substr(0, bytes.size() - 200));
  assemble_archive(scratch.path());
  const Archive archive(scratch.path());
  EXPECT_EQ(archive.values("/VTKHDF/Steps/Values"), (Numbers{0, 1e-6}));
  EXPECT_FALSE(archive.has("/scene/summary"));
}

TEST(Archive, WithoutAGeometryIsRefusedAndLeavesNothing) {
  const TemporaryFolder scratch;
  small_run::write_journal(scratch.path(), {RunHeader{"{}"}});
  try {
    assemble_archive(scratch.path());
    FAIL() << "an archive of nothing";
  } catch (const base::WorldError& error) {
    EXPECT_EQ(error.what(), "cannot assemble an archive from " + (scratch / "journal.rift").string() +
                                ": it holds no geometry");
  }
  EXPECT_FALSE(fs::exists(scratch / "run.vtkhdf"));
  for (const auto& entry : fs::directory_iterator(scratch.path()))
    EXPECT_NE(entry.path().extension(), ".part") << entry.path();
}

}  // namespace
}  // namespace rift::results
