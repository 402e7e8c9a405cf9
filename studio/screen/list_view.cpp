#include "studio/screen/list_view.hpp"

#include <algorithm>

namespace rift::studio {

bool ListView::move(Action action, int count, int rows) {
  const int page = std::max(1, rows - 1);
  switch (action) {
    case Action::up:
      --chosen;
      break;
    case Action::down:
      ++chosen;
      break;
    case Action::page_up:
      chosen -= page;
      break;
    case Action::page_down:
      chosen += page;
      break;
    case Action::first:
      chosen = 0;
      break;
    case Action::last:
      chosen = count - 1;
      break;
    default:
      return false;
  }
  keep(count, rows);
  return true;
}

void ListView::keep(int count, int rows) {
  chosen = std::clamp(chosen, 0, std::max(0, count - 1));
  top = std::clamp(top, chosen - std::max(1, rows) + 1, chosen);
  top = std::clamp(top, 0, std::max(0, count - 1));
}

}  // namespace rift::studio
