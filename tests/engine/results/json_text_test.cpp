#include "engine/base/world_error.hpp"
#include "engine/results/archive.hpp"
#include "engine/results/journal.hpp"
#include "engine/results/json_input.hpp"
#include "engine/results/verify.hpp"
#include "tests/engine/results/small_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace rift::results {
namespace {

std::string nested(int depth) { return std::string(depth, '[') + std::string(depth, ']'); }

TEST(JsonText, IsReadToADepthOfSixtyFour) {
  EXPECT_FALSE(json_or_discarded(nested(deepest_json)).is_discarded());
  EXPECT_TRUE(json_or_discarded(nested(deepest_json + 1)).is_discarded());
  EXPECT_EQ(trouble_with_json(nested(100000)), "nests deeper than 64");
  EXPECT_EQ(trouble_with_json(std::string(100000, '{')), "nests deeper than 64");
}

TEST(JsonText, MayHoldAnyNumberOfBracketsInItsStrings) {
  const std::string text =
      "{\"a\\\"" + std::string(1000, '[') + "\": \"" + std::string(1000, '{') + "\\\\\"}";
  EXPECT_EQ(json_or_discarded(text).size(), 1u);
}

TEST(JsonText, MayHoldAnyNumberOfListsSideBySide) {
  std::string text = "[";
  for (int k = 0; k < 1000; ++k) text += "[[1]],";
  EXPECT_EQ(json_or_discarded(text + "0]").size(), 1001u);
}

TEST(JsonText, ThatCannotBeReadIsNamedWithItsPath) {
  const auto said = [](const std::string& text) -> std::string {
    try {
      (void)read_json(text, "runs/a/journal.rift");
    } catch (const base::WorldError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(said("{\"a\": 1}"), "");
  EXPECT_EQ(said("{\"a\": "), "cannot read runs/a/journal.rift: its JSON is damaged");
  EXPECT_EQ(said(nested(100000)), "cannot read runs/a/journal.rift: its JSON nests deeper than 64");
}

/// A journal of a small run whose header and summary are these texts.
void write_journal(const std::filesystem::path& folder, const std::string& header,
                   const std::string& summary) {
  std::filesystem::create_directories(folder);
  JournalWriter writer(folder / journal_name);
  writer.write(RunHeader{header});
  writer.write(small_run::geometry());
  writer.write(small_run::frame(0, 0));
  writer.write(RunEnd{summary});
  writer.close();
}

TEST(Verify, OfAJournalWhoseSummaryNestsDeepNamesIt) {
  const TemporaryFolder scratch;
  const std::filesystem::path run = scratch / "run";
  write_journal(run, "{\"lanes\": 1}", nested(100000));
  const Verification verified = verify_run(run, true);
  EXPECT_FALSE(is_whole(verified));
  EXPECT_TRUE(std::any_of(verified.files.begin(), verified.files.end(), [](const Finding& f) {
    return f.text == "the journal's summary is not valid JSON";
  }));
}

TEST(Verify, OfAJournalWhoseHeaderNestsDeepComesToAnEnd) {
  const TemporaryFolder scratch;
  write_journal(scratch / "run", nested(100000), "{\"scenarios\": []}");
  EXPECT_NO_THROW((void)verify_run(scratch / "run", true));
}

}  // namespace
}  // namespace rift::results
