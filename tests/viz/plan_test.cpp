#include "viz/plan.hpp"

#include "tests/viz/drawn_plate.hpp"

namespace rift::viz {
namespace {

using namespace drawn_plate;
using Json = nlohmann::ordered_json;

Request request_for(std::vector<std::filesystem::path> runs) {
  Request request;
  request.runs = std::move(runs);
  return request;
}

std::string complaint(const Request& request) {
  try {
    (void)plan_of(request);
  } catch (const BadRequest& bad) {
    return bad.what();
  }
  return "no complaint";
}

TEST(Plan, TakesAllLanesOnTheClockOfTheLongest) {
  const TemporaryFolder folder;
  const Plan plan = plan_of(request_for({write_run(folder / "short", 3), write_run(folder / "long", 6, 2)}));
  ASSERT_EQ(plan.job.panes.size(), 3U);
  EXPECT_EQ(plan.job.panes[2].lane, 1);
  ASSERT_EQ(plan.times_s.size(), 6U);
  for (int k = 0; k < 6; ++k) {
    EXPECT_NEAR(plan.times_s[k], 1e-6 * k, 1e-18);
    EXPECT_EQ(plan.tips_m[k], tip_at_moment(k));
  }
}

TEST(Plan, HasOneRangeForAllPanes) {
  const TemporaryFolder folder;
  Request request = request_for({write_run(folder / "short", 3), write_run(folder / "long", 6)});
  EXPECT_EQ(plan_of(request).job.look.range, (std::array{0.0, pulled}));
  EXPECT_TRUE(plan_of(request).range_known);
  request.field = "vx";
  EXPECT_EQ(plan_of(request).job.look.range, (std::array{-50.0, 50.0}));
  EXPECT_FALSE(plan_of(request).range_known);
  request.field = "uy";
  request.range = {0.1, 0.3};  // mm
  EXPECT_NEAR(plan_of(request).job.look.range[1], 0.3e-3, 1e-12);
}

TEST(Plan, LooksAsThePresetHasItUnlessAsked) {
  const TemporaryFolder folder;
  const std::filesystem::path run = folder / "run";
  std::filesystem::create_directories(run);
  {
    Json with_film = header();
    with_film["film"] = {
        {"title", "of the preset"}, {"field", "vx"}, {"colours", "vik"}, {"camera", "tip"}, {"chart", false}};
    results::JournalWriter journal(run / results::journal_name);
    journal.write(results::RunHeader{with_film.dump()});
    journal.write(geometry());
    for (int k = 0; k < 3; ++k) journal.write(frame(k));
    journal.close();
  }
  Request request = request_for({run});
  Look look = plan_of(request).job.look;
  EXPECT_EQ(look.title, "of the preset");
  EXPECT_EQ(look.field, "vx");
  EXPECT_EQ(look.colours, "vik");
  EXPECT_EQ(look.camera, Camera::tip);
  EXPECT_EQ(look.chart, Chart::none);
  request.title = "mine";
  request.camera = "side";
  look = plan_of(request).job.look;
  EXPECT_EQ(look.title, "mine");
  EXPECT_EQ(look.camera, Camera::side);
  EXPECT_EQ(look.field, "vx");
  request.field = "uy";
  EXPECT_EQ(plan_of(request).job.look.colours, "");  // the preset's are those of its own field
  request.colours = "coolwarm";
  EXPECT_EQ(plan_of(request).job.look.colours, "coolwarm");
}

/// A run whose header differs from that of the drawn plate.
std::filesystem::path run_with(const std::filesystem::path& run, const Json& changes) {
  std::filesystem::create_directories(run);
  Json changed = header();
  changed.update(changes);
  results::JournalWriter journal(run / results::journal_name);
  journal.write(results::RunHeader{changed.dump()});
  journal.write(geometry());
  for (int k = 0; k < 3; ++k) journal.write(frame(k));
  journal.close();
  return run;
}

TEST(Plan, WithoutATitleSaysWhatIsInTheRuns) {
  const TemporaryFolder folder;
  const auto title_of_runs = [](std::vector<std::filesystem::path> runs) {
    return plan_of(request_for(std::move(runs))).job.look.title;
  };
  const auto soft = run_with(folder / "soft", {{"young_modulus_pa", 3.2e9}}),
             hard = run_with(folder / "hard", {{"young_modulus_pa", 72e9}}),
             measured = run_with(folder / "measured", {{"scenarios", {{{"crack_course", "measured"}}}}});
  EXPECT_EQ(title_of_runs({soft}), "A crack in a plate of 40 × 8 mm, E = 3.2 GPa");
  EXPECT_EQ(title_of_runs({soft, hard}), "A crack in a plate of 40 × 8 mm");
  EXPECT_EQ(title_of_runs({measured}), "A measured crack in a plate of 40 × 8 mm");
  EXPECT_EQ(title_of_runs({soft, measured}), "A crack in a plate of 40 × 8 mm");
  EXPECT_EQ(title_of_runs({measured, soft}), "A crack in a plate of 40 × 8 mm");
}

TEST(Plan, NamesWhatARunHasInPlaceOfWhatItHasNot) {
  const TemporaryFolder folder;
  const std::filesystem::path run = write_run(folder / "run");
  Request request = request_for({run});
  request.field = "elastic";
  EXPECT_EQ(complaint(request),
            run.string() +
                " holds no field elastic; its fields are ux, uy, uz, u, vx, vy, vz, v, kinetic, damage. Run "
                "it with --set 'output.fields=[\"damage\", \"displacement\", \"energy\", \"velocity\"]'");
  request.field = "uy";
  request.lanes = {3};
  EXPECT_EQ(complaint(request), run.string() + " has no lane 3: its lanes are 0 to 0");
  request.lanes = {};
  request.runs = {folder / "none"};
  EXPECT_EQ(complaint(request), (folder / "none").string() + ": no such run");
  request.runs = {folder.path()};
  EXPECT_EQ(complaint(request), folder.path().string() + " holds no run: no journal.rift");
  request.runs = {write_run(folder / "bare", 0)};
  EXPECT_EQ(complaint(request),
            (folder / "bare").string() + " holds no frames: run it with --set output.frames=100");
  request.runs = {write_run(folder / "five", 2, 5)};
  EXPECT_EQ(complaint(request), "5 lanes, and a frame shows up to 4: choose some with --lane");
}

TEST(Plan, ShowsADamagedRunUpToItsDamageAndSaysSo) {
  const TemporaryFolder folder;
  const std::filesystem::path journal = write_run(folder / "run") / results::journal_name;
  std::filesystem::resize_file(journal, std::filesystem::file_size(journal) - 2000);
  EXPECT_TRUE(plan_of(request_for({folder / "run"})).notes.empty()) << "a run that goes on looks like this";
  EXPECT_EQ(plan_of(request_for({folder / "run"})).times_s.size(), 5U);
  {
    std::fstream file(journal, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(-20000, std::ios::end);
    file.put('x');
  }
  const Plan plan = plan_of(request_for({folder / "run"}));
  ASSERT_EQ(plan.notes.size(), 1U);
  EXPECT_NE(plan.notes[0].find("is damaged"), std::string::npos) << plan.notes[0];
  EXPECT_LT(plan.times_s.size(), 5U);
}

TEST(Plan, ChoosesStoredMomentsEvenlyAndNeverMakesOneUp) {
  const std::vector<double> times{0, 1, 2, 3, 4};
  EXPECT_EQ(evenly_chosen(times, 3), (std::vector<double>{0, 2, 4}));
  EXPECT_EQ(evenly_chosen(times, 5), times);
  EXPECT_EQ(evenly_chosen(times, 1), (std::vector<double>{4}));
  EXPECT_THROW((void)evenly_chosen(times, 6), BadRequest);
}

}  // namespace
}  // namespace rift::viz
