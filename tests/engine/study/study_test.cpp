#include "engine/base/files.hpp"
#include "engine/results/run_folder.hpp"
#include "engine/results/series.hpp"
#include "engine/simulation/summary.hpp"
#include "engine/study/plan.hpp"
#include "engine/study/runner.hpp"
#include "engine/study/store.hpp"
#include "tests/engine/study/tiny_study.hpp"
#include "tests/expectations.hpp"
#include "tests/shared_cache.hpp"
#include "tests/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <map>
#include <set>

namespace rift::study {
namespace {

/// The whole study in an empty folder: computed once for all test processes, copied from there, and found.
StudyResult found(const fs::path& folder) {
  const fs::path kept = shared_cache_home() / "computed_study";
  if (!fs::exists(kept)) {
    const fs::path mine = kept.string() + "." + std::to_string(::getpid());
    compute(into(mine));
    std::error_code another_was_first;
    fs::rename(mine, kept, another_was_first);
    if (another_was_first) fs::remove_all(mine);
  }
  fs::copy(kept, folder, fs::copy_options::recursive);
  return compute(into(folder));
}

void expect_as_run_alone(const scene::Preset& preset, const StudyResult& result, const fs::path& folder) {
  const std::vector<scene::Scene> scenes = scenes_of_study(preset);
  ASSERT_FALSE(scenes.empty());
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    scene::Preset alone = preset;
    alone.study.clear();
    alone.scene = scenes[k];
    const simulation::Prepared prepared = simulation::prepare(alone, shared_cache());
    const simulation::RunResult run = simulation::march(prepared, {}, {.threads = 1});
    const simulation::Rates rates = simulation::rates_of(prepared, run);
    const Json summary = simulation::summary_of(prepared, run, {rates}, build, 0.0).at("scenarios")[0];
    EXPECT_EQ(lasting(to_json(result.rows[k].value())), lasting(Json::parse(summary.dump()))) << k;
    const results::RateCurve curve{0, rates.curve};
    const fs::path csv = result_file(folder, result_key(scenes[k], build.version)).replace_extension(".csv");
    EXPECT_EQ(read_text(csv), results::series_csv(run.lane[0].samples, {&curve, 1})) << k;
  }
}

TEST(Study, ScenariosOfALoadCurveMarchSideBySide) {  // they have one grip
  std::string text = undamped_text();
  text.replace(text.find("displacement = \"0.6 mm\""), std::string("displacement = \"0.6 mm\"").size(),
               "curve = [[0, \"0.6 mm\"], [\"12 us\", \"0.7 mm\"]]");
  text.replace(text.find("[study]"), std::string::npos,
               "[study]\ncrack_velocity = [\"0.3 c_r\", \"0.5 c_r\"]\n");
  const TemporaryFolder folder;
  const StudyResult result = run_study(preset_from(text), into(folder.path()), shared_cache(), build, {});
  EXPECT_TRUE(result.not_made.empty());
  EXPECT_EQ(result.computed, 2);
}

TEST(Study, ACallThatIsStoppedInAPassIsGoneOnWithFromThere) {
  std::string text = undamped_text();
  text.replace(text.find("[study]"), std::string::npos,
               "[study]\ncrack_velocity = [\"0.002 c_r\", \"0.003 c_r\", \"0.9 c_r\"]\n");
  const scene::Preset preset = preset_from(text);
  const TemporaryFolder folder;
  StudyResult result;
  int calls = 0, stopped = 0;
  do {
    ASSERT_LT(++calls, 10 * patience_s) << "each call begins the pass anew";
    StudyObserver observer;  // stops each call a tenth of a second after its cracks run
    observer.progress = [&](std::string_view stage, double) { return stage != "crack"; };
    result = run_study(preset, into(folder.path()), shared_cache(), build, observer);
    if (result.outcome == simulation::Outcome::stopped) {
      ++stopped;
      EXPECT_TRUE(fs::exists(folder.path() / "passes"));
    }
  } while (result.outcome == simulation::Outcome::stopped);
  EXPECT_GT(stopped, 1);
  EXPECT_EQ(result.outcome, simulation::Outcome::finished);
  EXPECT_FALSE(fs::exists(folder.path() / "passes"));
  expect_as_run_alone(preset, result, folder.path());
  EXPECT_TRUE(shared_cache().notes.empty());
}

TEST(Study, APassThatOtherProcessesHaveEndedMeanwhileIsForgotten) {
  const TemporaryFolder folder;
  StudyObserver observer;
  observer.progress = [&](std::string_view stage, double) { return stage != "crack"; };
  std::string text = undamped_text();
  text.replace(text.find("[study]"), std::string::npos, "[study]\ncrack_velocity = [\"0.004 c_r\"]\n");
  const scene::Preset preset = preset_from(text);
  ASSERT_EQ(run_study(preset, into(folder.path()), shared_cache(), build, observer).outcome,
            simulation::Outcome::stopped);
  fs::rename(folder.path() / "passes", folder.path() / "aside");
  ASSERT_EQ(run_study(preset, into(folder.path()), shared_cache(), build, {}).outcome,
            simulation::Outcome::finished);
  fs::rename(folder.path() / "aside", folder.path() / "passes");
  ASSERT_EQ(run_study(preset, into(folder.path()), shared_cache(), build, {}).found, 1);
  EXPECT_FALSE(fs::exists(folder.path() / "passes"));
}

TEST(Study, GivesEachScenarioBitForBitAsRunAlone) {
  const TemporaryFolder folder;
  const StudyResult result = compute(into(folder.path()));
  EXPECT_EQ(result.outcome, simulation::Outcome::finished);
  EXPECT_EQ(result.computed, static_cast<int>(tiny_study().study.size()));
  std::set<double> steps;
  for (const auto& row : result.rows) steps.insert(row.value().dt_s);
  EXPECT_GT(steps.size(), 1U);  // else this says nothing about steps of their own
  expect_as_run_alone(tiny_study(), result, folder.path());
}

TEST(Study, WithARampGivesEachScenarioBitForBitAsRunAlone) {
  std::string text = undamped_text();
  text.replace(text.find("[crack]"), 7, "method = \"ramp\"\nramp_steps = 1500\nhold_steps = 500\n[crack]");
  const TemporaryFolder folder;
  const scene::Preset preset = preset_from(text);
  const StudyResult result = run_study(preset, into(folder.path()), shared_cache(), build, {});
  expect_as_run_alone(preset, result, folder.path());
}

// In whichever company a scenario marched: the last pass of twelve damped ones is not as full as the others.
TEST(Study, CostIsThatOfTheSchemesKernelAndTheSameForEachStepAndBeamOfIt) {
  const TemporaryFolder scratch;
  const StudyResult result = compute(into(scratch / "study"));
  std::map<bool, std::set<double>> per_step;  // of damped scenarios, and of the others
  for (const auto& row : result.rows) {
    ASSERT_TRUE(row.has_value());
    EXPECT_GT(row->cost_s, 0.0);
    // A float: what is left after rounding is equal.
    per_step[row->damping_alpha > 0.0].insert(static_cast<float>(row->cost_s / (row->steps * row->beams)));
  }
  EXPECT_EQ(per_step[false].size(), 1U);
  EXPECT_EQ(per_step[true].size(), 1U);
  EXPECT_NE(per_step[false], per_step[true]);
}

TEST(Study, RowsSayWhichScenarioTheyAre) {
  const TemporaryFolder folder;
  const scene::Preset preset = tiny_study();
  const StudyResult result = found(folder.path());
  ASSERT_FALSE(result.rows.empty());
  for (std::size_t k = 0; k < result.rows.size(); ++k) {
    EXPECT_EQ(result.rows[k].value().row, static_cast<int>(k));
    EXPECT_EQ(result.rows[k]->axes, preset.study[k].axes);
    EXPECT_FALSE(preset.study[k].axes.empty());
  }
}

TEST(Study, FindsWhatIsThereAndComputesNothingAgain) {
  const TemporaryFolder folder;
  const StudyResult first = found(folder.path());
  int told = 0;
  StudyObserver observer;
  observer.finished = [&](const SummaryRow&, int done, int of) {
    EXPECT_EQ(done, ++told);
    EXPECT_EQ(of, static_cast<int>(first.rows.size()));
  };
  const StudyResult again = compute(into(folder.path()), observer);
  EXPECT_EQ(again.computed, 0);
  EXPECT_EQ(again.found, static_cast<int>(tiny_study().study.size()));
  EXPECT_EQ(told, again.found);
  EXPECT_EQ(to_json(again.rows), to_json(first.rows));  // wall times too: they are those of the computation
}

TEST(Study, StoppedAgainAndAgainComesToTheSame) {
  const TemporaryFolder folder, whole;
  const std::vector<Json> expected = lasting(found(whole.path()).rows);
  StudyResult result;
  int computed = 0, stops = 0;
  do {
    const int allowed = ++stops;
    StudyObserver observer;
    int seen = 0;
    observer.finished = [&](const SummaryRow&, int, int) { ++seen; };
    observer.progress = [&](std::string_view, double) { return seen <= allowed; };
    result = compute(into(folder.path()), observer);
    computed += result.computed;
  } while (result.outcome == simulation::Outcome::stopped && stops < 50);
  EXPECT_EQ(result.outcome, simulation::Outcome::finished);
  EXPECT_EQ(computed, static_cast<int>(expected.size()));  // nothing twice
  EXPECT_EQ(lasting(result.rows), expected);
}

TEST(Study, ProgressNeverGoesBackAndStaysWithinOne) {
  const TemporaryFolder folder;
  double last = 0.0;
  StudyObserver observer;
  observer.progress = [&](std::string_view, double done) {
    EXPECT_GE(done, last);
    EXPECT_LE(done, 1.0);
    last = done;
    return true;
  };
  compute(into(folder.path()), observer);
  EXPECT_GT(last, 0.3);
}

TEST(StudyShards, AreGatheredByAnyCallAndShareOutAllScenarios) {
  const TemporaryFolder folder, whole;
  const std::vector<Json> expected = lasting(found(whole.path()).rows);
  StudyOptions options = into(folder.path());
  options.shards = 3;
  int computed = 0;
  StudyResult last;
  for (const int shard : {3, 1, 2}) {
    options.shard = shard;
    last = compute(options);
    EXPECT_GT(last.computed, 0);
    computed += last.computed;
    EXPECT_EQ(last.computed + last.found, computed);
  }
  EXPECT_EQ(computed, static_cast<int>(expected.size()));
  EXPECT_EQ(lasting(last.rows), expected);
}

TEST(StudyShards, KeepScenariosOfOneLatticeTogether) {
  std::string text = study_text;
  text += "seed = [1, 2, 3, 4]\n";
  const std::vector<StudyItem> items = plan_study(preset_from(text), "0.1.0");
  std::set<int> groups;
  for (int shard = 1; shard <= 4; ++shard)
    for (const StudyItem& item : not_empty(part_of(items, shard, 4))) {
      EXPECT_EQ(item.group, shard - 1);
      groups.insert(item.group);
    }
  EXPECT_EQ(groups.size(), 4U);
}

class DamagedResult : public testing::TestWithParam<const char*> {};

TEST_P(DamagedResult, IsNotedAndComputedAgain) {
  const TemporaryFolder folder;
  const StudyResult first = found(folder.path());
  const scene::Scene scene = scenes_of_study(tiny_study())[2];
  const fs::path file =
      result_file(folder.path(), result_key(scene, build.version)).replace_extension(GetParam());
  const std::string sound = read_text(file);
  std::string text = sound;
  text[text.find("0.", text.size() / 2) + 2] ^= 1;  // one digit becomes another
  for (const std::string& damaged : {text, sound.substr(0, sound.size() / 2), std::string()}) {
    write_text(file, damaged);
    base::Cache cache = shared_cache();
    cache.notes.clear();
    const StudyResult again = run_study(tiny_study(), into(folder.path()), cache, build, {});
    EXPECT_EQ(again.computed, 1);
    EXPECT_EQ(lasting(again.rows), lasting(first.rows));
    ASSERT_EQ(cache.notes.size(), 1U);
    EXPECT_EQ(cache.notes[0], file.string() + " is damaged and is computed again");
  }
}

INSTANTIATE_TEST_SUITE_P(OfEitherFile, DamagedResult, testing::Values(".json", ".csv"),
                         [](const auto& ending) { return std::string(ending.param + 1); });

std::string refusal(const fs::path& folder, const scene::Preset& preset,
                    const simulation::BuildInfo& by = build) {
  try {
    run_study(preset, into(folder), shared_cache(), by, {});
  } catch (const results::FolderExists& error) {
    return error.what();
  }
  return {};
}

TEST(StudyFolder, OfAnotherStudyVersionOrKindIsRefusedAndLeftAsItWas) {
  const TemporaryFolder folder, other;
  found(folder.path());
  const std::string manifest = read_text(folder.path() / "study.json");
  std::string text = study_text;
  text.replace(text.find("0.9 c_r"), 7, "0.8 c_r");
  EXPECT_EQ(
      refusal(folder.path(), preset_from(text)),
      folder.path().string() + " holds another study (of tiny.toml, " +
          std::to_string(tiny_study().study.size()) +
          " scenarios): study.crack_velocity was [\"0.3 c_r\", \"0.9 c_r\"], is now [\"0.3 c_r\", \"0.8 "
          "c_r\"]; nothing was changed: choose another folder with --out");
  EXPECT_EQ(refusal(folder.path(), tiny_study(), {"0.2.0", "a compiler"}),
            folder.path().string() +
                " holds a study of rift 0.1.0, this is rift 0.2.0; nothing was changed: choose another "
                "folder with --out");
  EXPECT_EQ(read_text(folder.path() / "study.json"), manifest);
  write_text(other.path() / "thesis.tex", "years of work");
  EXPECT_EQ(refusal(other.path(), tiny_study()),
            other.path().string() + " is not empty and holds no study: choose another folder with --out");
  EXPECT_EQ(std::distance(fs::directory_iterator(other.path()), fs::directory_iterator()), 1);
}

TEST(StudyFolder, WithADamagedManifestIsGoneOnWith) {
  const TemporaryFolder folder;
  found(folder.path());
  const std::string manifest = read_text(folder.path() / "study.json");
  write_text(folder.path() / "study.json", manifest.substr(0, 40));
  const StudyResult again = compute(into(folder.path()));
  EXPECT_EQ(again.computed, 0);
  EXPECT_EQ(read_text(folder.path() / "study.json"), manifest);
}

TEST(StudyHash, IsOfTheScenariosAndNotOfTheirWording) {
  const scene::Preset preset = tiny_study();
  std::string text = study_text;
  text.replace(text.find("36 mm"), 5, "0.036 m");
  EXPECT_EQ(study_hash(preset_from(text)), study_hash(preset));
  text.replace(text.find("0.036 m"), 7, "37 mm");
  EXPECT_NE(study_hash(preset_from(text)), study_hash(preset));
}

/// The summaries of rows without what a study adds to them, null where there is none.
std::vector<Json> summaries(const auto& rows) {
  std::vector<Json> all;
  for (const auto& row : rows) all.push_back(row ? results::to_json(*row) : Json(nullptr));
  return all;
}

TEST(StoredStudy, IsThePresetAndTheResultsOfItsFolder) {
  const TemporaryFolder folder;
  StudyRows rows = found(folder.path()).rows;
  const StoredStudy whole = read_study(folder.path());
  EXPECT_EQ(study_hash(whole.preset), study_hash(tiny_study()));
  EXPECT_EQ(whole.preset.name, "tiny.toml");
  EXPECT_EQ(summaries(whole.rows), summaries(rows));
  EXPECT_TRUE(whole.notes.empty());
  const auto file_of = [&](std::size_t k) {
    return result_file(folder.path(), result_key(scenes_of_study(tiny_study())[k], build.version));
  };
  fs::remove(file_of(1));
  write_text(file_of(2), "{");
  rows[1] = rows[2] = std::nullopt;
  const StoredStudy part = read_study(folder.path());
  EXPECT_EQ(summaries(part.rows), summaries(rows));
  EXPECT_EQ(part.notes, (std::vector<std::string>{file_of(2).string() + ": damaged"}));
}

TEST(StoredStudy, WithoutAPresetOrDamagedSaysHowToGoOn) {
  const TemporaryFolder folder;
  found(folder.path());
  const fs::path file = folder.path() / "study.json";
  const auto complaint = [&](const std::string& text) {
    write_text(file, text);
    try {
      (void)read_study(folder.path());
      return std::string("was read");
    } catch (const scene::InputError& error) {
      return std::string(error.what());
    }
  };
  Json manifest = Json::parse(read_text(file));
  manifest.erase("preset_text");
  EXPECT_TRUE(contains(complaint(manifest.dump()), "study.json: holds no preset"));
  EXPECT_TRUE(contains(complaint("{"), "study.json: is damaged"));
}

std::string undamped_with(const std::string& axes) {
  std::string text = undamped_text();
  return text.replace(text.find("[study]"), std::string::npos, "[study]\n" + axes);
}

std::vector<int> rows_there(const StudyResult& result) {
  std::vector<int> rows;
  for (const auto& row : result.rows)
    if (row) rows.push_back(row->row);
  return rows;
}

std::string why(const NotMade& one) {
  EXPECT_EQ(one.issues.size(), 1U);
  return scene::to_text(one.issues.at(0));
}

TEST(StudyNotMade, ScenariosOfAStepThatIsTooLongAreNamedAndTheOthersComputed) {
  std::string text = study_text;
  text.erase(text.find("damping_alpha"));
  text += "damping_alpha = [0.1]\ndt_fraction = [0.99, 0.5]\n";
  const TemporaryFolder folder;
  const StudyResult result = run_study(preset_from(text), into(folder.path()), shared_cache(), build, {});
  ASSERT_EQ(result.not_made.size(), 1U);
  EXPECT_EQ(result.not_made[0].rows.size(), 6U);
  EXPECT_TRUE(contains(why(result.not_made[0]), "tiny.toml: solver.dt_fraction = 0.99: makes a step"));
  EXPECT_EQ(rows_there(result).size(), 6U);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path() / "runs"), fs::directory_iterator()), 12);
}

