#include "studio/terminal/pictures.hpp"

#include "engine/base/clock.hpp"
#include "studio/graphics/ask.hpp"
#include "studio/graphics/write_whole.hpp"

#include <unistd.h>

namespace rift::studio {
namespace {

constexpr auto patience = std::chrono::milliseconds(300);
constexpr auto write_patience = std::chrono::seconds(2);
constexpr double late_s = 2;  // by which an answer may be late over a slow line
constexpr const char* ends_string = "\033\\";
constexpr const char* have_you_got_it = "\033[5n";

double now_s() { return base::seconds_since(base::Clock::time_point{}); }

}  // namespace

std::string TerminalPictures::ask() {
  const Asked asked = ask_terminal(STDIN_FILENO, STDOUT_FILENO, kind_, patience);
  attributes_until_s_ = asked.complete ? 0 : now_s() + late_s;
  // One that has answered before is late this time.
  if (asked.capabilities.answers || !found_.answers) found_ = asked.capabilities;
  answers_ = found_.answers;
  const Capabilities& found = found_;
  const Graphics graphics = chosen_graphics(wish_.asked, found);
  room_.pictures = graphics != Graphics::cells && PictureEncoder::there();
  room_.symbols = graphics == Graphics::symbols;
  if (found.cell_width > 0 && !room_.symbols)
    room_.cell_width = found.cell_width, room_.cell_height = found.cell_height;
  if (graphics == Graphics::sixel) room_.most_width = found.most_width, room_.most_height = found.most_height;
  encoder_.emplace(graphics, kind_, room_.cell_width, room_.cell_height);
  letters_.emplace(Graphics::symbols, kind_, room_.cell_width, room_.cell_height);
  in_letters_ = false;
  if (!pace_) pace_.emplace(answers_, wish_.most_bytes_per_s);
  return asked.typed;
}

const PictureRoom& TerminalPictures::room() {
  room_.shown = number_;
  room_.rough = in_letters_ || coarse_;
  room_.bytes_per_s = pace_ ? pace_->bytes_per_s() : 0;
  return room_;
}

/// A moving picture in pixels would take longer than one bears to wait.
bool TerminalPictures::too_slow_for_pixels() const {
  constexpr double bearable_s = 0.4;
  return pace_->bytes_per_s() > 0 && pixels_bytes_ / pace_->bytes_per_s() > bearable_s;
}

void TerminalPictures::use_letters(bool wanted) {
  if (wanted == in_letters_) return;
  take_away();
  in_letters_ = wanted;
}

void TerminalPictures::show(const std::optional<ScreenPicture>& picture) {
  if (!picture || !encoder_ || !room_.pictures) return take_away();
  if (picture->number == number_ || !pace_->may_send(now_s())) return;
  use_letters(picture->moves && !room_.symbols && too_slow_for_pixels());
  const std::string bytes = (in_letters_ ? *letters_ : *encoder_).show(*picture);
  if (!in_letters_) pixels_bytes_ = static_cast<double>(bytes.size());
  if (!bytes.empty()) {
    pace_->begin(bytes.size(), now_s());
    write(bytes + (answers_ ? have_you_got_it : ""));
    pace_->written(now_s());
  }
  coarse_ = picture->moves && room_.symbols;
  room_.bytes_per_pixel = static_cast<double>(bytes.size()) / picture->width / picture->height;
  shown_ = picture->area;
  number_ = picture->number;
}

/// After codes that were cut off, whatever they had begun is ended first.
void TerminalPictures::write(const std::string& codes) {
  cut_off_ = !write_whole(STDOUT_FILENO, cut_off_ ? ends_string + codes : codes, write_patience);
}

void TerminalPictures::take_away() {
  if (number_ != 0) write((in_letters_ ? *letters_ : *encoder_).clear(shown_));
  number_ = 0;
}

void TerminalPictures::forget_size() {
  take_away();
  if (answers_) encoder_.reset();
}

void TerminalPictures::take_answer(std::string_view sequence) {
  if (sequence == "\033[0n" && pace_) pace_->taken(now_s());
  if (sequence.starts_with("\033[?") && sequence.ends_with('c')) attributes_until_s_ = 0;
}

bool TerminalPictures::awaits_attributes() const { return now_s() < attributes_until_s_; }

void TerminalPictures::forget_answers() {
  attributes_until_s_ = 0;
  if (pace_) pace_->forget();
}

}  // namespace rift::studio
