#include "studio/graphics/pace.hpp"

#include <algorithm>

namespace rift::studio {
namespace {

constexpr double patience_s = 20;      // with a terminal that has answered before
constexpr double enough_bytes = 2000;  // to say something of the speed and not of the delay

}  // namespace

void PicturePace::begin(std::size_t bytes, double now_s) {
  bytes_ = static_cast<double>(bytes);
  begun_s_ = now_s;
  waits_ = answers_;
}

void PicturePace::written(double now_s) {
  if (!answers_) taken(now_s);
}

void PicturePace::taken(double now_s) {
  waits_ = false;
  if (bytes_ < enough_bytes || now_s <= begun_s_) return;
  const double rate = bytes_ / (now_s - begun_s_);
  measured_ = measured_ == 0 ? rate : 0.5 * (measured_ + rate);
}

bool PicturePace::may_send(double now_s) const {
  if (waits_ && now_s < begun_s_ + patience_s) return false;
  return most_bytes_per_s_ == 0 || now_s >= begun_s_ + bytes_ / most_bytes_per_s_;
}

double PicturePace::bytes_per_s() const {
  if (most_bytes_per_s_ == 0) return measured_;
  return measured_ == 0 ? most_bytes_per_s_ : std::min(measured_, most_bytes_per_s_);
}

}  // namespace rift::studio
