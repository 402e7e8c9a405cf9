#include "engine/results/journal.hpp"

#include "engine/base/world_error.hpp"
#include "engine/results/journal_index.hpp"
#include "engine/results/series.hpp"
#include "tests/engine/results/small_run.hpp"
#include "tests/expectations.hpp"
#include "tests/full_disk.hpp"

#include <cstring>
#include <limits>
#include <utility>

#define XXH_INLINE_ALL
#include <gtest/gtest.h>
#include <xxhash.h>

namespace rift::results {
namespace {

namespace fs = std::filesystem;

/// Every kind of record, in the order of a run.
std::vector<Record> all_kinds() {
  auto sample = small_run::sample(1, 0, 0.05);
  sample.phase = Phase::hold;
  return {RunHeader{R"({"version":"0.1.0","lanes":2})"},
          small_run::geometry(),
          sample,
          small_run::frame(1, 0),
          small_run::frame(1, 1),
          ReleaseEvent{2, 1, 3e-6, 0.07, 4.5e-9},
          RateCurve{1, {{0.05, 0.1, 0.2, 0.3, 0.4}, {0.06, 1, 2, 3, 4}}},
          RunEnd{R"({"scenarios":[]})"}};
}

/// The journal of all kinds, and where each of its records ends.
std::pair<std::string, std::vector<std::size_t>> whole_journal(const fs::path& path) {
  fs::remove(path);
  std::vector<std::size_t> ends;
  {
    JournalWriter writer(path);
    ends.push_back(fs::file_size(path));
    for (const auto& record : all_kinds()) {
      writer.write(record);
      writer.flush();
      ends.push_back(fs::file_size(path));
    }
    writer.close();
  }
  return {read_text(path), ends};
}

struct Reading {
  std::vector<std::string> payloads;
  std::uint64_t good_bytes;
  JournalState state;
  std::string reason;
};

Reading read_all(const fs::path& path) {
  JournalReader reader(path);
  Reading reading{};
  while (const auto record = reader.next()) reading.payloads.push_back(encode(*record));
  EXPECT_FALSE(reader.next().has_value()) << "nothing comes after the end";
  reading.good_bytes = reader.good_bytes();
  reading.state = reader.state();
  reading.reason = reader.reason();
  return reading;
}

/// The first `count` payloads of the whole journal, and no more, were read.
void expect_first(const Reading& reading, std::size_t count) {
  const auto all = all_kinds();
  ASSERT_EQ(reading.payloads.size(), count);
  for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(reading.payloads[i], encode(all[i]));
}

/// A record as a writer would lay it out, checksums right, whatever it says.
std::string forged(std::uint32_t kind, const std::string& payload, std::uint64_t claimed_size) {
  const std::uint64_t both[2] = {kind, claimed_size};
  const auto check = static_cast<std::uint32_t>(XXH3_64bits(both, sizeof(both)));
  const std::uint64_t checksum = XXH3_64bits(payload.data(), payload.size());
  std::string bytes(16, '\0');
  std::memcpy(bytes.data(), &kind, 4);
  std::memcpy(bytes.data() + 4, &check, 4);
  std::memcpy(bytes.data() + 8, &claimed_size, 8);
  bytes += payload;
  bytes.append(reinterpret_cast<const char*>(&checksum), 8);
  return bytes;
}

TEST(Journal, EveryKindComesBackAsItWas) {
  const TemporaryFolder scratch;
  whole_journal(scratch / "j");
  JournalReader reader(scratch / "j");

  EXPECT_EQ(std::get<RunHeader>(*reader.next()).json, R"({"version":"0.1.0","lanes":2})");
  const auto geometry = std::get<Geometry>(*reader.next());
  EXPECT_EQ(geometry.position, small_run::geometry().position);
  EXPECT_EQ(geometry.radius, small_run::geometry().radius);
  EXPECT_EQ(geometry.beam, small_run::geometry().beam);
  EXPECT_EQ(geometry.crossing, small_run::geometry().crossing);
  const auto sample = std::get<Sample>(*reader.next());
  EXPECT_EQ(sample.step, 1);
  EXPECT_EQ(sample.phase, Phase::hold);
  EXPECT_EQ(sample.time_s, 1e-8);
  for (const auto& column : not_empty(sample_columns))
    EXPECT_EQ(sample.*column.value, small_run::sample(1, 0, 0.05).*column.value) << column.name;
  const auto frame = std::get<Frame>(*reader.next());
  EXPECT_EQ(frame.displacement, small_run::frame(1, 0).displacement);
  EXPECT_EQ(frame.velocity, small_run::frame(1, 0).velocity);
  EXPECT_EQ(frame.damage_factor, small_run::frame(1, 0).damage_factor);
  EXPECT_EQ(std::get<Frame>(*reader.next()).lane, 1);
  const auto event = std::get<ReleaseEvent>(*reader.next());
  EXPECT_EQ(event.beam, 2);
  EXPECT_EQ(event.energy_j, 4.5e-9);
  const auto curve = std::get<RateCurve>(*reader.next());
  EXPECT_EQ(curve.lane, 1);
  ASSERT_EQ(curve.points.size(), 2U);
  EXPECT_EQ(curve.points[1].ratio_paper, 3);
  EXPECT_EQ(curve.points[1].ratio_difference, 4);
  EXPECT_EQ(std::get<RunEnd>(*reader.next()).summary_json, R"({"scenarios":[]})");
  EXPECT_FALSE(reader.next().has_value());
  EXPECT_EQ(reader.state(), JournalState::whole);
  EXPECT_EQ(reader.good_bytes(), fs::file_size(scratch / "j"));
}

/// The journal of all kinds as version 1 of the format had it: the same bytes, and other meanings of the
/// rates.
void write_version_1(const fs::path& path) {
  std::string bytes = whole_journal(path).first;
  bytes[8] = 1;
  write_text(path, bytes);
}

RateCurve rates_in(const fs::path& path) {
  JournalReader reader(path);
  while (const auto record = reader.next())
    if (const auto* curve = std::get_if<RateCurve>(&*record)) return *curve;
  return {};
}

void expect_rates_of_version_1(const RateCurve& curve) {
  ASSERT_EQ(curve.points.size(), 2U);
  const RatePoint& p = curve.points[1];  // 0.06, balance 1, fracture 2, with damping 3, without rotation 4
  EXPECT_EQ(p.tip_m, 0.06);
  EXPECT_EQ(p.ratio, 3);
  EXPECT_EQ(p.ratio_fracture, 2);
  EXPECT_EQ(p.ratio_paper, 4 + (3 - 1));
  EXPECT_EQ(p.ratio_difference, 1 - 2);
}

TEST(Journal, OfVersion1IsReadAndSalvagedWithItsRatesUnderTheirPresentNames) {
  const TemporaryFolder scratch;
  write_version_1(scratch / "j");
  expect_rates_of_version_1(rates_in(scratch / "j"));
  EXPECT_EQ(salvage_journal(scratch / "j", scratch / "salvaged"), 0U);
  EXPECT_EQ(read_text(scratch / "salvaged")[8], 2);
  expect_rates_of_version_1(rates_in(scratch / "salvaged"));
}

TEST(Journal, OfVersion1IsGoneOnWithAsOneOfThisVersion) {
  const TemporaryFolder scratch;
  write_version_1(scratch / "j");
  const auto ends = whole_journal(scratch / "other").second;
  {
    JournalWriter writer(scratch / "j", ends[6]);  // behind the event, before the rates
    writer.write(all_kinds()[6]);
    writer.close();
  }
  EXPECT_EQ(rates_in(scratch / "j").points.at(1).ratio, 1);
  EXPECT_EQ(read_all(scratch / "j").state, JournalState::whole);
}

TEST(Journal, StartsAsDocumented) {
  const TemporaryFolder scratch;
  const auto [bytes, ends] = whole_journal(scratch / "j");
  EXPECT_EQ(bytes.substr(0, 16), std::string("RIFTJRNL\2\0\0\0\0\0\0\0", 16));
  const std::string header = R"({"version":"0.1.0","lanes":2})";
  EXPECT_EQ(bytes.substr(16, ends[1] - 16), forged(1, header, header.size()));
}

TEST(Journal, CutAtAnyByteKeepsAllWholeRecordsBefore) {
  const TemporaryFolder scratch;
  const auto [bytes, ends] = whole_journal(scratch / "whole");
  ASSERT_FALSE(bytes.empty());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    SCOPED_TRACE(size);
    write_text(scratch / "cut", bytes.substr(0, size));
    std::size_t whole = 0;
    while (whole + 1 < ends.size() && ends[whole + 1] <= size) ++whole;
    const auto reading = read_all(scratch / "cut");
    expect_first(reading, whole);
    const bool between = size == ends[whole];
    EXPECT_EQ(reading.state, between ? JournalState::whole : JournalState::truncated);
    EXPECT_EQ(reading.good_bytes, size < ends[0] ? 0 : ends[whole]);
    EXPECT_EQ(reading.reason.empty(), between);
  }
}

TEST(Journal, AnyFlippedByteEndsTheReadingAtItsRecord) {
  const TemporaryFolder scratch;
  const auto [bytes, ends] = whole_journal(scratch / "whole");
  ASSERT_FALSE(bytes.empty());
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    SCOPED_TRACE(at);
    auto flipped = bytes;
    flipped[at] = static_cast<char>(flipped[at] ^ 0x5a);
    write_text(scratch / "flipped", flipped);
    std::size_t whole = 0;
    while (whole + 1 < ends.size() && ends[whole + 1] <= at) ++whole;
    const auto reading = read_all(scratch / "flipped");
    expect_first(reading, whole);
    EXPECT_EQ(reading.state, at < ends[0] ? JournalState::foreign : JournalState::damaged);
    EXPECT_EQ(reading.good_bytes, at < ends[0] ? 0 : ends[whole]);
    EXPECT_FALSE(reading.reason.empty());
  }
}

