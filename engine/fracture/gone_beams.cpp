#include "engine/fracture/gone_beams.hpp"

#include <algorithm>

namespace rift::fracture {

void GoneBeams::add(const Eigen::Vector2d& middle) {
  Gone added{middle, 1};
  for (Gone& other : gone_) {
    if ((other.middle - middle).norm() > reach_) continue;
    ++added.near, ++other.near;
    look_at(other);
  }
  gone_.push_back(added);
  look_at(added);
}

void GoneBeams::look_at(const Gone& gone) {
  constexpr int enough = 3;
  if (gone.near >= enough) leading_ = std::max(leading_.value_or(gone.middle.x()), gone.middle.x());
}

}  // namespace rift::fracture
