#pragma once

#include <cstddef>

namespace rift::studio {

/// When a terminal may be sent the next picture: when it has taken the one before, and no faster than a
/// limit. Times in seconds on any clock.
class PicturePace {
 public:
  /// @param answers  whether the terminal says when it has taken a picture;  @param most_bytes_per_s  0: no
  /// limit
  PicturePace(bool answers, double most_bytes_per_s)
      : answers_(answers), most_bytes_per_s_(most_bytes_per_s) {}

  /// A picture is about to be written.
  void begin(std::size_t bytes, double now_s);
  /// It has been written.
  void written(double now_s);
  /// The terminal has answered.
  void taken(double now_s);
  /// Its answer is no longer waited for.
  void forget() { waits_ = false; }
  /// Whether it still takes the last picture.
  [[nodiscard]] bool waits() const { return waits_; }
  [[nodiscard]] bool may_send(double now_s) const;
  /// As measured, and no more than the limit; 0 where nothing was measured yet.
  [[nodiscard]] double bytes_per_s() const;

 private:
  bool answers_, waits_ = false;
  double most_bytes_per_s_, measured_ = 0;
  double bytes_ = 0, begun_s_ = 0;
};

}  // namespace rift::studio
