#pragma once

#include "tests/expectations.hpp"
#include "tests/shared_cache.hpp"
#include "tests/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <string>

namespace rift::studio {

/// What a command left behind: its texts and its exit code (128 + n where signal n ended it).
struct Ran {
  std::string out;
  std::string err;       ///< without the lines of progress, which only a slow machine sees
  std::string progress;  ///< those lines
  int exit_code = -1;
};

/// Whether a line reports progress: "crack   41 %  2.0 s left, done at 12:30:05", or "... for 2.0 s so far".
inline bool is_progress(const std::string& line) {
  const std::size_t percent = line.find(" %  ");
  if (percent == std::string::npos) return false;
  return line.find(" left, done at ", percent) != std::string::npos ||
         line.find(" so far", percent) != std::string::npos;
}

/// Sorts the lines of progress out of what a program wrote to standard error.
inline void sort_error_text(const std::string& text, Ran& ran) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const bool ended = !lines.eof();
    (is_progress(line) ? ran.progress : ran.err) += ended ? line + "\n" : line;
  }
}

/// Runs a shell command whose last part may be any program. Standard input is empty; standard output and
/// error are a pipe and a file, never a terminal.
inline Ran run_shell(const std::string& command) {
  const TemporaryFolder folder;
  const std::filesystem::path err = folder.path() / "err";
  FILE* pipe = popen((command + " </dev/null 2>'" + err.string() + "'").c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
  Ran ran;
  char buffer[4096];
  for (std::size_t n = 0; (n = fread(buffer, 1, sizeof buffer, pipe)) > 0;) ran.out.append(buffer, n);
  const int status = pclose(pipe);
  ran.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  sort_error_text(read_text(err), ran);
  return ran;
}

/// Runs `rift ARGUMENTS` with the cache of all tests; quote what the shell would take apart. `environment`
/// holds assignments such as "NO_COLOR=1".
inline Ran run_rift(const std::string& arguments, const std::string& environment = "") {
  return run_shell("env " + shared_cache_environment() + " " + environment + " '" RIFT_EXE "' " + arguments);
}

/// The assignment that has run_rift() find its presets in `folder`.
inline std::string presets_at(const std::filesystem::path& folder) {
  return "RIFT_PRESETS='" + folder.string() + "'";
}

}  // namespace rift::studio
