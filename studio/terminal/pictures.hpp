#pragma once

#include "studio/graphics/encoder.hpp"
#include "studio/graphics/pace.hpp"
#include "studio/graphics/protocol.hpp"
#include "studio/screen/screen_picture.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

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
  /// An answer of the terminal, a whole control sequence: that it took the picture, or, late, what it is.
  void take_answer(std::string_view sequence);
  /// Whether the answer to a picture is still to come, and whether that to the question what it is.
  [[nodiscard]] bool awaits_picture() const { return pace_ && pace_->waits(); }
  [[nodiscard]] bool awaits_attributes() const;
  /// They are no longer waited for.
  void forget_answers();
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
  bool in_letters_ = false, coarse_ = false;  // coarse: symbols of a picture that moves
  double pixels_bytes_ = 0;  // of the last picture in pixels
  std::optional<PicturePace> pace_;
  double attributes_until_s_ = 0;  // it may still answer what it is; 0 where it has
  Capabilities found_;                     // as last answered
  bool answers_ = true, cut_off_ = false;  // cut off: the last codes were not written to their end
  PictureRoom room_;
  Area shown_;
  std::uint64_t number_ = 0;
};

}  // namespace rift::studio
