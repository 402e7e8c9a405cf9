#include "engine/base/files.hpp"
#include "engine/measurement/instruments.hpp"
#include "engine/results/json_input.hpp"
#include "engine/results/lane_summary.hpp"
#include "engine/results/run_folder.hpp"
#include "engine/scene/issue.hpp"
#include "engine/simulation/record.hpp"
#include "tests/engine/simulation/small_plate.hpp"

#include <numeric>

namespace rift::measurement {
namespace {

/// A plate two thirds as high as the paper's in radii, its frames on disk.
class RecordedStrip : public testing::Test {
 protected:
  static constexpr int lanes = 2;
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    const scene::Preset preset = scene::read_preset_text(R"(
[specimen]
length = "120 mm"
height = "30 mm"
layers = 2
elements = 8000
[loading]
displacement = "1 mm"
[crack]
damage_zone_ratio = 4
end = "60 mm"
[output]
frames = 16
gauges = [["40 mm", "20 mm"]]
[[lanes]]
crack_velocity = "0.2 c_r"
[[lanes]]
crack_velocity = "0.6 c_r"
)",
                                                         "strip.toml");
    for (const scene::Issue& issue : preset.issues) ADD_FAILURE() << scene::to_text(issue);
    const simulation::Prepared prepared = simulation::prepare(preset, preset.lanes, shared_cache());
    results::create_run_folder(run(), false);
    simulation::record_run(prepared, run(), {}, {});
  }
  static void TearDownTestSuite() { delete folder_; }
  static std::filesystem::path run() { return folder_->path() / "run"; }

  static Instruments read(int lane, std::vector<SeenField>* fields = nullptr) {
    return read_instruments(
        run(), {.lane = lane}, shared_cache(), {},
        [&](const Grid&, const SeenField& field) {
          if (fields) fields->push_back(field);
        });
  }

 private:
  static TemporaryFolder* folder_;
};
TemporaryFolder* RecordedStrip::folder_ = nullptr;

// All that is stored ahead of a steady crack in a strip arrives at its tip (Nilsson 1972): that is what K of
// the field must say, whatever the damage zone takes of it. Five per cent and the scatter of a small plate.
TEST_F(RecordedStrip, ShowsWhatArrivesAtTheTip) {
  for (int lane = 0; lane < lanes; ++lane) {
    const Instruments seen = read(lane);
    double field = 0.0, samples = 0.0, sliding = 0.0;
    int count = 0;
    for (const IntensityPoint& p : not_empty(seen.intensity)) {
      if (!p.k || !(p.tip > 0.025 && p.tip < 0.054)) continue;
      field += p.k->release_rate / seen.g_i0, samples += p.g_id / seen.g_i0;
      sliding += std::abs(p.k->sliding / p.k->opening);
      EXPECT_LT(p.k->misfit, 0.1);
      ++count;
    }
    ASSERT_GE(count, 6) << lane;
    EXPECT_NEAR(field / count, 1.0, 0.1) << lane;
    EXPECT_LT(samples, field) << lane;
    EXPECT_LT(sliding / count, 0.06) << lane;
  }
}

TEST_F(RecordedStrip, ShowsThePulledStripAheadOfTheTipAndNoneBehindIt) {
  std::vector<SeenField> fields;
  const Instruments seen = read(0, &fields);
  ASSERT_EQ(fields.size(), 16U);
  const SeenField& last = fields.back();
  double ahead = 0.0, behind = 0.0;
  int of_ahead = 0, of_behind = 0;
  for (std::size_t p = 0; p < last.motion.size(); ++p) {
    if (!last.motion[p]) continue;
    const double x = seen.grid.point[p].x();
    if (x > 0.1) ahead += last.motion[p]->strain_yy(), ++of_ahead;
    if (x < 0.02) behind += last.motion[p]->strain_yy(), ++of_behind;
  }
  // The nominal strain is that between the grips, whose elements are held half a radius or so inside.
  EXPECT_NEAR(ahead / of_ahead, 1.0 / 30.0, 0.12 / 30.0);
  EXPECT_NEAR(behind / of_behind, 0.0, 0.1 / 30.0);
}

TEST_F(RecordedStrip, HoldsTheLanesOwnBooksAndGauges) {
  const Instruments seen = read(1);
  EXPECT_EQ(seen.clock, 0.0);
  ASSERT_FALSE(seen.gauges.empty());
  for (const results::GaugeRow& row : seen.gauges) EXPECT_EQ(row.lane, 1);
  for (const results::Sample& row : not_empty(seen.samples)) EXPECT_EQ(row.lane, 1);
  int moving = 0;
  for (const IntensityPoint& p : seen.intensity)
    if (p.tip > 0.0) {
      EXPECT_NEAR(p.over_cr, 0.6, 1e-9);
      ++moving;
    }
  EXPECT_GT(moving, 0);
}

TEST_F(RecordedStrip, RefusesALaneThatItDoesNotHave) {
  EXPECT_THROW(read(2), scene::InputError);
  EXPECT_THROW(read(-1), scene::InputError);
}

TEST(Instruments, GoByTheClockOfAMeasuredHistory) {
  scene::Preset preset = simulation::small_preset({"crack.damage_zone_ratio=3"});
  preset.scene.crack.start = 4e-3;
  for (int k = 0; k <= 12; ++k)
    preset.scene.crack.history.push_back({1e-4 + 2e-6 * k, 4e-3 + 880.0 * 2e-6 * k, 0.0});
  preset.scene.crack.end.reset();
  const TemporaryFolder folder;
  results::create_run_folder(folder.path() / "run", false);
  simulation::record_run(simulation::prepare(preset, shared_cache()), folder.path() / "run", {}, {});
  const Instruments seen = read_instruments(
      folder.path() / "run", {}, shared_cache(), {}, [](const Grid&, const SeenField&) {});
  int on_the_way = 0;
  for (const results::Sample& s : not_empty(seen.samples)) {
    if (s.tip_m <= 4e-3) continue;
    EXPECT_NEAR(s.time_s + seen.clock, 1e-4 + (s.tip_m - 4e-3) / 880.0, 1e-12);
    ++on_the_way;
  }
  EXPECT_GT(on_the_way, 20);
  const std::filesystem::path summary = folder.path() / "run" / "summary.json";
  const auto lanes =
      results::lane_summaries_of(results::read_json(base::read_whole_file(summary), summary).at("scenarios"));
  EXPECT_NEAR(lanes.at(0).history_clock_s, seen.clock, 1e-12);  // as who reads the run adds it
}

}  // namespace
}  // namespace rift::measurement
