#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace rift::study {

/// A process at work on a study, by the claims that it holds.
struct Worker {
  std::string host, label;
  int process = 0;
  int scenarios = 0;      // that it has taken on
  bool prepares = false;  // a specimen
  double silent_s = 0;    // since its last sign of life
  bool lives = true;
};

/// How far a study is, by its folder alone.
struct StudyStatus {
  std::string preset;
  int scenarios = 0, done = 0;
  int not_made = 0;  // cannot be made
  int running = 0;   // taken on by a process that lives
  int lost = 0;      // taken on by one that lives no more: the next one takes them
  std::vector<Worker> workers;
  /// Until all are done, at the pace of the results that came last [s]; NaN where nothing runs or too few
  /// came.
  double left_s = std::numeric_limits<double>::quiet_NaN();

  [[nodiscard]] int waiting() const { return scenarios - done - not_made - running - lost; }
};

/// Reads the names in the folder and none of the results. Throws InputError where study.json is damaged, and
/// WorldError where there is none.
StudyStatus status_of(const std::filesystem::path& folder);

}  // namespace rift::study