TEST(Journal, SizesThatLieAllocateNothingBeyondTheFile) {
  // Each of these would need up to 2^64 bytes if believed; an attempt would throw bad_alloc or length_error.
  const TemporaryFolder scratch;
  const auto [bytes, ends] = whole_journal(scratch / "j");
  constexpr auto huge = std::numeric_limits<std::uint64_t>::max();
  for (const std::uint64_t claimed : {huge, huge - 23, huge / 2, std::uint64_t{1} << 40}) {
    write_text(scratch / "j", bytes + forged(4, "short", claimed));
    const auto reading = read_all(scratch / "j");
    expect_first(reading, all_kinds().size());
    EXPECT_EQ(reading.state, JournalState::truncated);
  }
}

TEST(Journal, CountsThatLieInsideAPayloadAreDamage) {
  const TemporaryFolder scratch;
  const auto [bytes, ends] = whole_journal(scratch / "j");
  auto frame = encode(small_run::frame(1, 0));
  for (const std::uint64_t count : {std::uint64_t{5}, std::uint64_t{1} << 61, ~std::uint64_t{0}}) {
    std::memcpy(frame.data() + 28, &count, 8);  // after step, time, lane and tip: elements displaced
    write_text(scratch / "j", bytes + forged(4, frame, frame.size()));
    const auto reading = read_all(scratch / "j");
    expect_first(reading, all_kinds().size());
    EXPECT_EQ(reading.state, JournalState::damaged);
  }
}

