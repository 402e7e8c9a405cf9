#include "studio/terminal/event_loop.hpp"

#include "studio/screen/canvas.hpp"
#include "studio/terminal/terminal.hpp"

#include <chrono>
#include <thread>
#include <utility>
#include <vector>

namespace rift::studio {
namespace {

constexpr int while_away_ms = 95;

class EventLoop {
 public:
  EventLoop(std::unique_ptr<Screen> first, bool color, const GraphicsWish& wish) : terminal_(color, wish) {
    stack_.push_back(std::move(first));
  }

  [[nodiscard]] bool empty() const { return stack_.empty(); }

  /// @return whether the terminal is still there
  bool round(const Unseen& unseen) {
    terminal_.stop_if_asked();
    const Terminal::Hold hold = terminal_.hold();
    if (hold == Terminal::Hold::ours && top().wants_picture()) top().take_room(terminal_.picture_room());
    navigate(top().look());
    if (empty()) return true;
    if (hold == Terminal::Hold::ours) {
      draw();
      read_key();
      return true;
    }
    if (unseen) unseen(hold == Terminal::Hold::gone);
    std::this_thread::sleep_for(std::chrono::milliseconds(while_away_ms));
    return hold != Terminal::Hold::gone;
  }

 private:
  Screen& top() { return *stack_.back(); }

  void read_key() {
    const KeyEvent event = terminal_.key_event(top().patience_ms(), top().wakened_by());
    if (event.key == key_none) return;
    const bool asked_for_help = !top().typing() && action_of(top().where(), event.key) == Action::help;
    if (help_ || asked_for_help) {
      const bool next_page = help_ && help_next_ > 0 && event.key == ' ';  // any other key closes it
      help_ = !help_ || next_page;
      help_from_ = next_page ? help_next_ : 0;
      return;
    }
    Navigation navigation = top().press(event);
    const bool escaped = event.key == key_escape && navigation.to == Navigation::To::back;
    navigate(std::move(navigation));
    if (escaped) terminal_.drop_typed();
  }

  void draw() {
    Canvas canvas(terminal_.width(), terminal_.height());
    top().draw(canvas, terminal_.glyphs());
    if (help_) help_next_ = draw_help(canvas, top().where(), help_from_, terminal_.glyphs());
    terminal_.report_drags(top().wants_drags());
    const bool covered = help_;  // a picture would lie on top
    terminal_.show(canvas, covered ? std::nullopt : top().picture());
    Terminal::say_in_a_crash(top().last_words());
  }

  void navigate(Navigation navigation) {
    if (navigation.to == Navigation::To::stay) return;
    if (navigation.to != Navigation::To::forward) stack_.pop_back();
    if (navigation.next) stack_.push_back(std::move(navigation.next));
    if (navigation.to == Navigation::To::back && !empty()) top().resume();
  }

  Terminal terminal_;
  std::vector<std::unique_ptr<Screen>> stack_;
  bool help_ = false;
  int help_from_ = 0, help_next_ = 0;  // the page of the help that is shown, and the one after it
};

}  // namespace

void work_in_terminal(std::unique_ptr<Screen> first, bool color, const std::function<bool()>& stopped,
                      const Unseen& unseen, const GraphicsWish& wish) {
  EventLoop loop(std::move(first), color, wish);
  bool there = true;
  while (!loop.empty() && !stopped() && (there || unseen)) there = loop.round(unseen);
}

}  // namespace rift::studio
