#include "engine/results/run_folder.hpp"

#include "engine/base/files.hpp"
#include "engine/base/world_error.hpp"
#include "engine/results/archive.hpp"
#include "engine/results/run_writer.hpp"
#include "engine/results/verify.hpp"
#include "tests/engine/results/small_run.hpp"
#include "tests/full_disk.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sched.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace rift::results {
namespace {

namespace fs = std::filesystem;

nlohmann::ordered_json header() {
  return {{"version", "0.1.0"}, {"lanes", 1}, {"preset", "[crack]\nvelocity = \"0.5 c_r\"\n"}};
}

void write_some_samples(RunWriter& writer) {
  writer.sample(small_run::sample(10, 0, 0.01));
  writer.sample(small_run::sample(20, 0, 0.02));
  writer.event({1, 0, 1e-7, 0.01, 1e-9});
}

void write_some(RunWriter& writer) {
  writer.frame(small_run::frame(0, 0));
  write_some_samples(writer);
  writer.flush();
}

template <typename Error>
std::string message_of(const fs::path& folder, bool force) {
  try {
    create_run_folder(folder, force);
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(RunFolder, IsMadeWithItsParents) {
  const TemporaryFolder scratch;
  create_run_folder(scratch / "a/b/run", false);
  EXPECT_TRUE(fs::is_empty(scratch / "a/b/run"));
  create_run_folder(scratch / "a/b/run", false);  // empty is as good as none
}

TEST(RunFolder, ThatHoldsAnythingIsNotWrittenInto) {
  const TemporaryFolder scratch;
  write_text(scratch / "journal.rift", "a run");
  EXPECT_EQ(message_of<FolderExists>(scratch.path(), false),
            scratch.path().string() + " exists and is not empty; --force replaces a run in it");
  EXPECT_EQ(read_text(scratch / "journal.rift"), "a run");
}

TEST(RunFolder, ForceRemovesOnlyWhatRiftWrote) {
  const TemporaryFolder scratch;
  const std::vector<std::string> ours{
      "journal.rift",  "run.vtkhdf",           "run.vtkhdf.part",   "series.csv",           "summary.json",
      "checkpoint.h5", "checkpoint-2.h5",      "measure/field.csv", "measure/charts/vy.gp", "csv/series.csv",
      "pvd/run.pvd",   "pvd/frame_000000.vtp", "ovito/run.dump",    "paraview/run.vtkhdf",  "film_uy.mp4",
      "poster_uy.png", "uy_at_0.50.png"};
  const std::vector<std::string> theirs{"notes.md", "checkpoint.txt", "csv/mine.csv", "mine.mp4",
                                        "film/frame_000000.vtp"};
  for (const char* folder : {"csv", "pvd", "ovito", "paraview", "film", "measure/charts"})
    fs::create_directories(scratch / folder);
  for (const auto& name : ours) write_text(scratch / name, "x");
  for (const auto& name : theirs) write_text(scratch / name, "x");
  create_run_folder(scratch.path(), true);
  for (const auto& name : ours) EXPECT_FALSE(fs::exists(scratch / name)) << name;
  for (const auto& name : theirs) EXPECT_TRUE(fs::exists(scratch / name)) << name;
  EXPECT_FALSE(fs::exists(scratch / "pvd")) << "nothing is left in it";
  EXPECT_FALSE(fs::exists(scratch / "measure"));
}

// Its process may have run on another machine, so that nothing says whether it is gone.
TEST(RunFolder, ForceReplacesWhatAProcessKilledWhileItTriedTheFolderHasLeft) {
  const TemporaryFolder scratch;
  write_text(scratch / ".rift_probe.elsewhere-77-0123abcd.part", "rift");
  create_run_folder(scratch.path(), true);
  EXPECT_TRUE(fs::is_empty(scratch.path()));
}

TEST(RunFolder, ForceRefusesAFolderThatHoldsNoRun) {
  const TemporaryFolder scratch;
  write_text(scratch / "thesis.tex", "x");
  EXPECT_EQ(message_of<FolderExists>(scratch.path(), true),
            scratch.path().string() + " holds other files and no run; --force replaces only runs");
  EXPECT_EQ(fs::file_size(scratch / "thesis.tex"), 1U);
}

// A second `rift run --force` beside a run, and beside an export of it.
TEST(RunFolder, IsNotReplacedWhileAnotherWritesIntoIt) {
  const TemporaryFolder scratch;
  const fs::path run = scratch / "run";
  const std::string taken = "cannot write into " + run.string() + ": another process is writing it";
  {
    ClaimedFolder folder(run, false);
    EXPECT_EQ(message_of<base::WorldError>(run, true), taken);
    folder.keep();
    RunWriter writer(run, header(), small_run::geometry());
    write_some(writer);
    EXPECT_EQ(message_of<base::WorldError>(run, true), taken);
    EXPECT_EQ(message_of<base::WorldError>(run, false), taken);
    writer.finish({{"scenarios", nlohmann::json::array()}}, {});
    EXPECT_EQ(message_of<base::WorldError>(run, true), taken);
  }
  {
    const base::OwnedFolder csv(run / "csv");
    EXPECT_EQ(message_of<base::WorldError>(run, true),
              "cannot write into " + run.string() + ": another process is writing csv in it");
  }
  EXPECT_TRUE(fs::exists(run / "summary.json"));
  create_run_folder(run, true);
  EXPECT_TRUE(fs::is_empty(run));
}

TEST(RunFolder, OfARunThatCanGoOnOffersThat) {
  const TemporaryFolder scratch;
  {
    RunWriter writer(scratch.path(), header(), small_run::geometry());
    write_some(writer);
  }
  EXPECT_EQ(message_of<FolderExists>(scratch.path(), false),
            scratch.path().string() + " holds an unfinished run: 'rift resume " + scratch.path().string() +
                "' continues it, --force replaces it");
}

// On a file system without locks nothing keeps another run out.
TEST(RunWriter, EndsWhereAnotherRunHasTakenItsPlace) {
  const TemporaryFolder scratch;
  RunWriter writer(scratch.path(), header(), small_run::geometry());
  write_some(writer);
  const std::uint64_t bytes = writer.journal_bytes();
  fs::remove(scratch / "journal.rift");
  write_text(scratch / "journal.rift", "another run's");
  EXPECT_EQ(writer.journal_bytes(), bytes) << "of its own journal";
  EXPECT_THROW(writer.flush(), base::WorldError);
  EXPECT_THROW(writer.finish({{"scenarios", nlohmann::json::array()}}, {}), base::WorldError);
  EXPECT_EQ(read_text(scratch / "journal.rift"), "another run's");
  EXPECT_FALSE(fs::exists(scratch / "run.vtkhdf"));
  EXPECT_FALSE(fs::exists(scratch / "summary.json"));
}

TEST(RunFolder, ThatCannotBeMadeSaysWhy) {
  const TemporaryFolder scratch;
  write_text(scratch / "file", "");
  const auto below = (scratch / "file" / "run").string();
  EXPECT_EQ(message_of<base::WorldError>(below, false),
            "cannot create the folder " + below + ": Not a directory");
  const auto file = (scratch / "file").string();
  EXPECT_EQ(message_of<base::WorldError>(file, true),
            "cannot create the folder " + file + ": Not a directory");
}

TEST(RunFolder, ThatCannotBeWrittenToIsNoticedAtOnce) {
  const TemporaryFolder scratch;
  std::string message;
  {
    const FullDisk full(0);
    message = message_of<base::WorldError>(scratch.path(), false);
  }
  EXPECT_EQ(message.find("cannot write into " + scratch.path().string() + ": "), 0U) << message;
  EXPECT_TRUE(fs::is_empty(scratch.path())) << "nothing half-written";
}

TEST(RunWriter, CompletesItsFolder) {
  const TemporaryFolder scratch;
  {
    RunWriter writer(scratch.path(), header(), small_run::geometry());
    write_some(writer);
    EXPECT_TRUE(read_text(scratch / "series.csv").ends_with(",5e-12,0,0,,,,\n"));
    writer.finish({{"scenarios", nlohmann::json::array()}}, {{{0.02, 0.5, 0.25, 0.625, 0.75}}});
  }
  const auto series = read_text(scratch / "series.csv");
  EXPECT_TRUE(series.ends_with(",5e-12,0,0,0.5,0.25,0.625,0.75\n")) << series;
  EXPECT_NE(series.find(",5e-12,0,0,,,,\n"), std::string::npos) << "the first sample has no rate";
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(scratch.path())) names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"journal.rift", "run.vtkhdf", "series.csv", "summary.json"}));

  const auto state = inspect_run(scratch.path());
  EXPECT_EQ(state.condition, RunCondition::finished);
  EXPECT_TRUE(state.reason.empty());
  EXPECT_TRUE(state.has_archive);
  EXPECT_EQ(state.last_step, 20);
  EXPECT_EQ(state.summary_json, R"({"scenarios":[]})");
  EXPECT_EQ(nlohmann::json::parse(state.header_json).at("preset"), "[crack]\nvelocity = \"0.5 c_r\"\n");
}