// The lanes of a group: what damping makes of the step counts for those that are damped.
TEST(StudyNotMade, OfOneGroupOnlyTheScenariosThatCannotRunAreMissing) {
  const std::string grid = "damping_alpha = [0, 0.1]\ncrack_velocity = [\"0.5 c_r\", \"0.9 c_r\"]\n";
  std::string text = undamped_with(grid);
  text.insert(text.find("[study]"), "[damping]\nregion = \"surface\"\n[solver]\ndt_fraction = 0.99\n");
  const TemporaryFolder folder;
  const StudyResult result = run_study(preset_from(text), into(folder.path()), shared_cache(), build, {});
  EXPECT_EQ(rows_there(result), (std::vector<int>{0, 1}));
  ASSERT_EQ(result.not_made.size(), 1U);
  EXPECT_EQ(result.not_made[0].rows, (std::vector<int>{2, 3}));
}

TEST(StudyNotMade, ScenariosOfASpecimenOutOfReachHaveOneReasonWithTheNumbers) {
  const TemporaryFolder folder;
  const scene::Preset preset = preset_from(
      undamped_with("layers = [1, 2]\ndt_fraction = [0.4, 0.5]\ncrack_velocity = [\"0.5 c_r\"]\n"));
  const StudyResult result = run_study(preset, into(folder.path()), shared_cache(), build, {});
  EXPECT_EQ(rows_there(result), (std::vector<int>{2, 3}));
  ASSERT_EQ(result.not_made.size(), 1U);
  EXPECT_EQ(result.not_made[0].rows, (std::vector<int>{0, 1}));
  for (const char* part :
       {"a coordination of 5.6 is out of reach", "layers of elements", "or less is within reach"})
    EXPECT_TRUE(contains(why(result.not_made[0]), part)) << part;
  EXPECT_EQ(to_json(result.not_made, preset)[0].at("axes").at("layers"), Json({"1"}));
}

