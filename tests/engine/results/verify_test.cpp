#include "engine/results/verify.hpp"

#include "engine/base/ownership.hpp"
#include "engine/base/world_error.hpp"
#include "engine/results/archive.hpp"
#include "engine/results/archive_check.hpp"
#include "engine/results/checkpoint.hpp"
#include "engine/results/journal.hpp"
#include "engine/results/run_writer.hpp"
#include "tests/engine/results/small_run.hpp"
#include "tests/expectations.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <cstdlib>

namespace rift::results {
namespace {

namespace fs = std::filesystem;

/// A finished run of two frames and three samples.
void write_run(const fs::path& folder, bool to_the_end = true) {
  fs::create_directories(folder);
  RunWriter writer(folder, {{"version", "0.1.0"}, {"lanes", 1}, {"preset", ""}}, small_run::geometry());
  writer.frame(small_run::frame(0, 0));
  writer.sample(small_run::sample(10, 0, 0.01));
  writer.sample(small_run::sample(20, 0, 0.02));
  writer.event({1, 0, 1e-7, 0.01, 1e-9});
  writer.frame(small_run::frame(20, 0));
  writer.sample(small_run::sample(30, 0, 0.03));
  writer.flush();
  if (to_the_end) writer.finish({{"scenarios", nlohmann::ordered_json::array()}}, {{{0.02, 1, 1, 1, 1}}});
}

Found found_of(const Verification& v, const std::string& file) {
  for (const Finding& f : v.files)
    if (f.file == file) return f.found;
  ADD_FAILURE() << file << " was not looked at";
  return Found::missing;
}

std::string text_of(const Verification& v, const std::string& file) {
  for (const Finding& f : v.files)
    if (f.file == file) return f.text;
  return "";
}

void flip(const fs::path& path, std::size_t at) {
  std::string bytes = read_text(path);
  bytes.at(at) = static_cast<char>(bytes[at] ^ 0x20);
  write_text(path, bytes);
}

TEST(Verify, OfAFinishedRunFindsItWholeAndChangesNothing) {
  const TemporaryFolder scratch;
  write_run(scratch / "run");
  const std::string archive = read_text(scratch.path() / "run" / archive_name);
  const Verification v = verify_run(scratch / "run", true);
  EXPECT_TRUE(is_whole(v));
  for (const Finding& f : not_empty(v.files)) EXPECT_EQ(f.found, Found::intact) << f.file << ": " << f.text;
  EXPECT_EQ(v.files.size(), 4U);
  EXPECT_EQ(read_text(scratch.path() / "run" / archive_name), archive);
}

TEST(Verify, MakesWhatIsMissingOrWrongAnewAndKeepsTheOld) {
  const TemporaryFolder scratch;
  const fs::path run = scratch / "run";
  write_run(run);
  const std::string series = read_text(run / series_name), summary = read_text(run / summary_name);
  write_text(run / archive_name, read_text(run / archive_name).substr(0, 900));
  write_text(run / series_name, "step\n");
  fs::remove(run / summary_name);
  write_text(run / "run.vtkhdf.part", "half");

  const Verification looked = verify_run(run, false);
  EXPECT_FALSE(is_whole(looked));
  EXPECT_EQ(found_of(looked, archive_name), Found::damaged);
  EXPECT_EQ(found_of(looked, summary_name), Found::missing);
  EXPECT_TRUE(fs::exists(run / "run.vtkhdf.part"));  // nothing was changed
  EXPECT_FALSE(fs::exists(run / summary_name));

  const Verification v = verify_run(run, true);
  EXPECT_TRUE(is_whole(v));
  for (const char* file : {archive_name, series_name, summary_name})
    EXPECT_EQ(found_of(v, file), Found::mended) << file;
  EXPECT_EQ(found_of(v, "run.vtkhdf.part"), Found::removed);
  EXPECT_EQ(read_text(run / series_name), series);
  EXPECT_EQ(read_text(run / summary_name), summary);
  EXPECT_EQ(read_text(run / "series_damaged.csv"), "step\n");
  EXPECT_TRUE(fs::exists(run / "run_damaged.vtkhdf"));
  EXPECT_TRUE(is_whole(verify_run(run, false)));

  create_run_folder(run, true);  // with --force all of it goes
  EXPECT_TRUE(fs::is_empty(run));
}

// A small dataset of the series: the library keeps no checksum of it.
TEST(Verify, SeesAnArchiveWhoseValuesAreNotTheJournals) {
  const TemporaryFolder scratch;
  const fs::path run = scratch / "run";
  write_run(run);
  const std::string archive = read_text(run / archive_name);
  const double tip = 0.02;
  const auto at = archive.find(std::string(reinterpret_cast<const char*>(&tip), sizeof tip));
  ASSERT_NE(at, std::string::npos);
  flip(run / archive_name, at + 3);
  const Verification v = verify_run(run, false);
  EXPECT_EQ(found_of(v, archive_name), Found::damaged);
  EXPECT_NE(text_of(v, archive_name).find("differs from the journal"), std::string::npos)
      << text_of(v, archive_name);
}

TEST(Verify, SavesWhatLiesBehindDamageOfTheJournal) {
  const TemporaryFolder scratch;
  const fs::path run = scratch / "run";
  write_run(run, false);
  const std::string bytes = read_text(run / journal_name);
  const double tip = 0.01;  // of the first sample: in its middle
  flip(run / journal_name, bytes.find(std::string(reinterpret_cast<const char*>(&tip), sizeof tip)));
  Checkpoint late;
  late.notes = "{}", late.journal_bytes = bytes.size();
  write_checkpoint(run, late);

  const Verification v = verify_run(run, true);
  EXPECT_FALSE(is_whole(v));
  EXPECT_EQ(found_of(v, journal_name), Found::damaged);
  EXPECT_NE(text_of(v, journal_name).find("2 samples and 2 frames were saved"), std::string::npos)
      << text_of(v, journal_name);
  EXPECT_EQ(read_text(run / "journal_damaged.rift").size(), bytes.size());
  EXPECT_EQ(found_of(v, checkpoint_name), Found::damaged);  // it would cut the new journal within a record
  EXPECT_FALSE(fs::exists(run / checkpoint_name));
  const RunState state = inspect_run(run);
  EXPECT_EQ(state.condition, RunCondition::unfinished);
  EXPECT_EQ(state.samples, 2);
  EXPECT_EQ(state.frames, 2);
  EXPECT_TRUE(is_whole(verify_run(run, false)));
}

TEST(Verify, OfAnUnfinishedRunMakesAnArchiveOfWhatThereIs) {
  const TemporaryFolder scratch;
  const fs::path run = scratch / "run";
  write_run(run, false);
  EXPECT_TRUE(is_whole(verify_run(run, false)));
  const Verification v = verify_run(run, true);
  EXPECT_TRUE(is_whole(v));
  EXPECT_EQ(found_of(v, archive_name), Found::mended);
  EXPECT_EQ(check_archive(run / archive_name).samples, 3);
}

TEST(Verify, LeavesARunAloneThatIsBeingWritten) {
  const TemporaryFolder scratch;
  const fs::path run = scratch / "run";
  fs::create_directories(run);
  RunWriter writer(run, {{"lanes", 1}}, small_run::geometry());
  write_text(run / "summary.json.part", "half");
  const Verification v = verify_run(run, true);
  EXPECT_TRUE(v.running);
  EXPECT_TRUE(fs::exists(run / "summary.json.part"));
  EXPECT_FALSE(fs::exists(run / archive_name));
}

// As when one run replaced the files of another that went on, and either was killed.
TEST(Verify, KnowsASummaryAnArchiveAndACheckpointOfAnotherRun) {
  const TemporaryFolder scratch;
  const fs::path run = scratch / "run", other = scratch / "other";
  write_run(run, false);
  fs::create_directories(other);
  {
    RunWriter writer(other, {{"version", "0.1.0"}, {"lanes", 1}, {"preset", "other"}}, small_run::geometry());
    writer.finish({{"scenarios", nlohmann::ordered_json::array()}}, {});
  }
  for (const char* name : {archive_name, summary_name}) fs::copy_file(other / name, run / name);
  Checkpoint late;
  late.notes = "{}", late.journal_bytes = fs::file_size(run / journal_name) + 1;
  write_checkpoint(run, late);
  const Verification looked = verify_run(run, false);
  EXPECT_FALSE(is_whole(looked));
  EXPECT_EQ(found_of(looked, summary_name), Found::damaged);
  EXPECT_EQ(found_of(looked, checkpoint_name), Found::damaged);
  EXPECT_EQ(text_of(looked, archive_name), "it belongs to another run");
  (void)verify_run(run, true);
  EXPECT_FALSE(fs::exists(run / summary_name));
  EXPECT_FALSE(fs::exists(run / checkpoint_name));
  EXPECT_TRUE(is_whole(verify_run(run, false)));
}

TEST(Verify, FollowsNoLinkAndLeavesNothingInTheFolderForTemporaryFiles) {
  const TemporaryFolder scratch;
  const fs::path run = scratch / "run", tmp = scratch / "tmp", victim = scratch / "victim";
  write_run(run);
  fs::create_directories(tmp);
  write_text(victim, "mine");
  fs::create_symlink(victim, tmp / fmt::format("rift_verify_{}.vtkhdf", getpid()));
  const char* former = std::getenv("TMPDIR");
  const std::string kept = former == nullptr ? "" : former;
  setenv("TMPDIR", tmp.c_str(), 1);
  const Verification v = verify_run(run, false);
  former == nullptr ? unsetenv("TMPDIR") : setenv("TMPDIR", kept.c_str(), 1);
  EXPECT_TRUE(is_whole(v));
  EXPECT_EQ(read_text(victim), "mine");
  EXPECT_EQ(std::distance(fs::directory_iterator(tmp), fs::directory_iterator()), 1);
}

TEST(Verify, OfAFolderThatAnotherProcessOwnsOnlyLooks) {
  const TemporaryFolder scratch;
  write_run(scratch / "run");
  fs::remove(scratch.path() / "run" / summary_name);
  const base::FolderLock lock(scratch / "run");
  EXPECT_TRUE(verify_run(scratch / "run", true).running);
  EXPECT_FALSE(fs::exists(scratch.path() / "run" / summary_name));
}

TEST(Verify, AJournalOfAnotherVersionIsNamed) {
  const TemporaryFolder scratch;
  const fs::path run = scratch / "run";
  write_run(run);
  flip(run / journal_name, 8);
  const Verification v = verify_run(run, true);
  EXPECT_FALSE(is_whole(v));
  EXPECT_EQ(text_of(v, journal_name), "a journal of version 34, and this build reads versions 1 and 2");
  EXPECT_EQ(found_of(v, archive_name), Found::intact);
}

TEST(Verify, OfNoRunThrows) {
  const TemporaryFolder scratch;
  EXPECT_THROW(verify_run(scratch.path(), true), base::WorldError);
}

TEST(ArchiveCheck, OfAFileThatIsNoArchiveIsAProblem) {
  const TemporaryFolder scratch;
  write_text(scratch / "x", "no archive");
  EXPECT_FALSE(check_archive_in_child(scratch / "x").problems.empty());
}

}  // namespace
}  // namespace rift::results
