#pragma once

#include "tests/studio/commands/pseudo_terminal.hpp"
#include "viz/png.hpp"

#include <chrono>
#include <cstdlib>
#include <deque>
#include <functional>
#include <set>
#include <string>

namespace rift::studio {

/// A terminal with kitty's pictures and cells of 10x20 pixels, as far as a viewer needs one: it answers
/// questions, and keeps the last image.
class KittyScreen {
 public:
  /// @param slow_s  that it takes to say that it has a picture
  explicit KittyScreen(const std::string& command, double slow_s = 0) : slow_s_(slow_s), terminal_(command) {}

  [[nodiscard]] bool reads_until(const std::function<bool()>& is_so) {
    return terminal_.reads_until([&] {
      take();
      return is_so();
    });
  }
  [[nodiscard]] testing::AssertionResult shows(const std::string& part) {
    const std::size_t from = looked_;
    if (reads_until([&] { return terminal_.said().find(part, from) != std::string::npos; })) {
      looked_ = terminal_.said().find(part, from);
      return testing::AssertionSuccess();
    }
    return testing::AssertionFailure() << "no \"" << part << "\"";
  }
  /// So many pictures in all.
  [[nodiscard]] bool shows_picture(int count) {
    return reads_until([&] { return pictures_ >= count; });
  }
  /// So many are there at once, as soon as what is under way has come: an image is taken away after the one
  /// that covers it, and a read may end between them.
  [[nodiscard]] bool has_images(int count) {
    return reads_until([&] { return images_there() == count; });
  }
  /// A picture is there, and for a while no other one comes.
  [[nodiscard]] bool rests() {
    int seen = 0;
    auto since = Clock::now();
    return reads_until([&] {
      if (seen != pictures_) since = Clock::now();
      seen = pictures_;
      return pictures_ > 0 && due_.empty() && Clock::now() - since > std::chrono::milliseconds(900);
    });
  }
  void type(const std::string& keys) { terminal_.type(keys); }
  void resize(unsigned short columns, unsigned short rows) const {
    terminal_.resize(columns, rows);
    kill(terminal_.process(), SIGWINCH);
  }
  /// It no longer says what it is.
  void be_silent() { silent_ = true; }
  void hang_up() { terminal_.hang_up(); }
  int exit_code() {
    (void)reads_until([] { return false; });  // until the command closes it
    return terminal_.exit_code();
  }

  [[nodiscard]] const viz::Image& image() const { return image_; }
  [[nodiscard]] int pictures() const { return pictures_; }
  [[nodiscard]] int images_there() const { return static_cast<int>(there_.size()); }
  [[nodiscard]] pid_t process() const { return terminal_.process(); }

 private:
  using Clock = std::chrono::steady_clock;

  /// Reads what has come since, sequence by sequence.
  void take() {
    const std::string& said = terminal_.said();
    while (!due_.empty() && due_.front() <= Clock::now()) {
      terminal_.type("\033[0n");
      due_.pop_front();
    }
    for (;;) {
      const std::size_t start = said.find('\033', read_);
      if (start == std::string::npos || start + 1 >= said.size()) break;
      std::size_t end = std::string::npos;
      if (said[start + 1] == '_') {
        end = said.find("\033\\", start + 2);
        if (end == std::string::npos) break;
        picture_command(said.substr(start + 2, end - start - 2));
        end += 2;
      } else if (said[start + 1] == '[') {
        end = said.find_first_of("ABCDEFGHJKLMPSTXZabcdefghlmnpqrstux@`", start + 2);
        if (end == std::string::npos) break;
        answer(said.substr(start, ++end - start));
      } else {
        end = start + 2;
      }
      read_ = end;
    }
  }
  void answer(const std::string& question) {
    if (silent_ && question != "\033[5n") return;
    if (question == "\033[16t") terminal_.type("\033[6;20;10t");
    if (question == "\033[c") terminal_.type("\033[?62;c");
    if (question == "\033[5n") due_.push_back(Clock::now() + std::chrono::duration<double>(slow_s_));
  }
  static int number(const std::string& keys, const std::string& key) {
    const std::size_t at = (',' + keys).find(',' + key + '=');
    return at == std::string::npos ? 0 : std::atoi(keys.c_str() + at + key.size() + 1);
  }
  void picture_command(const std::string& text) {
    if (text.empty() || text[0] != 'G') return;
    const std::string keys = text.substr(1, text.find(';') - 1);
    if (keys.find("a=q") != std::string::npos)
      return silent_ ? void() : terminal_.type("\033_Gi=31;OK\033\\");
    if (keys.find("a=d") != std::string::npos) {
      there_.erase(number(keys, "i"));
      return;
    }
    if (keys.find("a=T") != std::string::npos) {
      number_ = number(keys, "i");
      coming_ = {number(keys, "s"), number(keys, "v"), {}};
      base64_.clear();
    }
    if (const std::size_t data = text.find(';'); data != std::string::npos) base64_ += text.substr(data + 1);
    if (keys == "m=0") finish();
  }
  void finish() {
    std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::vector<int> value(256, 0);
    for (std::size_t k = 0; k < letters.size(); ++k)
      value[static_cast<unsigned char>(letters[k])] = static_cast<int>(k);
    std::vector<std::uint8_t> bytes;
    unsigned collected = 0;
    int bits = 0;
    for (const char c : base64_) {
      if (c == '=') {  // ends a piece
        bits = 0;
        continue;
      }
      collected = collected << 6 | static_cast<unsigned>(value[static_cast<unsigned char>(c)]);
      if ((bits += 6) < 8) continue;
      bits -= 8;
      bytes.push_back(static_cast<std::uint8_t>(collected >> bits & 255));
    }
    for (std::size_t k = 0; k + 3 < bytes.size(); k += 4)
      coming_.rgb.insert(coming_.rgb.end(), bytes.begin() + static_cast<std::ptrdiff_t>(k),
                         bytes.begin() + static_cast<std::ptrdiff_t>(k + 3));
    image_ = coming_;
    there_.insert(number_);
    ++pictures_;
  }

  double slow_s_;
  bool silent_ = false;
  std::deque<std::chrono::time_point<Clock, std::chrono::duration<double>>> due_;
  PseudoTerminal terminal_;
  std::size_t read_ = 0, looked_ = 0;
  viz::Image image_, coming_;
  std::string base64_;
  int number_ = 0, pictures_ = 0;
  std::set<int> there_;
};

}  // namespace rift::studio
