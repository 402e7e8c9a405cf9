#pragma once

#include "studio/screen/keymap.hpp"

namespace rift::studio {

/// Which row of a list is chosen, and which one is the first on the screen.
struct ListView {
  int chosen = 0, top = 0;

  /// Moves as an action says. @return whether it is one of a list
  bool move(Action action, int count, int rows);
  /// Keeps the chosen one on the screen.
  void keep(int count, int rows);
};

}  // namespace rift::studio
