#pragma once

#include <sys/types.h>

#include <string>

/// How a process is named in files that several nodes share.
namespace rift::base {

/// This node's name up to its first dot, of letters, digits and '_' only.
[[nodiscard]] std::string host_name();

/// Whether a process of this node is gone, or has ended and waits for a parent that does not ask (containers
/// without an init keep such for ever).
[[nodiscard]] bool has_ended(pid_t process);

}  // namespace rift::base
