#include "engine/base/world_error.hpp"
#include "engine/results/json_input.hpp"
#include "engine/study/store.hpp"
#include "tests/fuzz/bytes.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// A study's folder of this process.
const fs::path& study_folder() {
  static const fs::path folder = [] {
    std::string name = (fs::temp_directory_path() / "rift_fuzz_XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) std::abort();
    std::atexit([] {
      std::error_code ignored;
      fs::remove_all(study_folder(), ignored);
    });
    fs::create_directories(fs::path(name) / "runs");
    return fs::path(name);
  }();
  return folder;
}

}  // namespace

// The file of a scenario's result: its bytes as they are, or a scenario that is written and read back to the
// same. Only WorldError may leave.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  rift::fuzz::Bytes input = rift::fuzz::bytes_of(data, size);
  const bool as_it_is = input.number<std::uint8_t>() % 2 == 0;
  std::vector<std::string> notes;
  try {
    if (as_it_is) {
      std::ofstream(rift::study::result_file(study_folder(), "key"), std::ios::binary) << input.left;
      (void)rift::study::read_result(study_folder(), "key", notes);
      return 0;
    }
    const auto scenario = rift::results::json_or_discarded(input.left);
    if (!scenario.is_object()) return 0;
    const auto kept =
        rift::study::write_result(study_folder(), "key", rift::results::lane_summary_of(scenario), "step\n");
    const auto read = rift::study::read_result(study_folder(), "key", notes);
    if (!read || to_json(*read) != to_json(kept)) std::abort();
  } catch (const rift::base::WorldError&) {
  }
  return 0;
}
