#include "engine/results/run_folder.hpp"
#include "tests/studio/commands/tiny_plate.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <sstream>
#include <vector>

namespace rift::studio {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

Json summary_in(const fs::path& folder) { return Json::parse(read_text(folder / "summary.json")); }

TEST(Run, LeavesTheFourFilesOfARun) {
  const TinyPlate plate;
  const Ran ran = plate.run();
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  for (const char* file : {"journal.rift", "series.csv", "run.vtkhdf", "summary.json"})
    EXPECT_GT(fs::file_size(plate.out() / file), 1000U) << file;
  EXPECT_EQ(std::distance(fs::directory_iterator(plate.out()), fs::directory_iterator()), 4);
  const results::RunState state = results::inspect_run(plate.out());
  EXPECT_EQ(state.condition, results::RunCondition::finished) << state.reason;
  EXPECT_EQ(state.frames, 4);
  EXPECT_TRUE(contains(ran.out, "G_ID / G_I0"));
  EXPECT_TRUE(contains(ran.out, plate.out().string() + "/  summary.json, series.csv, run.vtkhdf"));
  EXPECT_EQ(ran.err.find('\x1b'), std::string::npos);  // progress at most, plain
}

// interface.md, "A run's folder".
TEST(Run, SummaryHoldsEveryNameOfTheInterface) {
  const TinyPlate plate;
  ASSERT_EQ(plate.run().exit_code, 0);
  const Json summary = summary_in(plate.out());
  ASSERT_EQ(summary.at("scenarios").size(), 1U);
  const Json& scenario = summary.at("scenarios")[0];
  std::istringstream names(
      "crack_velocity_over_cr technique relaxation relaxation_name damage_zone_ratio damping_alpha "
      "damping_region "
      "stiffness plane kinematics precision beta seed elements layers beams rattlers coordination "
      "solid_fraction "
      "mean_radius_m thickness_m young_modulus_pa poisson_ratio density_kg_m3 rayleigh_speed_m_s "
      "micro_young_modulus_pa micro_radius_ratio dt_s dt_critical_s dt_fraction steps steps_per_beam threads "
      "simd "
      "lanes version g_i0_j_m2 g_id_j_m2 ratio ratio_fracture ratio_paper ratio_difference "
      "ratio_scatter ratio_trend window_over_length broberg freund strip error_broberg error_converged energy_initial_j "
      "energy_elastic_j energy_kinetic_translation_j energy_kinetic_rotation_j energy_step_correction_j "
      "energy_fracture_j energy_damping_j energy_numerical_damping_j work_external_j ledger_residual "
      "ledger_limit ledger_closes outcome "
      "wall_packing_s wall_prestress_s wall_fracture_s wall_pass_s wall_total_s cost_s element_steps_per_s "
      "beam_steps_per_s memory_peak_bytes tips g_i0_reference echo_free_over_length left_out");
  for (std::string name; names >> name;) EXPECT_TRUE(scenario.contains(name)) << name;
  for (const auto& [name, value] : not_empty(scenario).items())
    EXPECT_EQ(value.is_null(), name == "error_converged" || name == "outcome_where" || name == "cost_s")
        << name;
}

TEST(Run, EndsItsTableWithWhatIsLeftOut) {
  const TinyPlate plate;
  const std::string out = plate.run().out;
  EXPECT_TRUE(contains(out,
                       "  left out              damping, numerical damping, ramp, moving grip, corotation, "
                       "contact, step energies, gauges\n"));
  for (const char* line : {"with damping a step would take 1.1 to 2.4 times as long\n",
                           "with numerical damping a step would take 1.4 to 1.5 times as long\n",
                           "with corotation a step would take 4.8 to 7 times as long\n"})
    EXPECT_TRUE(contains(out, line)) << line;
}

TEST(Run, SummaryIsConsistentWithItself) {
  const TinyPlate plate;
  ASSERT_EQ(plate.run("--set damping.alpha=0.001 --set damping.region=surface").exit_code, 0);
  const Json s = summary_in(plate.out()).at("scenarios")[0];
  const auto number = [&](const char* name) { return s.at(name).get<double>(); };
  EXPECT_EQ(s.at("outcome"), "finished");
  EXPECT_EQ(s.at("technique"), "progressive");
  EXPECT_EQ(s.at("damping_region"), "surface");
  EXPECT_EQ(number("relaxation"), 1.0);
  EXPECT_EQ(number("elements"), 900);
  EXPECT_LT(number("ledger_residual"), 1e-10);
  EXPECT_NEAR(number("ratio_difference"), 0.0, 1e-10);
  EXPECT_GT(number("ratio"), number("ratio_fracture"));
  EXPECT_GT(number("ratio_paper"), number("ratio"));
  EXPECT_NEAR(number("g_id_j_m2") / (number("ratio") * number("g_i0_j_m2")), 1.0, 1e-12);
  EXPECT_NEAR(number("error_broberg"), number("ratio") - number("broberg"), 1e-12);
  EXPECT_NEAR(number("dt_fraction"), number("dt_s") / number("dt_critical_s"), 1e-12);
  EXPECT_GT(number("wall_total_s"), number("wall_fracture_s"));
  // Energy is where it went: what was stored is in the lattice, broken, or damped.
  const double now = number("energy_elastic_j") + number("energy_kinetic_translation_j") +
                     number("energy_kinetic_rotation_j") - number("energy_step_correction_j");
  EXPECT_NEAR((now + number("energy_fracture_j") + number("energy_damping_j")) / number("energy_initial_j"),
              1.0,
              1e-6);  // the step correction of the start, 1e-20, and rounding are far below
}

TEST(Run, SaysOfTwoTipsThatTheyAreTwo) {
  const TinyPlate plate;
  const Ran ran =
      plate.run("--set crack.tips=2 --set output.g_i0_reference=griffith --set 'output.window=[0.1, 0.5]'");
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(contains(ran.out, "0.5 c_R, two tips, progressive release"));
  EXPECT_TRUE(contains(ran.out, "half length 0.1 to 0.5 of the length"));
  EXPECT_TRUE(contains(ran.out, "first boundary reflection reaches the tip at 0.056 of the length"));
  EXPECT_TRUE(contains(ran.out, "kJ/m² (griffith, mean)"));
}

TEST(Run, SimpleReleaseLeavesNullWhatDoesNotApply) {
  const TinyPlate plate;
  ASSERT_EQ(plate.run("--set crack.technique=simple").exit_code, 0);
  const Json s = summary_in(plate.out()).at("scenarios")[0];
  for (const char* name : {"relaxation", "relaxation_name", "damage_zone_ratio", "steps_per_beam"})
    EXPECT_TRUE(s.at(name).is_null()) << name;
}

TEST(Run, IsTheSameToTheLastBitFromTheCacheAndWithout) {
  const TinyPlate plate(CacheOf::this_test);
  ASSERT_EQ(plate.run().exit_code, 0);
  const std::string series = read_text(plate.out() / "series.csv");
  EXPECT_EQ(summary_in(plate.out()).at("scenarios")[0].at("packing_from_cache"), false);
  ASSERT_EQ(plate.run("--force").exit_code, 0);
  EXPECT_EQ(summary_in(plate.out()).at("scenarios")[0].at("packing_from_cache"), true);
  EXPECT_EQ(read_text(plate.out() / "series.csv"), series);
  ASSERT_EQ(plate.run("--force --no-cache").exit_code, 0);
  EXPECT_EQ(summary_in(plate.out()).at("scenarios")[0].at("packing_from_cache"), false);
  EXPECT_EQ(read_text(plate.out() / "series.csv"), series);
}

TEST(Run, NotesADamagedCacheFileAndRebuildsIt) {
  const TinyPlate plate(CacheOf::this_test);
  ASSERT_EQ(plate.run().exit_code, 0);
  std::set<std::string> damaged;
  for (const auto& entry : fs::directory_iterator(plate.path() / "cache" / "rift")) {
    std::string bytes = read_text(entry.path());
    bytes[bytes.size() / 3] ^= 1;
    write_text(entry.path(), bytes);
    const std::string name = entry.path().filename().string();
    damaged.insert(name.substr(0, name.find('-')));
  }
  EXPECT_EQ(damaged, (std::set<std::string>{"packing", "statics", "step"}));
  const Ran ran = plate.run("--force");
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_TRUE(contains(ran.err, "cache: " + (plate.path() / "cache" / "rift" / "packing-").string()));
  EXPECT_TRUE(contains(ran.err, "is damaged: its contents are computed again"));
  EXPECT_EQ(plate.run("--force").err, "");
}

TEST(Run, CannotWriteItsCacheAndRunsAllTheSame) {
  const TinyPlate plate(CacheOf::this_test);
  write_text(plate.path() / "cache", "a file in the way");
  const Ran ran = plate.run();
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_TRUE(contains(ran.err, "could not be written, so the next run computes this again"));
}

TEST(RunOut, ThatExistsIsRefusedAndLeftAsItWas) {
  const TinyPlate plate;
  ASSERT_EQ(plate.run().exit_code, 0);
  const std::string summary = read_text(plate.out() / "summary.json");
  const Ran ran = plate.run("--set crack.technique=simple");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(ran.err,
            "rift: " + plate.out().string() + " exists and is not empty; --force replaces a run in it\n");
  EXPECT_EQ(read_text(plate.out() / "summary.json"), summary);
}

const std::string many_steps = "--quiet --checkpoint '0.1 s' --set solver.dt_fraction=0.002 --threads 1 ";

TEST(RunOut, OfAKilledRunOffersToGoOn) {
  const TinyPlate plate;
  plate.run_and_kill("checkpoint.h5", many_steps);
  const Ran ran = plate.run(many_steps);
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_EQ(ran.err, "rift: " + plate.out().string() + " holds an unfinished run: 'rift resume " +
                         plate.out().string() + "' continues it, --force replaces it\n");
}

TEST(RunOut, OfARunThatGoesOnIsNotReplaced) {
  const TinyPlate plate;
  const std::string run = "env " + plate.environment() + " '" RIFT_EXE "' run '" + plate.preset().string() +
                          "' --out '" + plate.out().string() + "' ";
  const Ran ran =
      run_shell("((" + run + many_steps + ">/dev/null; echo first $?) & for k in $(seq 600); do [ -e '" +
                (plate.out() / "series.csv").string() + "' ] && break; sleep 0.02; done; " + run +
                "--quiet --force --set crack.technique=simple >/dev/null; echo second $?; wait)");
  EXPECT_EQ(ran.out, "second 1\nfirst 0\n");
  EXPECT_EQ(ran.err, "rift: cannot write into " + plate.out().string() + ": another process is writing it\n");
  EXPECT_EQ(summary_in(plate.out()).at("scenarios")[0].at("technique"), "progressive");
  EXPECT_EQ(run_rift("verify '" + plate.out().string() + "' --check-only").exit_code, 0);
}

TEST(RunOut, IsReplacedWithForce) {
  const TinyPlate plate;
  ASSERT_EQ(plate.run().exit_code, 0);
  ASSERT_EQ(plate.run("--force --set crack.technique=simple").exit_code, 0);
  EXPECT_EQ(summary_in(plate.out()).at("scenarios")[0].at("technique"), "simple");
}

// --force lets the former run stand until there is something to put in its place.
TEST(RunOut, KeepsTheFormerRunWhereTheNewOneIsBadInput) {
  const TinyPlate plate;
  ASSERT_EQ(plate.run().exit_code, 0);
  const std::string summary = read_text(plate.out() / "summary.json");
  EXPECT_EQ(plate.run("--force --set solver.dt=1e-3").exit_code, 2);
  EXPECT_EQ(read_text(plate.out() / "summary.json"), summary);
}

TEST(RunOut, WithForceStillSparesFilesThatAreNoRun) {
  const TinyPlate plate;
  fs::create_directory(plate.out());
  write_text(plate.out() / "thesis.tex", "years of work");
  const Ran ran = plate.run("--force");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_TRUE(contains(ran.err, "holds other files and no run; --force replaces only runs"));
  EXPECT_EQ(read_text(plate.out() / "thesis.tex"), "years of work");
}

TEST(RunOut, BelowAFileIsAFailureOfTheWorld) {
  const TinyPlate plate;
  write_text(plate.path() / "file", "in the way");
  for (const std::string out : {"file/run", "file"}) {
    const fs::path folder = plate.path() / out;
    const Ran ran = run_rift("run '" + plate.preset().string() + "' --out '" + folder.string() + "'",
                             plate.environment());
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_TRUE(contains(ran.err, folder.string()));
  }
  EXPECT_EQ(read_text(plate.path() / "file"), "in the way");
}

TEST(RunOut, WithoutItRunsAreNumbered) {
  const TinyPlate plate;
  const std::string command =
      "cd '" + plate.path().string() + "' && env " + plate.environment() + " '" RIFT_EXE "' run tiny.toml";
  for (const std::string name : {"tiny", "tiny-2", "tiny-3"}) {
    EXPECT_EQ(run_shell(command).exit_code, 0);
    EXPECT_TRUE(fs::exists(plate.path() / "runs" / name / "summary.json")) << name;
  }
}

struct Mistake {
  const char* arguments;
  const char* message;  // on stderr, as one of its lines
};

class BadInput : public testing::TestWithParam<Mistake> {};

TEST_P(BadInput, IsRefusedWithAMessageAndNothingIsWritten) {
  const TinyPlate plate;
  const std::string arguments = std::string("--quiet ") + GetParam().arguments;
  const Ran ran = plate.run(arguments);
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_EQ(ran.out, "");
  EXPECT_TRUE(contains("\n" + ran.err, std::string("\n") + GetParam().message));
  EXPECT_FALSE(fs::exists(plate.out()));
  const Ran checked = plate.check(arguments);  // the dry run says the same
  EXPECT_EQ(checked.exit_code, 2);
  EXPECT_EQ(checked.err, ran.err);
}

INSTANTIATE_TEST_SUITE_P(
    OfTheIssue, BadInput,
    testing::Values(
        Mistake{"--set specimen.elemants=3", "--set specimen.elemants=3: unknown key"},
        Mistake{"--set specimen.elements=many",
                "--set specimen.elements=many: expected a whole number, got text\n"},
        Mistake{"--set damping.alpha=nan", "--set damping.alpha=nan: must be a finite number\n"},
        Mistake{"--set loading.displacement=inf",
                "--set loading.displacement=inf: must be a finite number\n"},
        Mistake{"--set loading.displacement=-inf",
                "--set loading.displacement=-inf: must be a finite number\n"},
        Mistake{"--set 'specimen.length=-60 mm'", "--set specimen.length=-60 mm: must lie in (0, 100] m\n"},
        Mistake{"--set specimen.elements=0", "--set specimen.elements=0: must lie in [2, 5000000]\n"},
        Mistake{"--set crack.damage_zone_ratio=0",
                "--set crack.damage_zone_ratio=0: must lie in (0, 1000]\n"},
        Mistake{"--set crack.damage_zone_ratio=-1",
                "--set crack.damage_zone_ratio=-1: must lie in (0, 1000]\n"},
        Mistake{"--set 'crack.velocity=0 c_r'", "--set crack.velocity=0 c_r: must lie in (0, 2] c_r\n"},
        Mistake{"--set 'crack.velocity=-0.1 c_r'", "--set crack.velocity=-0.1 c_r: must lie in (0, 2] c_r\n"},
        Mistake{"--set 'crack.velocity=2.01 c_r'", "--set crack.velocity=2.01 c_r: must lie in (0, 2] c_r\n"},
        Mistake{
            "--set crack.velocity=0.5",
            "--set crack.velocity=0.5: needs a speed with its unit, such as \"0.5 c_r\" or \"1100 m/s\"\n"},
        Mistake{"--set 'crack.path=1 um'", "--set crack.path=1 um: crosses no beam of this lattice\n"},
        Mistake{"--set solver.dt=1e-6",
                "--set solver.dt=1e-6: makes a step of 1e-06 s, and the critical step of this lattice is 2."},
        Mistake{"--set 'specimen.thickness=3 mm' --set specimen.layers=2",
                "--set specimen.thickness=3 mm: excludes specimen.layers (--set)"},
        Mistake{"--set specimen.layers=0.3", "--set specimen.layers=0.3: a plate of "},
        Mistake{"--set material.density=700 --set 'material.rayleigh_speed=2200 m/s'",
                "--set material.density=700: excludes material.rayleigh_speed"},
        Mistake{"--set solver.beta=1.05", "--set solver.beta=1.05: must lie in (0, 1]\n"}),
    [](const auto& mistake) { return "Case" + std::to_string(mistake.index); });

TEST(BadInputOfAPreset, IsReportedAllAtOnceWithFileAndLine) {
  const TinyPlate plate;
  write_text(plate.preset(), "[specimen]\nelements = 0\nheight = nan\n[crack]\nvelocity = 0.5\nspeed = 3\n");
  const Ran ran = plate.run();
  EXPECT_EQ(ran.exit_code, 2);
  const std::string name = plate.preset().string();
  for (const std::string line :
       {":2: specimen.elements = 0: must lie in [2, 5000000]\n",
        ":3: specimen.height = nan: must be a finite number\n",
        ":5: crack.velocity = 0.5: needs a speed with its unit", ":6: unknown key 'speed'"})
    EXPECT_TRUE(contains(ran.err, name + line));
  EXPECT_FALSE(fs::exists(plate.out()));
}

TEST(BadInputOfAPreset, ThatIsNotThereNamesWhereToLook) {
  const TinyPlate plate;
  const Ran ran = run_rift("run no/such.toml --out '" + plate.out().string() + "'", plate.environment());
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_TRUE(contains(ran.err, "rift: no such preset 'no/such.toml'"));
  EXPECT_FALSE(fs::exists(plate.out()));
}

TEST(BadInputOfTheCommand, WithoutAPresetIsAUsageError) {
  const Ran ran = run_rift("run");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_EQ(ran.err, "rift run: preset is required\nTry 'rift run --help'.\n");
}

TEST(PrintConfig, IsAPresetThatGivesTheSameAgainAndTheSameRun) {
  const TinyPlate plate;
  const Ran first = plate.run("--print-config --set 'crack.velocity=0.3 c_r' --set output.frames=2");
  EXPECT_EQ(first.exit_code, 0);
  EXPECT_EQ(first.err, "");
  EXPECT_FALSE(fs::exists(plate.out()));
  ASSERT_EQ(plate.run("--set 'crack.velocity=0.3 c_r' --set output.frames=2").exit_code, 0);
  const std::string series = read_text(plate.out() / "series.csv");
  write_text(plate.preset(), first.out);
  EXPECT_EQ(plate.run("--print-config").out, first.out);
  ASSERT_EQ(plate.run("--force").exit_code, 0);
  EXPECT_EQ(read_text(plate.out() / "series.csv"), series);
}

// Runs of minutes on any machine, stopped after two seconds: progress begins after one second.
constexpr const char* long_run =
    "--threads 1 --set solver.dt_fraction=0.003 --set 'crack.velocity=0.01 c_r' --set output.samples=50000";

TEST(RunJson, IsTheSummaryOnStdoutAndJsonLinesOrNothingOnStderr) {
  const TinyPlate plate;
  const Ran ran = plate.run_under("timeout --preserve-status -s INT 2", std::string("--json ") + long_run);
  ASSERT_EQ(ran.exit_code, 130);
  EXPECT_EQ(Json::parse(ran.out), summary_in(plate.out()));
  std::istringstream lines(ran.err);
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    const Json told = Json::parse(line);
    EXPECT_TRUE(told.contains("stage") && told.contains("done") && told.contains("elapsed_s"));
    EXPECT_LE(told.at("done"), 1.0);
  }
  EXPECT_GE(count, 1);
}

