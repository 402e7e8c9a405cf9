#include "studio/terminal/terminal.hpp"

#include "engine/base/console.hpp"
#include "studio/graphics/answers.hpp"

#define NCURSES_WIDECHAR 1
#include <langinfo.h>
#include <locale.h>
#include <ncurses.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string_view>

// Of <term.h>, whose macros take names such as key_up.
extern "C" char* tigetstr(const char* name);
extern "C" int tigetnum(const char* name);
struct term;
extern "C" int setupterm(const char* kind, int descriptor, int* known);
extern "C" term* set_curterm(term* to);
extern "C" int del_curterm(term* old);

namespace rift::studio {
namespace {

constexpr std::array signals{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

/// Text that a handler may read: never moved, never half written where it matters.
template <std::size_t Size>
struct Text {
  std::array<char, Size> bytes{};
  std::size_t length = 0;
  void set(const std::string& text) {
    length = 0;
    const std::size_t kept = std::min(text.size(), Size);
    std::memcpy(bytes.data(), text.data(), kept);
    length = kept;
  }
  void write_to(int descriptor) const {
    if (::write(descriptor, bytes.data(), length) < 0) return;  // nothing can be done about it here
  }
};

Text<300> restore_codes;
Text<400> last_words;
termios modes;
bool have_modes = false;
std::array<struct sigaction, signals.size()> before;
bool guarded = false;

void write_text(const char* text) {
  if (::write(STDERR_FILENO, text, std::strlen(text)) < 0) return;
}

void on_crash(int number) {
  if (tcgetpgrp(STDIN_FILENO) == getpgrp()) {  // another job's terminal is left alone
    restore_codes.write_to(STDOUT_FILENO);
    if (have_modes) tcsetattr(STDIN_FILENO, TCSANOW, &modes);
  }
  char digits[] = "rift: crashed (signal ..)\n";
  char* at = std::strchr(digits, '.');
  at[0] = static_cast<char>('0' + number / 10 % 10);
  at[1] = static_cast<char>('0' + number % 10);
  write_text(digits);
  last_words.write_to(STDERR_FILENO);
  std::signal(number, SIG_DFL);
  std::raise(number);
}

}  // namespace

void keep_modes() { have_modes = tcgetattr(STDIN_FILENO, &modes) == 0; }

void guard_terminal(const std::string& restore) {
  restore_codes.set(restore);
  struct sigaction action {};
  action.sa_handler = on_crash;
  action.sa_flags = SA_NODEFER;
  for (std::size_t k = 0; k < signals.size(); ++k) sigaction(signals[k], &action, &before[k]);
  guarded = true;
}

void unguard_terminal() {
  if (!guarded) return;
  for (std::size_t k = 0; k < signals.size(); ++k) sigaction(signals[k], &before[k], nullptr);
  guarded = false;
}

void say_in_a_crash(const std::string& text) { last_words.set(text); }

namespace {

constexpr int own = -1;  // the terminal's own colour

/// Colours of the inks by their order, on terminals of 256, 16 and 8 colours; after Okabe and Ito (2008)
/// where there are 256. None is near white or black: a terminal's background is either.
constexpr std::size_t inks = static_cast<std::size_t>(Ink::shades);
constexpr std::array<int, inks> inks_256{own, 245, own, 35, 160, 32, 214, 166, 36, own};
constexpr std::array<int, inks> inks_16{own, 8, own, 10, 9, 12, 11, 9, 14, own};
constexpr std::array<int, inks> inks_8{own,        own,          own,       COLOR_GREEN, COLOR_RED,
                                       COLOR_BLUE, COLOR_YELLOW, COLOR_RED, COLOR_CYAN,  own};

int ink_colour(Ink ink) {
  const auto k = static_cast<std::size_t>(ink);
  return COLORS >= 256 ? inks_256[k] : COLORS >= 16 ? inks_16[k] : inks_8[k];
}

/// From blue over grey to red.
constexpr std::array<int, shade_steps> shades_256{19,  26,  32,  68,  74,  110, 152, 252,
                                                  224, 217, 210, 203, 167, 160, 124};

int shade_colour(int step) {
  if (step == no_shade) return own;
  if (COLORS >= 256) return shades_256[static_cast<std::size_t>(step)];
  constexpr std::array<int, 5> five{4, 12, 7, 9, 1};
  if (COLORS >= 16) return five[static_cast<std::size_t>(step * 5 / shade_steps)];
  constexpr std::array<int, 3> three{COLOR_BLUE, COLOR_WHITE, COLOR_RED};
  return three[static_cast<std::size_t>(step * 3 / shade_steps)];
}

/// A control code of this terminal, empty where it has none.
std::string code(const char* name) {
  const char* text = tigetstr(name);
  return text == nullptr || text == reinterpret_cast<const char*>(-1) ? "" : text;
}

KeyEvent mouse() {
  MEVENT event;
  if (getmouse(&event) != OK) return {};
  if (event.bstate & BUTTON4_PRESSED) return {key_wheel_up, event.x, event.y};
  if (event.bstate & BUTTON5_PRESSED) return {key_wheel_down, event.x, event.y};
  if (event.bstate & (BUTTON1_CLICKED | BUTTON1_PRESSED)) return {key_click, event.x, event.y};
  if (event.bstate & BUTTON1_RELEASED) return {key_release, event.x, event.y};
  if (event.bstate & REPORT_MOUSE_POSITION) return {key_drag, event.x, event.y};
  return {};
}

KeyEvent special(int pressed) {
  switch (pressed) {
    case KEY_UP:
      return {key_up};
    case KEY_DOWN:
      return {key_down};
    case KEY_LEFT:
      return {key_left};
    case KEY_RIGHT:
      return {key_right};
    case KEY_PPAGE:
      return {key_page_up};
    case KEY_NPAGE:
      return {key_page_down};
    case KEY_HOME:
      return {key_home};
    case KEY_END:
      return {key_end};
    case KEY_BACKSPACE:
      return {key_backspace};
    case KEY_DC:
      return {key_delete};
    case KEY_ENTER:
      return {key_enter};
    case KEY_MOUSE:
      return mouse();
    default:
      return {};
  }
}

KeyEvent letter(int pressed) {
  if (pressed == '\r') return {key_enter};
  if (pressed == 127 || pressed == 8) return {key_backspace};
  return {pressed};
}

/// What stands for colours where there are none.
char32_t grey_of(const Style& style) {
  constexpr std::u32string_view greys = U"·░▒▓█";
  const int step = std::max(style.upper, style.lower);
  return greys[static_cast<std::size_t>(step) * greys.size() / shade_steps];
}

volatile std::sig_atomic_t stop_asked = 0;

void note_stop(int) { stop_asked = 1; }

Terminal::Hold hold_now() {
  const pid_t foreground = tcgetpgrp(STDIN_FILENO);
  if (foreground < 0) return Terminal::Hold::gone;
  return foreground == getpgrp() ? Terminal::Hold::ours : Terminal::Hold::lent;
}

/// A variable of the environment.
std::string_view variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

bool is_utf8() { return std::strcmp(nl_langinfo(CODESET), "UTF-8") == 0; }

}  // namespace

std::string Terminal::why_not() {
  if (isatty(STDIN_FILENO) != 1 || isatty(STDOUT_FILENO) != 1) return "no terminal";
  if (!base::in_foreground(STDIN_FILENO)) return "a terminal from which it was started in the background";
  const char* kind = std::getenv("TERM");
  if (kind == nullptr || *kind == '\0') return "a terminal of unknown type (TERM is not set)";
  if (std::strcmp(kind, "dumb") == 0) return "a terminal that cannot be drawn on (TERM=dumb)";
  int known = 0;
  if (setupterm(nullptr, STDOUT_FILENO, &known) == OK) {
    del_curterm(set_curterm(nullptr));
    return {};
  }
  return "a terminal that this system does not know (TERM=" + std::string(kind) + ")";
}

Terminal::Terminal(bool color, const GraphicsWish& wish) {
  setlocale(LC_CTYPE, "");
  glyphs_ = is_utf8() ? Glyphs::unicode : Glyphs::ascii;
  keep_modes();
  // ncurses leaves a handler alone that it finds. Its own would draw at once after bg, which stops the
  // process.
  if (std::signal(SIGTSTP, note_stop) == SIG_IGN) std::signal(SIGTSTP, SIG_IGN);
  initscr();
  cbreak();
  noecho();
  keypad(stdscr, TRUE);
  set_escdelay(25);
  curs_set(0);
  mousemask(BUTTON1_CLICKED | BUTTON1_PRESSED | BUTTON4_PRESSED | BUTTON5_PRESSED, nullptr);
  mouseinterval(0);
  color_ = color && has_colors();
  pictures_.emplace(wish, kind_of_terminal(variable, tigetnum("colors"), glyphs_ == Glyphs::unicode, color));
  guard();
  if (!color_) return;
  start_color();
  use_default_colors();
}

void Terminal::guard() {
  guard_terminal(pictures_->restore() + code("rmcup") + code("cnorm") + code("sgr0") + code("rmkx") +
                 "\033[?1000l\033[?1002l");
}

const PictureRoom& Terminal::picture_room() {
  if (pictures_->must_ask()) {
    const std::string typed = pictures_->ask();
    for (auto key = typed.rbegin(); key != typed.rend(); ++key) ungetch(static_cast<unsigned char>(*key));
    guard();
    clearok(curscr, TRUE);  // what a terminal has made of a question that it does not know
  }
  return pictures_->room();
}

void Terminal::report_drags(bool wanted) {
  if (wanted == drags_) return;
  drags_ = wanted;
  mousemask(BUTTON1_CLICKED | BUTTON1_PRESSED | BUTTON4_PRESSED | BUTTON5_PRESSED |
                (wanted ? BUTTON1_RELEASED | REPORT_MOUSE_POSITION : 0),
            nullptr);
  pictures_->write(wanted ? "\033[?1002h" : "\033[?1002l\033[?1000h");
}

void Terminal::give_back() {
  report_drags(false);
  pictures_->take_away();
  await_answers();
  endwin();
}

/// Answers that come later would be typed into the shell.
void Terminal::await_answers() {
  using Clock = std::chrono::steady_clock;
  const auto until = Clock::now() + std::chrono::milliseconds(500);
  const auto awaited = [&] {
    return pictures_->awaits_attributes() || (pictures_->awaits_picture() && Clock::now() < until);
  };
  if (!awaited()) return;
  while (awaited()) (void)key_event(20);
  pictures_->forget_answers();
  drop_typed();
}

Terminal::~Terminal() {
  if (hold_now() == Hold::ours) give_back();
  unguard_terminal();
  if (std::signal(SIGTSTP, SIG_DFL) == SIG_IGN) std::signal(SIGTSTP, SIG_IGN);
}

void Terminal::stop_if_asked() {
  if (stop_asked == 0) return;
  stop_asked = 0;
  if (hold_now() == Hold::ours) give_back();
  away_ = true;
  std::signal(SIGTSTP, SIG_DFL);
  std::raise(SIGTSTP);  // comes back from here after fg or bg
  std::signal(SIGTSTP, note_stop);
}

Terminal::Hold Terminal::hold() {
  const Hold now = hold_now();
  if (now == Hold::ours && away_) {
    pictures_->take_away();
    if (!isendwin()) endwin();  // stopped by a signal that leaves no time to give the terminal back
    clearok(curscr, TRUE);
    refresh();       // the program's modes, and all that was shown
    drags_ = false;  // which is no mode that ncurses knows
  }
  away_ = now != Hold::ours;
  return now;
}

int Terminal::width() const { return getmaxx(stdscr); }
int Terminal::height() const { return getmaxy(stdscr); }

int Terminal::pair_of(int foreground, int background) {
  if (foreground == own && background == own) return 0;
  const auto [it, is_new] = pairs_.try_emplace({foreground, background}, static_cast<int>(pairs_.size()) + 1);
  if (is_new && it->second < COLOR_PAIRS) init_extended_pair(it->second, foreground, background);
  return it->second < COLOR_PAIRS ? it->second : 0;
}

void Terminal::set_style(const Style& style) {
  attr_t attributes = A_NORMAL;
  if (style.bold) attributes |= A_BOLD;
  if (style.reverse) attributes |= A_REVERSE;
  if (style.ink == Ink::dim && (!color_ || COLORS < 16)) attributes |= A_DIM;
  int pair = 0;
  if (color_ && style.ink == Ink::shades) {
    const bool one_half = style.upper == no_shade;
    pair = pair_of(shade_colour(one_half ? style.lower : style.upper),
                   one_half ? own : shade_colour(style.lower));
  } else if (color_) {
    pair = pair_of(ink_colour(style.ink), own);
  }
  attr_set(attributes, 0, &pair);
}

/// Only what differs from what is there is handed on: a panel that is drawn fifteen times a second leaves the
/// machine to the engine.
void Terminal::show(const Canvas& canvas, const std::optional<ScreenPicture>& picture) {
  const bool anew = canvas.width() != shown_.width() || canvas.height() != shown_.height();
  if (anew) {
    if (shown_.width() > 0) pictures_->forget_size();
    erase();
    clearok(curscr, TRUE);  // pictures too
  }
  if (!picture) pictures_->take_away();  // before something else stands there
  for (int y = 0; y < std::min(canvas.height(), height()); ++y)
    for (int x = 0; x < std::min(canvas.width(), width()); ++x) {
      const Cell& cell = canvas.at(x, y);
      if (cell == (anew ? Cell{} : shown_.at(x, y))) continue;
      set_style(cell.style);
      const bool grey = !color_ && cell.style.ink == Ink::shades && glyphs_ == Glyphs::unicode;
      const wchar_t glyph[2] = {static_cast<wchar_t>(grey ? grey_of(cell.style) : cell.glyph), L'\0'};
      mvaddnwstr(y, x, glyph, 1);
    }
  shown_ = canvas;
  refresh();
  pictures_->show(picture);
}

/// What follows an escape: nothing, then the key was pressed; or a sequence that is no key, such as a late
/// answer of the terminal.
KeyEvent Terminal::escape() {
  constexpr int between_letters_ms = 25;
  std::string sequence = "\033";
  timeout(0);
  wint_t next = 0;
  while (get_wch(&next) == OK) {
    sequence += static_cast<char>(next);
    const int length = length_of_sequence(sequence);
    if (length < 0) {  // a key pressed together with Alt
      unget_wch(static_cast<wchar_t>(next));
      break;
    }
    if (length > 0) {
      pictures_->take_answer(sequence);
      return {};
    }
    timeout(between_letters_ms);
  }
  return {key_escape};
}

KeyEvent Terminal::key_event(int milliseconds, int wakened_by) {
  wint_t pressed = 0;
  timeout(0);
  int kind = get_wch(&pressed);
  if (kind == ERR) {
    std::array<pollfd, 2> waited{{{STDIN_FILENO, POLLIN, 0}, {wakened_by, POLLIN, 0}}};
    if (poll(waited.data(), waited.size(), milliseconds) <= 0 || waited[0].revents == 0) return {};
    kind = get_wch(&pressed);
  }
  if (kind == ERR) return {};
  if (kind == OK && pressed == key_escape) return escape();
  return kind == KEY_CODE_YES ? special(static_cast<int>(pressed)) : letter(static_cast<int>(pressed));
}

void Terminal::drop_typed() { flushinp(); }

void Terminal::say_in_a_crash(const std::string& text) { studio::say_in_a_crash(base::escaped(text, "\n")); }

}  // namespace rift::studio
