#include "tests/studio/run_rift.hpp"

#include <nlohmann/json.hpp>

#include <chrono>
#include <random>

namespace rift::studio {
namespace {

namespace fs = std::filesystem;

/// A plate that packs in some seconds, marches for twenty and leaves 60 frames to assemble.
constexpr const char* long_run = R"(# A run of twenty seconds
[specimen]
elements = 8000
layers = 2
length = "120 mm"
height = "40 mm"

[crack]
velocity = "0.005 c_r"

[output]
samples = 400
frames = 60
)";

struct LongRun {
  TemporaryFolder folder;
  fs::path preset = folder.path() / "long.toml", alone = folder.path() / "alone",
           killed = folder.path() / "killed";

  LongRun() { write_text(preset, long_run); }

  Ran rift(const std::string& wrapper, const std::string& arguments) const {
    return run_shell("env XDG_CACHE_HOME='" + (folder.path() / "none").string() + "' " + wrapper +
                     " '" RIFT_EXE "' " + arguments + " --threads 1 --no-cache --quiet");
  }
  Ran begin(const std::string& wrapper, const fs::path& out) const {
    return rift(wrapper, "run '" + preset.string() + "' --checkpoint '1 s' --out '" + out.string() + "'");
  }
  Ran go_on(const std::string& wrapper) const { return rift(wrapper, "resume '" + killed.string() + "'"); }
  bool has_begun() const { return fs::exists(killed / "journal.rift"); }
};

/// Everything of a summary but times, memory and where things came from.
nlohmann::json lasting(const fs::path& summary) {
  nlohmann::json scenario = nlohmann::json::parse(read_text(summary)).at("scenarios")[0];
  for (auto it = scenario.begin(); it != scenario.end();) {
    const std::string& name = it.key();
    const bool fleeting = name.find("wall") != name.npos || name.find("per_s") != name.npos ||
                          name.find("cache") != name.npos || name == "memory_peak_bytes";
    it = fleeting ? scenario.erase(it) : std::next(it);
  }
  return scenario;
}

// Moments are uniform over what a run goes through: it is killed, resumed and killed again until it comes to
// its end, then begun anew. Packing and statics are never cached, so that kills fall into them and into the
// assembly, too.
TEST(LongRun, KilledAtAHundredMomentsIsAlwaysResumedToTheSameBytes) {
  const LongRun run;
  const auto start = std::chrono::steady_clock::now();
  ASSERT_EQ(run.begin("", run.alone).exit_code, 0);
  const double whole = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  EXPECT_GT(whole, 20.0);
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> moment(0.1, whole);
  int kills = 0, ends = 0, before_a_run = 0;
  while (kills < 100) {
    fs::remove_all(run.killed);
    for (bool ended = false; !ended;) {
      // Once there have been enough, it may come to its end.
      const std::string wrapper = kills < 100 ? "timeout -s KILL " + std::to_string(moment(random)) : "";
      const bool resumed = run.has_begun();
      const Ran ran = resumed ? run.go_on(wrapper) : run.begin(wrapper, run.killed);
      ended = ran.exit_code == 0;
      if (ended) continue;
      ASSERT_EQ(ran.exit_code, 137) << "kill " << kills << ": " << ran.err;
      ++kills;
      if (!run.has_begun()) {
        ++before_a_run;
        fs::remove_all(run.killed);  // of a run that never was only an empty folder may be left
        continue;
      }
      const Ran looked = run_rift("verify --check-only '" + run.killed.string() + "'");
      EXPECT_TRUE(looked.exit_code == 0 || contains(looked.out, ".part")) << looked.out;
    }
    ++ends;
    EXPECT_EQ(read_text(run.killed / "series.csv"), read_text(run.alone / "series.csv"));
    EXPECT_EQ(lasting(run.killed / "summary.json"), lasting(run.alone / "summary.json"));
    EXPECT_EQ(run_rift("verify --check-only '" + run.killed.string() + "'").exit_code, 0);
  }
  RecordProperty("work_s", std::to_string(whole));
  printf(
      "%.0f s of work; killed %d times, %d of them before there was a run; %d runs came to the same end; "
      "seed %u\n",
      whole, kills, before_a_run, ends, seed);
}

}  // namespace
}  // namespace rift::studio