// Only where there are gauges; then beside the series, in the archive, and made anew where it is lost.
TEST(RunWriter, LeavesTheGaugesAsATable) {
  const TemporaryFolder scratch;
  RunWriter writer(scratch.path(), header(), small_run::geometry());
  write_some(writer);
  writer.gauge(
      {.step = 10, .time_s = 0.5, .lane = 1, .gauge = 2, .x_m = 0.25, .vy_m_s = -3, .strain_yy = 0.125});
  writer.finish({{"scenarios", nlohmann::json::array()}}, {});
  const std::string expected =
      "step,time_s,lane,gauge,x_m,y_m,ux_m,uy_m,uz_m,vx_m_s,vy_m_s,vz_m_s,strain_xx,strain_yy,strain_xy\n"
      "10,0.5,1,2,0.25,0,0,0,0,0,-3,0,0,0.125,0\n";
  EXPECT_EQ(read_text(scratch / "gauges.csv"), expected);
  EXPECT_TRUE(is_whole(verify_run(scratch.path(), false)));
  fs::remove(scratch / "gauges.csv");
  EXPECT_FALSE(is_whole(verify_run(scratch.path(), false)));
  EXPECT_TRUE(is_whole(verify_run(scratch.path(), true)));
  EXPECT_EQ(read_text(scratch / "gauges.csv"), expected);
}

