#pragma once

#include "studio/graphics/encoder.hpp"
#include "studio/graphics/pace.hpp"
#include "studio/graphics/protocol.hpp"
#include "studio/screen/screen_picture.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace rift::studio {

/// What the user asks for.
struct GraphicsWish {
  std::optional<Graphics> asked;  // none: what the terminal answers
  double most_bytes_per_s = 0;    // 0: what it takes
};

/// Pictures within the screen that ncurses has: each has a rectangle that ncurses leaves blank, is written
/// after its refresh(), and taken away before anything else stands there.
class TerminalPictures {
 public:
  TerminalPictures(const GraphicsWish& wish, TerminalKind kind) : wish_(wish), kind_(std::move(kind)) {}

  /// Whether the terminal must be asked before the next picture.
  [[nodiscard]] bool must_ask() const { return !encoder_; }
  /// Asks it, in modes in which nothing is echoed. @return what was typed meanwhile
  std::string ask();
  /// What there is; no pictures before it was asked.
  [[nodiscard]] const PictureRoom& room();

  /// Shows a picture, unless it is shown already or the terminal still takes the last one; without one, takes
  /// the last one away.
  void show(const std::optional<ScreenPicture>& picture);
  /// Takes the picture away; the next show() writes one again.
  void take_away();
  /// The terminal has another size: it is asked again.
  void forget_size();
  /// It has answered that it took the picture.
  void taken();
  /// Whether that answer is still to come.
  [[nodiscard]] bool awaits_answer() const { return pace_ && pace_->waits(); }
  /// It is no longer waited for.
  void forget_answer();
  /// Control codes that ncurses does not know.
  void write(const std::string& codes);
  /// What takes a picture away in a crash.
  [[nodiscard]] std::string restore() const { return encoder_ ? encoder_->restore() : ""; }

 private:
  [[nodiscard]] bool too_slow_for_pixels() const;
  void use_letters(bool wanted);

  GraphicsWish wish_;
  TerminalKind kind_;
  std::optional<PictureEncoder> encoder_, letters_;  // letters: while it moves on a slow line
  bool in_letters_ = false;
  double pixels_bytes_ = 0;  // of the last picture in pixels
  std::optional<PicturePace> pace_;
  Capabilities found_;                     // as last answered
  bool answers_ = true, cut_off_ = false;  // cut off: the last codes were not written to their end
  PictureRoom room_;
  Area shown_;
  std::uint64_t number_ = 0;
};

}  // namespace rift::studio
