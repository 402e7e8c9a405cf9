#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace rift::studio {

/// What a command left behind: its texts and its exit code (128 + n where signal n ended it).
struct Ran {
  std::string out, err;
  int exit_code = -1;
};

/// A folder of its own for one test, removed with all that is in it at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "rift_test_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot create " + name);
    path_ = name;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// Whether `text` contains `part`, as in EXPECT_TRUE(contains(ran.err, "must lie in")).
inline testing::AssertionResult contains(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "no \"" << part << "\" in:\n" << text;
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
  ran.err = read_text(err);
  return ran;
}

/// Runs `rift ARGUMENTS`; quote what the shell would take apart. `environment` holds assignments such as
/// "NO_COLOR=1".
inline Ran run_rift(const std::string& arguments, const std::string& environment = "") {
  return run_shell("env " + environment + " '" RIFT_EXE "' " + arguments);
}

}  // namespace rift::studio
