#include "tests/studio/commands/study_table.hpp"

#include <chrono>
#include <random>

namespace rift::studio {
namespace {

namespace fs = std::filesystem;

/// The paper's plate, three specimens to pack and pre-stress, 48 scenarios: a minute or more of work on two
/// cores.
constexpr const char* long_study = R"(# A study of a minute
[specimen]
elements = 20000

[output]
samples = 100
frames = 0

[study]
technique = ["simple", "progressive"]
crack_velocity = ["0.01 c_r", "0.05 c_r", "0.1 c_r", "0.2 c_r", "0.3 c_r", "0.5 c_r", "0.7 c_r", "1.0 c_r"]
seed = [1, 2, 3]
)";

// The first kills fall into the packing of the first specimen, the later ones wherever they may.
TEST(LongStudy, KilledAtTenRandomMomentsGivesTheSameTable) {
  const TemporaryFolder folder;
  const fs::path preset = folder.path() / "long.toml", alone = folder.path() / "alone",
                 killed = folder.path() / "killed";
  write_text(preset, long_study);
  const auto study = [&](const std::string& wrapper, const fs::path& out, const std::string& cache) {
    return run_shell("env XDG_CACHE_HOME='" + (folder.path() / cache).string() + "' " + wrapper +
                     " '" RIFT_EXE "' study '" + preset.string() + "' --yes --quiet --out '" + out.string() +
                     "'");
  };
  const auto start = std::chrono::steady_clock::now();
  ASSERT_EQ(study("", alone, "cache_alone").exit_code, 0);
  const double whole = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> early(0.1, 3.0), any(0.5, whole / 7.0);
  for (int kill = 0; kill < 10; ++kill) {
    const double after = kill < 3 ? early(random) : any(random);
    EXPECT_EQ(study("timeout -s KILL " + std::to_string(after), killed, "cache_killed").exit_code, 137)
        << after;
  }
  const Ran ran = study("", killed, "cache_killed");
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(table_in(killed), table_in(alone));
  EXPECT_EQ(table_in(killed).size(), 48U);
  RecordProperty("work_s", std::to_string(whole));
  printf("%.0f s of work, killed ten times, seed %u\n", whole, seed);
}

}  // namespace
}  // namespace rift::studio
