#pragma once

#include "studio/workbench/screen.hpp"

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace rift::studio {

/// Another call of rift that works in the background, such as the drawing of a film: nobody waits for it, and
/// it goes on when its object goes.
class BackgroundJob {
 public:
  /// @param command  program and arguments;  @param what  for people: "film of plate_pnrt"
  /// Throws WorldError where it cannot be started.
  BackgroundJob(const std::vector<std::string>& command, std::string what);

  /// Looks once whether it has ended; from then on what() says how.
  [[nodiscard]] bool ended();
  [[nodiscard]] const std::string& what() const { return what_; }

 private:
  std::string what_, output_;
  pid_t pid_ = -1;
};

/// Pictures, films and tables that a screen has asked for.
class BackgroundJobs {
 public:
  explicit BackgroundJobs(std::filesystem::path program) : program_(std::move(program)) {}

  /// Calls rift with these arguments. @return what to say
  std::string start(const std::vector<std::string>& arguments, const std::string& what);
  /// What to say of those that have ended since; empty: nothing.
  std::string report_ended();

  // What rift is asked for of a run's folder.
  std::string picture(const std::filesystem::path& run, int lane);
  /// @param from_us  of the crack's time; to_us at or before it: all of the run
  std::string film(const std::filesystem::path& run, const std::vector<int>& lanes, double from_us = 0,
                   double to_us = -1);
  std::string tables(const std::filesystem::path& run);

 private:
  std::filesystem::path program_;
  std::vector<BackgroundJob> jobs_;
};

}  // namespace rift::studio