// The second scenario would pack when the first is behind it: further on than any packing of the first.
TEST(StudyNotMade, ASpecimenOutOfReachIsTriedOnce) {
  const TemporaryFolder folder;
  const scene::Preset preset =
      preset_from(undamped_with("layers = [1]\ndt_fraction = [0.4, 0.5]\ncrack_velocity = [\"0.5 c_r\"]\n"));
  PreparationCost preparation;
  double all = 0.0, furthest = 0.0;
  const std::vector<StudyItem> items = plan_study(preset, build.version);
  for (const StudyItem& item : items) all += item.cost + preparation.next(item);
  StudyObserver observer;
  observer.progress = [&](std::string_view, double done) {
    furthest = std::max(furthest, done);
    return true;
  };
  EXPECT_THROW(run_study(preset, into(folder.path()), shared_cache(), build, observer), scene::InputError);
  EXPECT_LE(furthest, packing_share * estimated_preparation(items.front().scene) / all + 1e-9);
}

TEST(StudyNotMade, WhereNoneCanBeMadeTheInputIsWrong) {
  const TemporaryFolder folder;
  const scene::Preset preset = preset_from(undamped_with("layers = [1]\ncrack_velocity = [\"0.5 c_r\"]\n"));
  EXPECT_THROW(run_study(preset, into(folder.path()), shared_cache(), build, {}), scene::InputError);
}

TEST(StudyNotMade, DoesNotHideThatTheStudyWasStopped) {
  const TemporaryFolder folder;
  StudyObserver observer;
  observer.progress = [](std::string_view stage, double) { return stage != "crack"; };
  const scene::Preset preset =
      preset_from(undamped_with("layers = [1, 2]\ncrack_velocity = [\"0.002 c_r\"]\n"));
  const StudyResult result = run_study(preset, into(folder.path()), shared_cache(), build, observer);
  EXPECT_EQ(result.not_made.size(), 1U);
  EXPECT_EQ(result.outcome, simulation::Outcome::stopped);
}

}  // namespace
}  // namespace rift::study
