#include "studio/view/player.hpp"

#include <algorithm>
#include <cmath>

namespace rift::studio {

Player::Player(int moments, double per_second) : moments_(moments), per_second_(per_second) {}

void Player::play_from_here(double now_s) {
  from_ = moment_;
  since_s_ = now_s;
}

void Player::toggle(double now_s) {
  playing_ = !playing_;
  if (playing_ && moment_ + 1 == moments_) moment_ = 0;
  play_from_here(now_s);
}

void Player::look(double now_s) {
  if (!playing_) return;
  const double passed = std::floor((now_s - since_s_) * per_second_);
  moment_ = static_cast<int>(std::min(from_ + passed, moments_ - 1.0));
  playing_ = moment_ + 1 < moments_;
}

void Player::go_to(int moment) {
  playing_ = false;
  moment_ = std::clamp(moment, 0, moments_ - 1);
}

void Player::change_speed(double factor, double now_s) {
  per_second_ *= factor;
  play_from_here(now_s);
}

void Player::grow(int moments) {
  const bool at_end = moment_ + 1 == moments_;
  moments_ = moments;
  if (at_end && !playing_) moment_ = moments - 1;
}

double Player::due_in(double now_s) const { return since_s_ + (moment_ - from_ + 1) / per_second_ - now_s; }

}  // namespace rift::studio
