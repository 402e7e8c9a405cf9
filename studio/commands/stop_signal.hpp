#pragma once

#include "engine/base/clock.hpp"

#include <optional>
#include <string>

namespace rift::studio {

/// The seconds of --budget, none for an empty text. A bare number is no time, as anywhere else: throws
/// InputError, in which `command` ("rift study") is named.
std::optional<double> read_budget(const std::string& command, const std::string& text);

/// The signals by which a user, a terminal or a batch system asks for an end (SIGINT, SIGTERM, SIGHUP,
/// SIGUSR1, SIGUSR2, SIGXCPU, and SIGXFSZ from another process) no longer kill, but set a flag that long work
/// looks at; a time that is up counts as one. A SIGHUP that is ignored, as under nohup, stays ignored. Lives
/// as long as the command.
class StopSignal {
 public:
  /// @param budget  [s] from now, none for ever
  explicit StopSignal(std::optional<double> budget = {});
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;
  static constexpr int time_is_up = -1;
  int received() const;  // the signal's number, 0 for none

 private:
  std::optional<base::Clock::time_point> until_;
};

/// A write beyond the largest size of a file (`ulimit -f`) fails with EFBIG, as on a full disk, and no longer
/// kills the process. For the whole program, from its start.
void let_large_writes_fail();

}  // namespace rift::studio
