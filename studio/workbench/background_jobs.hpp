#pragma once

#include "engine/base/child_process.hpp"
#include "studio/workbench/screen.hpp"

#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace rift::studio {

/// Pictures, films and tables that a screen has asked for: other calls of rift that work in the background.
/// Nobody waits for them, and they go on when this object goes.
class BackgroundJobs {
 public:
  explicit BackgroundJobs(std::filesystem::path program) : program_(std::move(program)) {}

  /// Calls rift with these arguments. @return what to say
  std::string start(const std::vector<std::string>& arguments, const std::string& what);
  /// What to say of those that have ended since; empty: nothing.
  std::string report_ended();

  /// The first of folder/stem.ending, folder/stem_2.ending, ... that neither exists nor was given before: a
  /// job writes its file later.
  [[nodiscard]] std::filesystem::path free_file(const std::filesystem::path& folder, const std::string& stem,
                                                const std::string& ending);

  // What rift is asked for of a run's folder.
  std::string picture(const std::filesystem::path& run, int lane);
  /// @param from_us  of the crack's time; to_us at or before it: all of the run
  std::string film(const std::filesystem::path& run, const std::vector<int>& lanes, double from_us = 0,
                   double to_us = -1);
  std::string tables(const std::filesystem::path& run);

 private:
  struct Job {
    std::string what;  // for people: "film"
    std::unique_ptr<base::ChildProcess> child;
  };
  std::filesystem::path program_;
  std::set<std::filesystem::path> given_;
  std::vector<Job> jobs_;
};

}  // namespace rift::studio
