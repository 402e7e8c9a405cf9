#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace rift::studio {

/// Another call of rift that works in the background, such as the drawing of a film: nobody waits for it, and
/// it goes on when its object goes.
class Errand {
 public:
  /// @param command  program and arguments;  @param what  for people: "film of plate_pnrt"
  /// Throws WorldError where it cannot be started.
  Errand(const std::vector<std::string>& command, std::string what);

  /// Looks once whether it has ended; from then on what() says how.
  [[nodiscard]] bool ended();
  [[nodiscard]] const std::string& what() const { return what_; }

 private:
  std::string what_, output_;
  pid_t pid_ = -1;
};

}  // namespace rift::studio