TEST(Journal, RecordsThatMakeNoSenseAreDamage) {
  const TemporaryFolder scratch;
  const auto [bytes, ends] = whole_journal(scratch / "j");
  auto beyond = small_run::geometry();
  beyond.beam[1][1] = 4;
  auto no_such_beam = small_run::geometry();
  no_such_beam.crossing[1] = 3;
  auto radius_missing = small_run::geometry();
  radius_missing.radius.pop_back();
  auto sample = small_run::sample(1, 0, 0);
  sample.lane = -1;
  const std::vector<std::string> senseless = {
      forged(0, "", 0),
      forged(8, "", 0),
      forged(3, "", 0),
      forged(2, encode(beyond), encode(beyond).size()),
      forged(2, encode(no_such_beam), encode(no_such_beam).size()),
      forged(2, encode(radius_missing), encode(radius_missing).size()),
      forged(3, encode(sample), encode(sample).size()),
      forged(3, encode(small_run::sample(1, 0, 0)) + "x", encode(sample).size() + 1),
  };
  ASSERT_FALSE(senseless.empty());
  for (std::size_t i = 0; i < senseless.size(); ++i) {
    SCOPED_TRACE(i);
    write_text(scratch / "j", bytes + senseless[i]);
    const auto reading = read_all(scratch / "j");
    expect_first(reading, all_kinds().size());
    EXPECT_EQ(reading.state, JournalState::damaged);
    EXPECT_NE(reading.reason.find("makes no sense"), std::string::npos) << reading.reason;
  }
}