TEST(RunWriter, UndefinedSummaryValuesAreNull) {
  const TemporaryFolder scratch;
  RunWriter writer(scratch.path(), header(), small_run::geometry());
  nlohmann::ordered_json scenario{{"ratio", std::nan("")},
                                  {"error_converged", nullptr},
                                  {"ratio_scatter", std::numeric_limits<double>::infinity()},
                                  {"dt_s", 2.35e-8},
                                  {"place", "caf\xe9"}};
  writer.finish({{"scenarios", {scenario}}}, {});
  const auto summary = nlohmann::json::parse(read_text(scratch / "summary.json"));
  const auto& one = summary.at("scenarios").at(0);
  EXPECT_TRUE(one.at("ratio").is_null());
  EXPECT_TRUE(one.at("error_converged").is_null());
  EXPECT_TRUE(one.at("ratio_scatter").is_null());
  EXPECT_EQ(one.at("dt_s").get<double>(), 2.35e-8);
}

/// Mounts `size` bytes of memory as a disk that only this process (and its children) sees.
bool mount_small_disk(const fs::path& at, const char* size) {
  if (unshare(CLONE_NEWNS) != 0 && unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) return false;
  mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr);
  return mount("tmpfs", at.c_str(), "tmpfs", 0, (std::string("size=") + size).c_str()) == 0;
}

constexpr int done = 0, cannot_mount = 77;

/// Leaves `room` bytes of the disk that `folder` is on.
void fill_disk(const fs::path& folder, std::uintmax_t room) {
  fs::remove(folder / "ballast");
  write_text(folder / "ballast", std::string(fs::space(folder).available - room, 'x'));
}

