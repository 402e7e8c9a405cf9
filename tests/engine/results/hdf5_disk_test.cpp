#include "engine/base/world_error.hpp"
#include "engine/results/hdf5.hpp"
#include "tests/engine/results/small_run.hpp"
#include "tests/full_disk.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace rift::results::hdf5 {
namespace {

namespace fs = std::filesystem;

/// Datasets that are compressed and not, that grow, texts and attributes, closed one after the other.
void write_file(const fs::path& path) {
  File file(path);
  {
    Group root = file.root();
    auto rows = root.growing("rows", Number::float64, 64);
    std::vector<double> numbers(100);
    for (int k = 0; k < 40; ++k) {
      for (std::size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = std::sin(static_cast<double>(i) + 100.0 * k);
      rows.append(numbers);
    }
    for (int k = 0; k < 8; ++k) {
      Group group = root.group("group" + std::to_string(k));
      group.write_text("text", std::string(300, 'x'));
      group.write("numbers", numbers);
      group.attribute("count", 100);
    }
  }
  file.close();
}

std::string failure_of(const fs::path& path) {
  try {
    write_file(path);
  } catch (const base::WorldError& error) {
    return error.what();
  }
  return "";
}

/// In a process of its own: how many sizes of the disk did not end in the sentence; the library's end is part
/// of it.
[[noreturn]] void fill_the_disk_again_and_again(const fs::path& path, std::uintmax_t size) {
  int otherwise = 0;
  for (std::uintmax_t room = 0; room + 1 < size; room += 509) {
    const FullDisk disk(room);
    if (failure_of(path).find(path.string() + ": File too large") == std::string::npos) ++otherwise;
  }
  if (!failure_of(path).empty()) ++otherwise;
  std::exit(otherwise);
}

TEST(Hdf5File, SaysWhereverTheDiskEndsThatItIsFullAndEndsInOrder) {
  const TemporaryFolder folder;
  const fs::path path = folder / "a.h5";
  write_file(path);
  const std::uintmax_t size = fs::file_size(path);
  ASSERT_GT(size, 30000U);
  EXPECT_EXIT(fill_the_disk_again_and_again(path, size), testing::ExitedWithCode(0), "");
}

TEST(Hdf5File, ThatIsNoneIsNamedInPlainWords) {
  const TemporaryFolder folder;
  const fs::path path = folder / "a.h5";
  const auto complaint = [&] {
    try {
      (void)InputFile(path).doubles("rows");
    } catch (const base::WorldError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(complaint(), "cannot open " + path.string() + ": No such file or directory");
  write_text(path, "no such thing");
  EXPECT_EQ(complaint(), "cannot open " + path.string() + ": it is damaged, or no HDF5 file");
  write_file(path);
  EXPECT_EQ(InputFile(path).doubles("rows").size(), 4000U);
  EXPECT_THROW((void)InputFile(path).doubles("columns"), base::WorldError);
}

}  // namespace
}  // namespace rift::results::hdf5
