#include "engine/base/claim.hpp"
#include "engine/base/files.hpp"
#include "engine/study/plan.hpp"
#include "engine/study/runner.hpp"
#include "engine/study/status.hpp"
#include "engine/study/store.hpp"
#include "tests/engine/study/tiny_study.hpp"
#include "tests/expectations.hpp"
#include "tests/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>
#include <thread>
#include <vector>

namespace rift::study {
namespace {

/// Four specimens with four scenarios each.
scene::Preset study_of_seeds() {
  std::string text = undamped_text();
  text.erase(text.find("damage_zone_ratio"), text.find("crack_velocity") - text.find("damage_zone_ratio"));
  return preset_from(text + "seed = [1, 2, 3, 4]\n");
}

StudyOptions share_of(const fs::path& folder, int tasks) {
  StudyOptions options = into(folder);
  options.work = StudyWork::share;
  options.tasks = tasks;
  return options;
}

StudyResult run_of(const scene::Preset& preset, const StudyOptions& options,
                   const StudyObserver& observer = {}) {
  base::Cache cache = shared_cache();
  return run_study(preset, options, cache, build, observer);
}

std::string claim_of(const scene::Preset& preset, int row) {
  return hash_text(result_key(scenes_of_study(preset).at(row), build.version));
}

TEST(StudyShares, OfTasksThatRunAtOnceAreEachComputedOnceAndTheSame) {
  const scene::Preset preset = study_of_seeds();
  const TemporaryFolder folder, whole;
  const StudyResult expected = run_of(preset, into(whole.path()));
  std::array<StudyResult, 3> results;
  {
    std::vector<std::jthread> tasks;
    for (StudyResult& result : results)
      tasks.emplace_back([&] { result = run_of(preset, share_of(folder.path(), 3)); });
  }
  int computed = 0;
  for (const StudyResult& result : results) computed += result.computed;
  EXPECT_EQ(computed, static_cast<int>(preset.study.size()));
  StudyOptions gathering = into(folder.path());
  gathering.work = StudyWork::gathering;
  const StudyResult gathered = run_of(preset, gathering);
  EXPECT_EQ(gathered.computed, 0);
  EXPECT_EQ(lasting(gathered.rows), lasting(expected.rows));
  EXPECT_FALSE(fs::exists(folder.path() / "claims"));
}

TEST(StudyShares, LeaveWhatAnotherProcessIsAt) {
  const scene::Preset preset = study_of_seeds();
  const TemporaryFolder folder;
  StudyResult result;
  {
    base::Claims other(folder.path() / "claims");
    const auto claim = other.take(claim_of(preset, 1));
    ASSERT_TRUE(claim);
    StudyOptions gathering = into(folder.path() / "study");
    fs::create_directories(folder.path() / "study");
    gathering.work = StudyWork::gathering;
    run_of(preset, gathering);  // begins the folder
    fs::rename(folder.path() / "claims", folder.path() / "study" / "claims");
    result = run_of(preset, share_of(folder.path() / "study", 2));
    fs::rename(folder.path() / "study" / "claims", folder.path() / "claims");
  }
  EXPECT_EQ(result.elsewhere, 1);
  EXPECT_EQ(result.computed, static_cast<int>(preset.study.size()) - 1);
  EXPECT_FALSE(result.rows[1]);
  EXPECT_EQ(run_of(preset, into(folder.path() / "study")).computed, 1);
}

TEST(StudyShares, OfTheWholeWaitForOthersAndTakeWhatTheyGiveUp) {
  const scene::Preset preset = study_of_seeds();
  const TemporaryFolder folder;
  StudyOptions gathering = into(folder.path());
  gathering.work = StudyWork::gathering;
  run_of(preset, gathering);
  base::Claims other(folder.path() / "claims");
  auto claim = other.take(claim_of(preset, 1));
  ASSERT_TRUE(claim);
  StudyObserver observer;
  bool waited = false;
  observer.progress = [&](std::string_view stage, double) {
    if (stage.starts_with("waiting")) {
      waited = true;
      claim.reset();
    }
    return true;
  };
  const StudyResult result = run_of(preset, into(folder.path()), observer);
  EXPECT_TRUE(waited);
  EXPECT_EQ(result.computed, static_cast<int>(preset.study.size()));
  EXPECT_EQ(result.elsewhere, 0);
}

// The longest limit of a batch system may be shorter than a scenario: the next task goes on from the
// checkpoint.
TEST(StudyShares, GoOnWithThePassThatAnotherHasLeft) {
  std::string text = undamped_text();
  text.replace(text.find("[study]"), std::string::npos,
               "[study]\ncrack_velocity = [\"0.004 c_r\", \"0.3 c_r\"]\nseed = [1, 2]\n");
  const scene::Preset preset = preset_from(text);
  const TemporaryFolder folder;
  StudyObserver stopping;
  int looks = 0;
  stopping.progress = [&](std::string_view stage, double) { return stage != "crack" || ++looks < 3; };
  ASSERT_EQ(run_of(preset, share_of(folder.path(), 4), stopping).outcome, simulation::Outcome::stopped);
  ASSERT_EQ(std::distance(fs::directory_iterator(folder.path() / "passes"), fs::directory_iterator()), 1);
  const fs::path left = fs::directory_iterator(folder.path() / "passes")->path();
  base::Cache cache = shared_cache();
  const StudyResult result = run_study(preset, share_of(folder.path(), 4), cache, build, {});
  EXPECT_TRUE(cache.notes.empty()) << "a note would say that the pass starts from the beginning";
  EXPECT_EQ(result.computed + result.found, static_cast<int>(preset.study.size()));
  EXPECT_FALSE(fs::exists(left));
}

TEST(StudyPreparation, PacksEachSpecimenOnceAndComputesNothing) {
  const scene::Preset preset = study_of_seeds();
  const TemporaryFolder folder;
  StudyOptions options = into(folder.path() / "study");
  options.work = StudyWork::preparation;
  base::Cache cache{folder.path() / "cache", {}};
  const StudyResult prepared = run_study(preset, options, cache, build, {});
  EXPECT_EQ(prepared.computed, 0);
  EXPECT_FALSE(fs::exists(folder.path() / "study" / "claims"));
  for (const StudyItem& item : plan_study(preset, build.version))
    EXPECT_TRUE(base::recall(cache, "prepared", item.shares)) << item.row;
  const StudyResult computed = run_study(preset, share_of(folder.path() / "study", 2), cache, build, {});
  for (const auto& row : not_empty(computed.rows)) {
    EXPECT_TRUE(row->packing_from_cache);
    EXPECT_TRUE(row->prestress_from_cache);
  }
}

// Two tasks that begin at once with an empty cache.
TEST(StudyPreparation, IsDoneOnceForTasksThatBeginTogether) {
  const scene::Preset preset = study_of_seeds();
  const TemporaryFolder folder;
  std::array<StudyResult, 2> results;
  {
    std::vector<std::jthread> tasks;
    for (StudyResult& result : results)
      tasks.emplace_back([&] {
        base::Cache cache{folder.path() / "cache", {}};
        result = run_study(preset, share_of(folder.path() / "study", 2), cache, build, {});
      });
  }
  std::set<double> packed;  // seeds whose packing a task has made itself
  int packings = 0;
  for (const StudyResult& result : results)
    for (const auto& row : result.rows)
      if (row && !row->packing_from_cache && packed.insert(row->seed).second) ++packings;
  EXPECT_EQ(packings, 4);
}

TEST(StudyNotMade, IsNotTriedAgainByAnyOtherCall) {
  const TemporaryFolder folder;
  const scene::Preset preset = preset_from(undamped_text() + "layers = [1, 2]\n");
  const StudyResult first = run_of(preset, into(folder.path()));
  ASSERT_EQ(first.not_made.size(), 1U);
  StudyObserver observer;
  bool packed = false;
  observer.progress = [&](std::string_view, double) { return packed = true; };
  const StudyResult again = run_of(preset, share_of(folder.path(), 2), observer);
  EXPECT_FALSE(packed);
  EXPECT_EQ(to_json(again.not_made, preset), to_json(first.not_made, preset));
}

TEST(StudyStatus, CountsWhatIsDoneRunningLostAndWaiting) {
  const scene::Preset preset = study_of_seeds();
  const TemporaryFolder folder;
  StudyOptions gathering = into(folder.path());
  gathering.work = StudyWork::gathering;
  run_of(preset, gathering);
  StudyStatus status = status_of(folder.path());
  const int all = static_cast<int>(preset.study.size());
  EXPECT_EQ(status.scenarios, all);
  EXPECT_EQ(status.waiting(), all);
  base::Claims claims(folder.path() / "claims", "7_1");
  const auto mine = claims.take(claim_of(preset, 0));
  const fs::path lost = folder.path() / "claims" / (claim_of(preset, 1) + ".claim");
  base::write_whole_file(lost, "elsewhere 5 01234567 7_2\n");
  fs::last_write_time(lost, fs::file_time_type::clock::now() - std::chrono::minutes(10));
  status = status_of(folder.path());
  EXPECT_EQ(status.running, 1);
  EXPECT_EQ(status.lost, 1);
  EXPECT_EQ(status.waiting(), all - 2);
  ASSERT_EQ(status.workers.size(), 2U);
  const auto gone = std::find_if(status.workers.begin(), status.workers.end(),
                                 [](const Worker& worker) { return !worker.lives; });
  ASSERT_NE(gone, status.workers.end());
  EXPECT_EQ(gone->host, "elsewhere");
  EXPECT_EQ(gone->label, "7_2");
  EXPECT_NEAR(gone->silent_s, 600, 60);
}

TEST(StudyStatus, OfAWholeStudySaysSo) {
  const scene::Preset preset = study_of_seeds();
  const TemporaryFolder folder;
  run_of(preset, into(folder.path()));
  const StudyStatus status = status_of(folder.path());
  EXPECT_EQ(status.done, status.scenarios);
  EXPECT_EQ(status.waiting(), 0);
  EXPECT_TRUE(std::isnan(status.left_s));
}

}  // namespace
}  // namespace rift::study