/// What the test below does, in a process of its own: a mount must not leak into the other tests.
[[noreturn]] void finish_on_a_full_disk(const fs::path& folder) {
  if (!mount_small_disk(folder, "8m")) _exit(cannot_mount);
  const auto expect = [](bool holds, const std::string& claim) {
    if (holds) return;
    std::fputs((claim + "\n").c_str(), stderr);
    _exit(1);
  };
  // Frames large enough to fail while they are appended, small ones only when the file is closed.
  Geometry geometry{{}, {}, {{0, 1}}, {0}};
  Frame frame;
  for (int i = 0; i < 20000; ++i) {
    geometry.position.push_back({std::sin(static_cast<float>(i)), 0, 0});
    geometry.radius.push_back(1);
    frame.displacement.push_back({std::cos(static_cast<float>(i)), 0, 0});
  }
  frame.damage_factor = {1};
  RunWriter writer(folder, header(), geometry);
  write_some_samples(writer);
  for (frame.step = 0; frame.step < 5; ++frame.step) writer.frame(frame);
  writer.flush();
  fill_disk(folder, 16384);
  try {
    writer.finish({{"scenarios", nlohmann::json::array()}}, {});
    expect(false, "a full disk went unnoticed");
  } catch (const base::WorldError& error) {
    expect(std::string(error.what()).find("run.vtkhdf") != std::string::npos, error.what());
  }
  expect(inspect_run(folder).condition == RunCondition::finished, "the journal is not whole");

  // Wherever the disk ends, the library is left in order: the same process can try again until there is room.
  int failures = 0;
  for (std::uintmax_t room = 4096; !fs::exists(folder / "run.vtkhdf"); room += 12288) {
    fill_disk(folder, room);
    try {
      assemble_archive(folder);
    } catch (const base::WorldError&) {
      ++failures;
      for (const auto& entry : fs::directory_iterator(folder))
        expect(base::target_name(entry.path().filename()) != "run.vtkhdf", "half a file is left");
    }
  }
  expect(failures > 10, "the disk was not full often enough: " + std::to_string(failures));
  expect(inspect_run(folder).has_archive, "no archive");
  std::exit(done);  // not _exit: the library's own end must work too
}

TEST(RunWriter, AFullDiskAtTheEndLeavesNoHalfFile) {
  const TemporaryFolder scratch;
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) finish_on_a_full_disk(scratch.path());
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status)) << "killed by signal " << WTERMSIG(status);
  if (WEXITSTATUS(status) == cannot_mount) GTEST_SKIP() << "mounting a small disk is not allowed here";
  EXPECT_EQ(WEXITSTATUS(status), done);
}

TEST(RunState, AKilledRunSaysWhatItIsAndHowFarItCame) {
  const TemporaryFolder scratch;
  int ready[2];
  ASSERT_EQ(pipe(ready), 0);
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    RunWriter writer(scratch.path(), header(), small_run::geometry());
    for (std::int64_t step = 1;; ++step) {
      writer.sample(small_run::sample(step, 0, 1e-5 * static_cast<double>(step)));
      writer.frame(small_run::frame(step, 0));
      writer.flush();
      if (step == 1000 && write(ready[1], "x", 1) != 1) _exit(1);
    }
  }
  char byte = 0;
  ASSERT_EQ(read(ready[0], &byte, 1), 1);
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  close(ready[0]);
  close(ready[1]);

  const auto state = inspect_run(scratch.path());
  EXPECT_EQ(state.condition, RunCondition::unfinished);
  EXPECT_FALSE(state.reason.empty());
  EXPECT_GE(state.last_step, 1000);
  EXPECT_GE(state.samples, 1000);
  EXPECT_EQ(nlohmann::json::parse(state.header_json).at("version"), "0.1.0");
  EXPECT_FALSE(state.summary_json.has_value());
  assemble_archive(scratch.path());
}

TEST(RunState, DamageIsTold) {
  const TemporaryFolder scratch;
  {
    RunWriter writer(scratch.path(), header(), small_run::geometry());
    write_some(writer);
  }
  const auto before = inspect_run(scratch.path());
  EXPECT_EQ(before.condition, RunCondition::unfinished);
  auto bytes = read_text(scratch / "journal.rift");
  bytes[bytes.size() - 4] ^= 1;  // within the checksum of the event
  write_text(scratch / "journal.rift", bytes);
  const auto state = inspect_run(scratch.path());
  EXPECT_EQ(state.condition, RunCondition::damaged);
  EXPECT_EQ(state.samples, 2);
  EXPECT_EQ(state.last_step, 20);
  EXPECT_LT(state.good_bytes, before.good_bytes);
  EXPECT_EQ(state.reason, "the record at byte " + std::to_string(state.good_bytes) + " is damaged");
}

TEST(RunState, OtherFoldersAreNoRuns) {
  const TemporaryFolder scratch;
  EXPECT_EQ(inspect_run(scratch.path()).condition, RunCondition::not_a_run);
  EXPECT_EQ(inspect_run(scratch / "none").reason, (scratch / "none").string() + " holds no journal.rift");
  write_text(scratch / "journal.rift", "something else altogether");
  EXPECT_EQ(inspect_run(scratch.path()).condition, RunCondition::not_a_run);
}

}  // namespace
}  // namespace rift::results
