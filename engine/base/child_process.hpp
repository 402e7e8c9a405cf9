#pragma once

#include "engine/base/world_error.hpp"

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rift::base {

struct ChildOptions {
  std::filesystem::path folder = {};  // in which the program works; empty: where this one does
  bool piped =
      false;  // write() and read() are its input and output; else it has no input, and said() has its output
  bool idle = false;      // it takes only the time that nobody else wants
  bool outlives = false;  // it goes on when its object goes
  int shared = -1;        // a descriptor of ours that it has as its descriptor 3
};

/// The program could not be started.
struct StartError : WorldError {
  StartError(const std::string& program, int why);
  int error;  // as errno
};

/// Another program at work for this one, without a shell. It inherits no other descriptors, a Ctrl-C in the
/// terminal does not reach it, it leaves no zombie, and it is killed where this object goes before it has
/// ended.
class ChildProcess {
 public:
  /// @param[in] command  the program, looked for in PATH where it holds no '/', and its arguments
  /// Throws StartError.
  explicit ChildProcess(std::vector<std::string> command, const ChildOptions& options = {});
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Writes all of it; false where the program no longer listens.
  [[nodiscard]] bool write(std::span<const std::uint8_t> bytes);
  /// Reads until `bytes` is full or the program has closed its output. @return how many were read
  [[nodiscard]] std::size_t read(std::span<std::uint8_t> bytes);
  /// Its output, to be polled; -1 without pipes.
  [[nodiscard]] int output() const { return output_; }
  /// The program sees the end of its input.
  void close_input();

  struct End {
    int signal = 0;     // that ended it
    int code = 0;       // 128 + n where signal n ended it
    std::string text;   // "ended with code 1: no such codec", "was killed by signal 9 (Killed)"
    std::string words;  // the last line that it said, may be empty
  };
  /// Waits for its end; may be called again.
  const End& wait();
  /// Looks once whether it has ended, without waiting.
  [[nodiscard]] bool has_ended();
  /// What it wrote to its standard error, and without pipes to its standard output: the last 64 KiB.
  [[nodiscard]] std::string said() const;

 private:
  void note_end(int status);

  pid_t pid_ = -1;
  bool outlives_;
  int input_ = -1, output_ = -1, errors_ = -1;
  std::optional<End> end_;
};

/// What work in a process of its own came to.
struct SandboxResult {
  std::optional<std::string> text;  // what `work` returned; nothing where it did not live to return
  std::string death;                // then: how it ended, for people
};

/// Does the work in a forked process, which may allocate 4 GiB beyond what this one has and take so many
/// seconds: for libraries that do not stand whatever a file may hold. Nothing of it is left but its text. To
/// be called while no other thread of this process runs.
SandboxResult run_in_sandbox(const std::function<std::string()>& work, unsigned seconds);

}  // namespace rift::base
