#include "tests/studio/commands/tiny_plate.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace rift::studio {
namespace {

namespace fs = std::filesystem;

long lines_of(const fs::path& file) {
  const std::string text = read_text(file);
  return std::count(text.begin(), text.end(), '\n');
}

TEST(ExportCommand, MakesTablesOfARun) {
  const TinyPlate plate;
  ASSERT_EQ(plate.run().exit_code, 0);
  const Ran ran = run_rift("export '" + plate.out().string() + "' --to csv");
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(ran.out, (plate.out() / "csv").string() + "\n");
  EXPECT_EQ(read_text(plate.out() / "csv" / "series.csv"), read_text(plate.out() / "series.csv"));
  EXPECT_GE(lines_of(plate.out() / "csv" / "series.csv"), 60);
  EXPECT_GT(lines_of(plate.out() / "csv" / "events.csv"), 30);
  EXPECT_GT(lines_of(plate.out() / "csv" / "rate.csv"), 30);
  EXPECT_EQ(lines_of(plate.out() / "csv" / "crack.csv"), lines_of(plate.out() / "series.csv"));
}

TEST(ExportCommand, MakesASeriesOfPicturesData) {
  const TinyPlate plate;
  ASSERT_EQ(plate.run().exit_code, 0);
  const Ran ran = run_rift("export '" + plate.out().string() + "' --to pvd");
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(ran.out, (plate.out() / "pvd" / "run.pvd").string() + "\n");
  const std::string collection = read_text(plate.out() / "pvd" / "run.pvd");
  for (int k = 0; k < 4; ++k) {
    const std::string name = "frame_00000" + std::to_string(k) + ".vtp";
    EXPECT_TRUE(contains(collection, name));
    EXPECT_GT(fs::file_size(plate.out() / "pvd" / name), 10000U);
  }
  EXPECT_FALSE(fs::exists(plate.out() / "pvd" / "frame_000004.vtp"));
}

TEST(ExportCommand, NamesTheFileForParaviewAndTheFolderForOvito) {
  const TinyPlate plate;
  ASSERT_EQ(plate.run().exit_code, 0);
  EXPECT_EQ(run_rift("export '" + plate.out().string() + "' --to paraview").out,
            (plate.out() / "run.vtkhdf").string() + "\n");
  EXPECT_EQ(run_rift("export '" + plate.out().string() + "' --to ovito").out,
            (plate.out() / "ovito").string() + "\n");
  EXPECT_GT(fs::file_size(plate.out() / "ovito" / "run.dump"), 100000U);
  EXPECT_GT(fs::file_size(plate.out() / "ovito" / "beams.dump"), 100000U);
}

TEST(ExportCommand, OfAnExportedRunIsReplacedWithForce) {
  const TinyPlate plate;
  ASSERT_EQ(plate.run().exit_code, 0);
  ASSERT_EQ(run_rift("export '" + plate.out().string() + "' --to pvd").exit_code, 0);
  ASSERT_EQ(plate.run("--force").exit_code, 0);
  EXPECT_FALSE(fs::exists(plate.out() / "pvd"));
}

TEST(ExportCommand, OfNoRunFailsAndMakesNothing) {
  const TemporaryFolder folder;
  for (const std::string to : {"csv", "ovito", "paraview", "pvd"}) {
    const Ran ran = run_rift("export '" + folder.path().string() + "' --to " + to);
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_TRUE(contains(ran.err, folder.path().string()));
  }
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(ExportCommand, KnowsItsFormats) {
  const Ran ran = run_rift("export somewhere --to png");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_TRUE(contains(ran.err, "rift export: --to: png not in {csv,paraview,pvd,ovito}\n"));
  EXPECT_EQ(run_rift("export somewhere").exit_code, 2);
}

}  // namespace
}  // namespace rift::studio
