#pragma once

#include "studio/screen/canvas.hpp"
#include "studio/screen/keymap.hpp"
#include "studio/terminal/pictures.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace rift::studio {

// What is done with the terminal when the program crashes; all of it may be done inside a signal handler.

/// Keeps the terminal's modes as they are now, before anybody changes them.
void keep_modes();

/// From now on SIGSEGV, SIGBUS, SIGFPE, SIGILL and SIGABRT first write `restore` to the terminal and set its
/// modes as they were kept, then say what happened, then end the program as they would have.
/// @param restore  control codes; at most 200 bytes
void guard_terminal(const std::string& restore);

/// Signals are as they were.
void unguard_terminal();

/// What to say beside the signal's number; at most 400 bytes are kept.
void say_in_a_crash(const std::string& text);

/// The user's terminal, taken over for the life of the object by ncurses and given back as it was: also on
/// Ctrl-Z, and when the program crashes. While another job has it (Ctrl-Z and bg), and when it is gone,
/// nothing here touches it.
class Terminal {
 public:
  enum class Hold : std::uint8_t {
    ours,  // this process is in its foreground
    lent,  // another job is, until fg
    gone,  // closed
  };

  /// Why there is no terminal to draw on, such as "no terminal" or "a terminal that is not known here
  /// (TERM=foo)"; empty where there is one.
  [[nodiscard]] static std::string why_not();
  [[nodiscard]] static bool there() { return why_not().empty(); }

  /// @param color  false shows everything in one colour;  @param wish  about pictures
  explicit Terminal(bool color, const GraphicsWish& wish = {});
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// Where Ctrl-Z was pressed, gives the terminal back and stops the process until somebody lets it go on.
  void stop_if_asked();
  /// Whose the terminal is now; taken up anew where it is ours again. Only then is anything shown or pressed.
  [[nodiscard]] Hold hold();

  [[nodiscard]] int width() const;
  [[nodiscard]] int height() const;
  [[nodiscard]] Glyphs glyphs() const { return glyphs_; }
  /// @param picture  over the cells; none takes the last one away
  void show(const Canvas& canvas, const std::optional<ScreenPicture>& picture = {});
  /// The room for pictures; the terminal is asked for it when this is called first.
  [[nodiscard]] const PictureRoom& picture_room();
  /// Whether the mouse's movements are keys while its button is down.
  void report_drags(bool wanted);
  /// What is pressed within so many milliseconds; a change of size is nothing.
  /// @param wakened_by  a descriptor that ends the waiting when it can be read, or -1
  [[nodiscard]] KeyEvent key_event(int milliseconds, int wakened_by = -1);
  /// Drops what has been typed and not read yet: it was meant for a screen that has gone.
  void drop_typed();

  /// What to say should the program crash, such as where the run is; at most 400 bytes are kept.
  static void say_in_a_crash(const std::string& text);

 private:
  [[nodiscard]] int pair_of(int foreground, int background);
  void set_style(const Style& style);
  void guard();
  [[nodiscard]] KeyEvent escape();
  void give_back();
  void await_answers();

  bool color_, away_ = false, drags_ = false;
  Glyphs glyphs_;
  Canvas shown_{0, 0};
  std::optional<TerminalPictures> pictures_;
  std::map<std::pair<int, int>, int> pairs_;  // of foreground and background
};

}  // namespace rift::studio
