#pragma once

#include "studio/graphics/answers.hpp"

#include <chrono>

namespace rift::studio {

struct Asked {
  Capabilities capabilities;
  bool complete = false;  // the last of the answers has come
  std::string typed;      // meanwhile
};

/// Asks the terminal behind two descriptors, for so long at most, with its modes set so that nothing is
/// echoed, and back as they were afterwards. Its size in pixels, where the system knows it, is not asked for.
[[nodiscard]] Asked ask_terminal(int in, int out, const TerminalKind& kind,
                                 std::chrono::milliseconds patience);

}  // namespace rift::studio
