#include "engine/results/journal_index.hpp"

#include "engine/base/world_error.hpp"
#include "tests/engine/results/small_run.hpp"

#include <gtest/gtest.h>

namespace rift::results {
namespace {

namespace fs = std::filesystem;

constexpr const char* two_lanes = R"({"lanes":2})";

/// Two lanes with frames at steps 1, 2 and 3, and a sample at each.
void write_steps(JournalWriter& writer, std::int64_t first, std::int64_t last) {
  for (std::int64_t step = first; step <= last; ++step)
    for (const int lane : {0, 1}) {
      writer.write(small_run::sample(step, lane, 0.01 * static_cast<double>(step)));
      writer.write(small_run::frame(step, lane));
    }
  writer.flush();
}

TEST(JournalIndex, GivesEveryFrameInAnyOrder) {
  const TemporaryFolder scratch;
  JournalWriter writer(scratch / "journal.rift");
  writer.write(RunHeader{two_lanes});
  writer.write(small_run::geometry());
  write_steps(writer, 1, 3);
  const JournalIndex index(scratch / "journal.rift");
  EXPECT_EQ(index.header_json(), two_lanes);
  EXPECT_EQ(index.geometry().beam.size(), 3U);
  EXPECT_EQ(index.lanes(), 2);
  for (const int lane : {1, 0}) {
    ASSERT_EQ(index.frames(lane).size(), 3U);
    ASSERT_EQ(index.samples(lane).size(), 3U);
    for (const int k : {2, 0, 1}) {
      const FrameEntry& entry = index.frames(lane)[k];
      EXPECT_EQ(entry.step, k + 1);
      EXPECT_DOUBLE_EQ(entry.time_s, 1e-6 * (k + 1));
      EXPECT_DOUBLE_EQ(entry.tip_m, 0.1);
      EXPECT_EQ(encode(Record(index.frame(entry))), encode(Record(small_run::frame(k + 1, lane))));
    }
  }
}

TEST(JournalIndex, SeesWhatARunHasAddedSince) {
  const TemporaryFolder scratch;
  JournalWriter writer(scratch / "journal.rift");
  writer.write(RunHeader{two_lanes});
  writer.write(small_run::geometry());
  write_steps(writer, 1, 1);
  JournalIndex index(scratch / "journal.rift");
  EXPECT_EQ(index.frames(1).size(), 1U);
  write_steps(writer, 2, 3);
  EXPECT_EQ(index.frames(1).size(), 1U);
  index.extend();
  EXPECT_EQ(index.frames(1).size(), 3U);
  EXPECT_EQ(index.summary_json(), std::nullopt);
  writer.write(RunEnd{"{}"});
  writer.flush();
  index.extend();
  EXPECT_EQ(index.summary_json(), "{}");
  EXPECT_EQ(index.samples(0).size(), 3U);
}

TEST(JournalIndex, GoesOnFromWhereARecordWasCutShort) {
  const TemporaryFolder scratch;
  {
    JournalWriter writer(scratch / "whole");
    writer.write(RunHeader{two_lanes});
    writer.write(small_run::geometry());
    write_steps(writer, 1, 2);
  }
  const std::string bytes = read_text(scratch / "whole");
  write_text(scratch / "journal.rift", bytes.substr(0, bytes.size() - 5));
  JournalIndex index(scratch / "journal.rift");
  EXPECT_EQ(index.state(), JournalState::truncated);
  EXPECT_EQ(index.frames(1).size(), 1U);
  write_text(scratch / "journal.rift", bytes);
  index.extend();
  EXPECT_EQ(index.state(), JournalState::whole);
  EXPECT_EQ(index.frames(1).size(), 2U);
}

TEST(JournalIndex, KeepsWhatLiesBeforeDamage) {
  const TemporaryFolder scratch;
  {
    JournalWriter writer(scratch / "journal.rift");
    writer.write(RunHeader{two_lanes});
    writer.write(small_run::geometry());
    write_steps(writer, 1, 2);
  }
  std::string bytes = read_text(scratch / "journal.rift");
  bytes[bytes.size() - 20] ^= 1;
  write_text(scratch / "journal.rift", bytes);
  const JournalIndex index(scratch / "journal.rift");
  EXPECT_EQ(index.state(), JournalState::damaged);
  EXPECT_NE(index.reason(), "");
  EXPECT_EQ(index.frames(0).size(), 2U);
  EXPECT_EQ(index.frames(1).size(), 1U);
}

TEST(JournalIndex, RefusesWhatHasNoGeometryAndLanesThatAreNotThere) {
  const TemporaryFolder scratch;
  EXPECT_THROW(JournalIndex(scratch / "nothing"), base::WorldError);
  {
    JournalWriter writer(scratch / "bare");
    writer.write(RunHeader{"{}"});
  }
  EXPECT_THROW(JournalIndex(scratch / "bare"), base::WorldError);
  {
    JournalWriter writer(scratch / "lanes");
    writer.write(RunHeader{two_lanes});
    writer.write(small_run::geometry());
    writer.write(small_run::sample(1, 2000000000, 0));
  }
  EXPECT_THROW(JournalIndex(scratch / "lanes"), base::WorldError);
}

TEST(JournalIndex, SaysWhenAFrameIsNotWhereItWas) {
  const TemporaryFolder scratch;
  JournalWriter writer(scratch / "journal.rift");
  writer.write(RunHeader{two_lanes});
  writer.write(small_run::geometry());
  write_steps(writer, 1, 2);
  const JournalIndex index(scratch / "journal.rift");
  FrameEntry moved = index.frames(0)[0];
  moved.step = 17;
  EXPECT_THROW((void)index.frame(moved), base::WorldError);
  moved.offset += 3;
  EXPECT_THROW((void)index.frame(moved), base::WorldError);
}

}  // namespace
}  // namespace rift::results