TEST(Journal, AnotherFileOrVersionIsForeign) {
  const TemporaryFolder scratch;
  for (const std::string& content : {std::string("step,time_s,phase,lane\n"), std::string("R!"),
                                     std::string("RIFTJRNL\3\0\0\0\0\0\0\0", 16)}) {
    write_text(scratch / "j", content);
    EXPECT_EQ(read_all(scratch / "j").state, JournalState::foreign);
  }
}

TEST(Journal, IsNeverOverwritten) {
  const TemporaryFolder scratch;
  write_text(scratch / "j", "mine");
  try {
    JournalWriter writer(scratch / "j");
    FAIL() << "opened an existing file";
  } catch (const base::WorldError& error) {
    EXPECT_EQ(error.what(), "cannot create " + (scratch / "j").string() + ": File exists");
  }
  EXPECT_EQ(read_text(scratch / "j"), "mine");
}

TEST(Journal, CanBeFollowedWhileItGrows) {
  const TemporaryFolder scratch;
  JournalWriter writer(scratch / "j");
  writer.write(small_run::sample(1, 0, 0.01));
  writer.flush();
  JournalReader first(scratch / "j");
  ASSERT_TRUE(first.next().has_value());
  ASSERT_FALSE(first.next().has_value());
  writer.write(small_run::sample(2, 0, 0.02));
  writer.flush();
  JournalReader second(scratch / "j", first.good_bytes());
  EXPECT_EQ(std::get<Sample>(*second.next()).step, 2);
  EXPECT_FALSE(second.next().has_value());
}

TEST(Journal, AFullDiskIsToldAndNothingIsLost) {
  const TemporaryFolder scratch;
  JournalWriter writer(scratch / "j");
  writer.write(small_run::sample(1, 0, 0.01));
  writer.flush();
  writer.write(small_run::frame(2, 0));
  {
    const FullDisk full(fs::file_size(scratch / "j") + 10);
    try {
      writer.flush();
      FAIL() << "a full disk went unnoticed";
    } catch (const base::WorldError& error) {
      EXPECT_EQ(error.what(), "cannot write " + (scratch / "j").string() + ": File too large");
    }
    const auto reading = read_all(scratch / "j");
    EXPECT_EQ(reading.payloads.size(), 1U);
    EXPECT_EQ(reading.state, JournalState::truncated);
  }
  writer.close();  // there is room again: what waited is written where the first attempt stopped
  const auto reading = read_all(scratch / "j");
  EXPECT_EQ(reading.payloads.size(), 2U);
  EXPECT_EQ(reading.state, JournalState::whole);
}

