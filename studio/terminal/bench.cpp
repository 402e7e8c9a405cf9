#include "studio/terminal/bench.hpp"

#include "studio/screen/canvas.hpp"
#include "studio/terminal/terminal.hpp"

#include <chrono>
#include <thread>
#include <vector>

namespace rift::studio {
namespace {

constexpr int between_drawings_ms =
    95;  // more than ten a second, and no more: the terminal draws on the same cores

class Bench {
 public:
  Bench(std::unique_ptr<Screen> first, bool color) : terminal_(color) { stack_.push_back(std::move(first)); }

  [[nodiscard]] bool empty() const { return stack_.empty(); }

  /// @return whether the terminal is still there
  bool round(const Unseen& unseen) {
    terminal_.stop_if_asked();
    turn(top().look());
    if (empty()) return true;
    const Terminal::Hold hold = terminal_.hold();
    if (hold == Terminal::Hold::ours) {
      draw();
      press();
      return true;
    }
    if (unseen) unseen(hold == Terminal::Hold::gone);
    std::this_thread::sleep_for(std::chrono::milliseconds(between_drawings_ms));
    return hold != Terminal::Hold::gone;
  }

 private:
  Screen& top() { return *stack_.back(); }

  void press() {
    const Press press = terminal_.press(between_drawings_ms);
    if (press.key == key_none) return;
    const bool asked_for_help = !top().typing() && action_of(top().where(), press.key) == Action::help;
    if (help_ || asked_for_help) {
      help_ = !help_;
      return;
    }
    turn(top().press(press));
  }

  void draw() {
    Canvas canvas(terminal_.width(), terminal_.height());
    top().draw(canvas, terminal_.glyphs());
    if (help_) draw_help(canvas, top().where(), terminal_.glyphs());
    terminal_.show(canvas);
    Terminal::say_in_a_crash(top().last_words());
  }

  void turn(Turn turn) {
    if (turn.way == Turn::Way::stay) return;
    if (turn.way != Turn::Way::forward) stack_.pop_back();
    if (turn.next) stack_.push_back(std::move(turn.next));
    if (turn.way == Turn::Way::back && !empty()) top().resume();
  }

  Terminal terminal_;
  std::vector<std::unique_ptr<Screen>> stack_;
  bool help_ = false;
};

}  // namespace

void work_in_terminal(std::unique_ptr<Screen> first, bool color, const std::function<bool()>& stopped,
                      const Unseen& unseen) {
  Bench bench(std::move(first), color);
  bool there = true;
  while (!bench.empty() && !stopped() && (there || unseen)) there = bench.round(unseen);
}

}  // namespace rift::studio
