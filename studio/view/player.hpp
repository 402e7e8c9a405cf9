#pragma once

namespace rift::studio {

/// Which of the stored moments is shown, while it plays and while it rests. Times in seconds on any clock.
class Player {
 public:
  /// @param moments  at least one;  @param per_second  moments
  Player(int moments, double per_second);

  [[nodiscard]] int moment() const { return moment_; }
  [[nodiscard]] bool playing() const { return playing_; }
  [[nodiscard]] double per_second() const { return per_second_; }

  /// Plays from here, or from the beginning where it stands at the end; pauses.
  void toggle(double now_s);
  /// Shows the moment that is due. At the last one it pauses.
  void look(double now_s);
  /// Pauses at a moment; before the first is the first, after the last the last.
  void go_to(int moment);
  void change_speed(double factor, double now_s);
  /// There are more moments now. Where the last one was shown, the last one is shown.
  void grow(int moments);
  /// Until the next moment is due [s].
  [[nodiscard]] double due_in(double now_s) const;

 private:
  void play_from_here(double now_s);

  int moments_, moment_ = 0, from_ = 0;
  double per_second_, since_s_ = 0;
  bool playing_ = false;
};

}  // namespace rift::studio
