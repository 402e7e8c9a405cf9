#include "engine/study/store.hpp"

#include "tests/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace rift::study {
namespace {

TEST(StudyResult, ThatNestsDeepCountsAsAbsentWithANote) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "runs");
  const std::filesystem::path file = result_file(folder.path(), "key");
  write_text(file,
             "{\"key\": \"key\", \"scenario\": " + std::string(100000, '[') + std::string(100000, ']') + "}");
  std::vector<std::string> notes;
  EXPECT_FALSE(read_result(folder.path(), "key", notes));
  EXPECT_EQ(notes, std::vector<std::string>{file.string() + " is damaged and is computed again"});
}

}  // namespace
}  // namespace rift::study
