#include "engine/base/world_error.hpp"
#include "engine/results/archive.hpp"
#include "engine/results/export.hpp"
#include "engine/results/journal.hpp"
#include "tests/engine/results/small_run.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace rift::results {
namespace {

namespace fs = std::filesystem;

/// One snapshot of a dump, read by the rules of LAMMPS.
struct Snapshot {
  std::int64_t step = -1;
  std::string kind;                           // "ATOMS" or "ENTRIES"
  std::vector<std::array<double, 2>> bounds;  // of x, y, z
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;
};

std::vector<Snapshot> read_dump(const fs::path& path) {
  std::istringstream text(read_text(path));
  std::vector<Snapshot> snapshots;
  std::size_t count = 0;
  for (std::string line; std::getline(text, line);) {
    if (line == "ITEM: TIMESTEP") {
      snapshots.emplace_back();
      text >> snapshots.back().step >> std::ws;
    } else if (line.starts_with("ITEM: NUMBER OF ")) {
      snapshots.back().kind = line.substr(16);
      text >> count >> std::ws;
    } else if (line == "ITEM: BOX BOUNDS ff ff ff") {
      snapshots.back().bounds.resize(3);
      for (auto& [low, high] : snapshots.back().bounds) text >> low >> high >> std::ws;
    } else {
      std::istringstream head(line.substr(("ITEM: " + snapshots.back().kind).size()));
      for (std::string column; head >> column;) snapshots.back().columns.push_back(column);
      snapshots.back().rows.assign(count, std::vector<double>(snapshots.back().columns.size()));
      for (auto& row : snapshots.back().rows)
        for (double& value : row) text >> value;
      text >> std::ws;
    }
    EXPECT_TRUE(text.good() || text.eof()) << path << " after " << line;
  }
  return snapshots;
}

TEST(ExportOvito, ElementsComeBackWithTheirFieldsAtEveryMoment) {
  const TemporaryFolder scratch;
  small_run::write_journal(scratch.path(), {RunHeader{"{}"}, small_run::geometry(), small_run::frame(0, 0),
                                            small_run::frame(3, 0)});
  EXPECT_EQ(export_ovito(scratch.path()), scratch / "ovito");
  const auto snapshots = read_dump(scratch / "ovito/run.dump");
  ASSERT_EQ(snapshots.size(), 2U);
  const Snapshot& last = snapshots[1];
  const Frame frame = small_run::frame(3, 0);
  EXPECT_EQ(last.step, 3);
  EXPECT_EQ(last.columns, (std::vector<std::string>{"id", "type", "radius", "x", "y", "z", "ux", "uy", "uz",
                                                    "vx", "vy", "vz", "elastic_energy"}));
  ASSERT_EQ(last.rows.size(), 4U);
  const std::vector<double>& third = last.rows[2];
  EXPECT_EQ(third[0], 3);
  EXPECT_FLOAT_EQ(static_cast<float>(third[2]), 0.3F);
  EXPECT_FLOAT_EQ(static_cast<float>(third[3]), 2 + frame.displacement[2][0]);
  EXPECT_FLOAT_EQ(static_cast<float>(third[7]), frame.displacement[2][1]);
  EXPECT_FLOAT_EQ(static_cast<float>(third[9]), frame.velocity[2][0]);
  EXPECT_FLOAT_EQ(static_cast<float>(last.rows[1][12]), frame.elastic_energy[1]);
  for (const auto& row : last.rows)
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GE(row[3 + axis], last.bounds[axis][0]);
      EXPECT_LE(row[3 + axis], last.bounds[axis][1]);
    }
}

TEST(ExportOvito, OnlyBeamsThatBearSomethingAreListed) {
  const TemporaryFolder scratch;
  small_run::write_journal(scratch.path(), {RunHeader{"{}"}, small_run::geometry(), small_run::frame(0, 0),
                                            small_run::frame(3, 0)});
  export_ovito(scratch.path());
  const auto snapshots = read_dump(scratch / "ovito/beams.dump");
  ASSERT_EQ(snapshots.size(), 2U);
  EXPECT_EQ(snapshots[0].columns, (std::vector<std::string>{"index", "atom1", "atom2", "factor"}));
  using Rows = std::vector<std::vector<double>>;
  EXPECT_EQ(snapshots[0].rows, (Rows{{1, 1, 2, 1}, {2, 2, 3, 1}, {3, 3, 4, 0.5}}));
  EXPECT_EQ(snapshots[1].rows, (Rows{{1, 1, 2, 1}, {2, 2, 3, 0.25}}));
}

TEST(ExportOvito, AFrameWithoutDamageHasNoSnapshotOfBeams) {
  const TemporaryFolder scratch;
  Frame bare = small_run::frame(1, 0);
  bare.damage_factor.clear();
  small_run::write_journal(scratch.path(), {RunHeader{"{}"}, small_run::geometry(), small_run::frame(0, 0),
                                            bare, small_run::frame(3, 0)});
  export_ovito(scratch.path());
  EXPECT_EQ(read_dump(scratch / "ovito/run.dump").size(), 3U);
  EXPECT_EQ(read_dump(scratch / "ovito/beams.dump").size(), 2U);
}

TEST(ExportOvito, EachLaneHasFilesOfItsOwn) {
  const TemporaryFolder scratch;
  small_run::write_journal(scratch.path(),
                           {RunHeader{R"({"lanes":2})"}, small_run::geometry(), small_run::frame(0, 0),
                            small_run::frame(0, 1), small_run::frame(5, 1)});
  export_ovito(scratch.path());
  EXPECT_EQ(read_dump(scratch / "ovito/run_lane0.dump").size(), 1U);
  EXPECT_EQ(read_dump(scratch / "ovito/beams_lane1.dump").at(1).step, 5);
}

TEST(ExportOvito, ARunWithoutFramesGivesItsElementsUnloaded) {
  const TemporaryFolder scratch;
  small_run::write_journal(scratch.path(), {RunHeader{"{}"}, small_run::geometry()});
  export_ovito(scratch.path());
  const auto snapshots = read_dump(scratch / "ovito/run.dump");
  ASSERT_EQ(snapshots.size(), 1U);
  EXPECT_EQ(snapshots[0].columns.size(), 6U);
  EXPECT_EQ(snapshots[0].rows[3][4], 0.5);
  EXPECT_FALSE(fs::exists(scratch / "ovito/beams.dump"));
}

TEST(ExportOvito, LeavesNoDumpOfAnEarlierExport) {
  const TemporaryFolder scratch;
  fs::create_directories(scratch / "ovito");
  for (const char* name : {"run.dump", "beams_lane7.dump", "notes.txt"})
    write_text(scratch.path() / "ovito" / name, "earlier");
  small_run::write_journal(scratch.path(), {RunHeader{R"({"lanes":2})"}, small_run::geometry(),
                                            small_run::frame(0, 0), small_run::frame(0, 1)});
  export_ovito(scratch.path());
  EXPECT_TRUE(fs::exists(scratch / "ovito/run_lane1.dump"));
  EXPECT_FALSE(fs::exists(scratch / "ovito/run.dump"));
  EXPECT_FALSE(fs::exists(scratch / "ovito/beams_lane7.dump"));
  EXPECT_EQ(read_text(scratch / "ovito/notes.txt"), "earlier");
}

TEST(ExportOvito, OfNoRunThrowsAndMakesNothing) {
  const TemporaryFolder scratch;
  EXPECT_THROW(export_ovito(scratch.path()), base::WorldError);
  EXPECT_TRUE(fs::is_empty(scratch.path()));
}

}  // namespace
}  // namespace rift::results