TEST(RunProgress, IsPlainLinesWithRateAndFinishClockAwayFromATerminal) {
  const TinyPlate plate;
  const Ran ran = plate.run_under("timeout --preserve-status -s INT 2", long_run);
  ASSERT_EQ(ran.exit_code, 130);
  EXPECT_TRUE(contains(ran.progress, "crack"));
  EXPECT_TRUE(contains(ran.progress, " left, done at "));
  EXPECT_TRUE(contains(ran.progress, "element-steps/s"));
  EXPECT_FALSE(contains(ran.progress + ran.err, "\033"));
  EXPECT_FALSE(contains(ran.progress + ran.err, "\r"));
}

TEST(RunProgress, IsNoneWhenQuiet) {
  const TinyPlate plate;
  const Ran ran = plate.run_under("timeout --preserve-status -s INT 2", std::string("--quiet ") + long_run);
  ASSERT_EQ(ran.exit_code, 130);
  EXPECT_EQ(ran.err, "");
}

TEST(RunStopped, BySignalEndsTheRunInGoodOrder) {
  for (const auto& [signal, number] : {std::pair{"INT", 2}, {"TERM", 15}}) {
    const TinyPlate plate;
    ASSERT_EQ(plate.check().exit_code, 0);  // the packing is in the cache
    const Ran ran = plate.run_under(std::string("timeout --preserve-status -s ") + signal + " 1", long_run);
    EXPECT_EQ(ran.exit_code, 128 + number) << ran.err;
    const Json s = summary_in(plate.out()).at("scenarios")[0];
    EXPECT_EQ(s.at("outcome"), "stopped");
    EXPECT_TRUE(contains(s.at("outcome_where").get<std::string>(), "step "));
    const auto steps = s.at("steps").get<long>();
    EXPECT_GT(steps, 100);
    EXPECT_LT(s.at("ledger_residual"), 1e-10);
    EXPECT_TRUE(s.at("ratio").is_null() || s.at("ratio").is_number());
    const results::RunState state = results::inspect_run(plate.out());
    EXPECT_NE(state.condition, results::RunCondition::damaged) << state.reason;
    EXPECT_GT(state.samples, 10);
    EXPECT_LE(state.last_step, steps);
    EXPECT_TRUE(state.has_archive);
    EXPECT_TRUE(contains(ran.out, "stopped"));
  }
}

