#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace rift::viz {

/// Another program at work for us: fed through its input, heard through its output. It is killed where this
/// object goes before it has ended, and a Ctrl-C in the terminal does not reach it.
class Child {
 public:
  /// @param command  the program, looked for in PATH where it holds no '/', and its arguments
  /// @param idle     it only takes the time that nobody else wants
  /// Throws WorldError where it cannot be started.
  explicit Child(std::vector<std::string> command, bool idle = false);
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Writes all of it; false where the program no longer listens.
  [[nodiscard]] bool write(std::span<const std::uint8_t> bytes);
  /// Reads until `bytes` is full or the program has closed its output. @return how many were read
  [[nodiscard]] std::size_t read(std::span<std::uint8_t> bytes);
  /// The program sees the end of its input.
  void close_input();

  struct End {
    int code = 0;       // 128 + n where signal n ended it
    std::string text;   // "ended with code 1: no such codec", "was killed by signal 9 (Killed)"
    std::string words;  // the last line of its standard error, may be empty
  };
  /// Waits for its end; may be called again.
  const End& wait();

 private:
  [[nodiscard]] std::string last_words() const;

  std::string name_;
  pid_t pid_ = -1;
  int input_ = -1, output_ = -1, errors_ = -1;
  bool ended_ = false;
  End end_;
};

}  // namespace rift::viz