TEST(JournalScan, GathersAllButTheFields) {
  const TemporaryFolder scratch;
  whole_journal(scratch / "j");
  const auto scan = scan_journal(scratch / "j");
  EXPECT_EQ(scan.samples.size(), 1U);
  EXPECT_EQ(scan.events.size(), 1U);
  EXPECT_EQ(scan.rates.size(), 1U);
  EXPECT_EQ(scan.frames, 2);
  EXPECT_EQ(scan.lanes, 2);
  EXPECT_EQ(scan.last_step, 1);
  EXPECT_EQ(scan.last_time_s, small_run::frame(1, 1).time_s);
  EXPECT_TRUE(scan.summary_json.has_value());
}

TEST(JournalScan, GivesTheLanesOfAMomentTogether) {
  const TemporaryFolder scratch;
  {
    JournalWriter writer(scratch / "j");
    writer.write(small_run::geometry());
    for (const auto& [step, lane] : {std::pair{0, 0}, {0, 1}, {5, 0}, {5, 1}, {9, 1}}) {
      writer.write(small_run::frame(step, lane));
      writer.write(small_run::sample(step, lane, 0.1));  // other records in between part nothing
    }
    writer.close();
  }
  std::vector<std::pair<std::int64_t, std::size_t>> moments;
  for_each_moment(scratch / "j", small_run::geometry(), [&](std::span<const Frame> frames) {
    moments.emplace_back(frames.front().step, frames.size());
  });
  const std::vector<std::pair<std::int64_t, std::size_t>> expected{{0, 2}, {5, 2}, {9, 1}};
  EXPECT_EQ(moments, expected);
}

TEST(JournalScan, OfTwoFramesOfALaneAtOneMomentTheLaterHolds) {
  const TemporaryFolder scratch;
  auto later = small_run::frame(1, 0);
  later.displacement[0][0] = 77;
  {
    JournalWriter writer(scratch / "j");
    for (const auto& frame : {small_run::frame(1, 0), small_run::frame(1, 1), later}) writer.write(frame);
    writer.close();
  }
  int moments = 0;
  for_each_moment(scratch / "j", small_run::geometry(), [&](std::span<const Frame> frames) {
    ++moments;
    ASSERT_EQ(frames.size(), 2U);
    EXPECT_EQ(frames[0].displacement[0][0], 77);
    EXPECT_EQ(frames[1].lane, 1);
  });
  EXPECT_EQ(moments, 1);
}

TEST(JournalScan, RefusesAFrameThatDoesNotFitTheGeometry) {
  const TemporaryFolder scratch;
  auto frame = small_run::frame(3, 0);
  frame.damage_factor.push_back(1);
  {
    JournalWriter writer(scratch / "j");
    writer.write(frame);
    writer.close();
  }
  EXPECT_THROW(for_each_moment(scratch / "j", small_run::geometry(), [](auto) {}), base::WorldError);
}

TEST(JournalScan, NamesCarryTheirLaneOnlyAmongSeveral) {
  EXPECT_EQ(lane_name("displacement", 0, 1), "displacement");
  EXPECT_EQ(lane_name("displacement", 0, 4), "displacement_lane0");
  EXPECT_EQ(lane_name("displacement", 3, 4), "displacement_lane3");
}

// Journals from before the last two columns hold samples that are so much shorter.
TEST(Records, OlderSamplesLackTheLastColumns) {
  Sample sample = small_run::sample(1, 0, 0.05);
  sample.contact_j = 2.5, sample.grip_force_n = -7.0;
  const std::uint32_t kind = kind_of(sample);
  const std::string bytes = encode(sample);
  const auto now = std::get<Sample>(*decode(kind, bytes));
  EXPECT_EQ(now.contact_j, 2.5);
  EXPECT_EQ(now.grip_force_n, -7.0);
  const auto former = std::get<Sample>(*decode(kind, bytes.substr(0, bytes.size() - 2 * sizeof(double))));
  EXPECT_EQ(former.residual, sample.residual);
  EXPECT_EQ(former.contact_j, 0.0);
  EXPECT_EQ(former.grip_force_n, 0.0);
  EXPECT_FALSE(decode(kind, bytes.substr(0, bytes.size() - 4)));
}

}  // namespace
}  // namespace rift::results
