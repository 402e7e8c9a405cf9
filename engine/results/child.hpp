#pragma once

#include <functional>
#include <optional>
#include <string>

namespace rift::results {

/// What work in a process of its own came to.
struct Told {
  std::optional<std::string> text;  // what `work` returned; nothing where it did not live to tell
  std::string death;                // then: how it ended, for people
};

/// Does the work in a forked process, which may allocate 4 GiB beyond what this one has and take so many
/// seconds: for libraries that do not stand whatever a file may hold. Nothing of it is left but its text. To
/// be called while no other thread of this process runs.
Told told_by_child(const std::function<std::string()>& work, unsigned seconds);

}  // namespace rift::results