TEST(RunStopped, WhilePackingLeavesNoFolder) {
  const TinyPlate plate(CacheOf::this_test);
  const Ran ran =
      plate.run_under("timeout --preserve-status -s INT 0.7",
                      "--set specimen.elements=20000 --set specimen.coordination=6 "
                      "--set specimen.length=0.2 --set specimen.height=0.04 --set crack.end=0.08");
  EXPECT_EQ(ran.exit_code, 130) << ran.err;
  EXPECT_EQ(ran.out, "");
  EXPECT_TRUE(ran.err.ends_with(
      "rift run: stopped while packing: nothing was written; the same command starts from the beginning\n"))
      << ran.err;
  EXPECT_FALSE(fs::exists(plate.out()));
  EXPECT_FALSE(fs::exists(plate.path() / "cache" / "rift"));
}

TEST(RunStopped, ByAKillLeavesAFolderThatSaysWhatItIs) {
  const TinyPlate plate;
  ASSERT_EQ(plate.check().exit_code, 0);
  const Ran ran = plate.run_under("timeout -s KILL 1", long_run);
  EXPECT_EQ(ran.exit_code, 137);
  EXPECT_FALSE(fs::exists(plate.out() / "summary.json"));
  const results::RunState state = results::inspect_run(plate.out());
  EXPECT_EQ(state.condition, results::RunCondition::unfinished) << state.reason;
  EXPECT_GT(state.samples, 10);
  EXPECT_TRUE(contains(state.header_json, "0.003"));  // the preset in effect
  const Ran exported = run_rift("export '" + plate.out().string() + "' --to csv");
  EXPECT_EQ(exported.exit_code, 0) << exported.err;
  const std::string series = read_text(plate.out() / "csv" / "series.csv");
  EXPECT_EQ(std::count(series.begin(), series.end(), '\n'), state.samples + 1);
  EXPECT_EQ(plate.run().exit_code, 2);  // and it is not overwritten silently
}

}  // namespace
}  // namespace rift::studio
