#include "studio/charts/gnuplot.hpp"

#include "engine/base/files.hpp"
#include "engine/base/world_error.hpp"
#include "studio/text/html.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>
#include <vector>

namespace rift::studio {

namespace fs = std::filesystem;
using base::WorldError;
namespace {

std::string errno_text(int error) { return std::generic_category().message(error); }

/// How a child process ended, and what it wrote to stdout and stderr.
struct Ended {
  int spawn_error = 0;  // errno where it never began
  int status = 0;       // as of waitpid
  std::string said;
};

std::string read_to_the_end(int descriptor) {
  std::string text;
  std::array<char, 4096> buffer{};
  while (true) {
    const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
    if (count > 0)
      text.append(buffer.data(), static_cast<std::size_t>(count));
    else if (count == 0 || errno != EINTR)
      return text;
  }
}

/// Runs a program of the PATH in `folder`, without a shell and without input.
Ended run_child(std::vector<std::string> words, const fs::path& folder) {
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) return {errno, 0, {}};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, pipe[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, pipe[1], STDERR_FILENO);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t child = 0;
  Ended ended;
  ended.spawn_error = posix_spawnp(&child, argv[0], &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(pipe[1]);
  if (ended.spawn_error == 0) {
    ended.said = read_to_the_end(pipe[0]);
    while (::waitpid(child, &ended.status, 0) < 0 && errno == EINTR) {
    }
  }
  ::close(pipe[0]);
  return ended;
}

/// gnuplot's message on one line: it repeats the command and points at the fault with a caret, over several
/// lines.
std::string on_one_line(const std::string& said) {
  std::string out;
  for (const char c : said) {
    const bool space = c == ' ' || c == '\n' || c == '\t' || c == '\r';
    if (!space)
      out += c;
    else if (!out.empty() && out.back() != ' ')
      out += ' ';
  }
  while (!out.empty() && out.back() == ' ') out.pop_back();
  return out;
}

void require_success(const Ended& ended, const fs::path& picture, const fs::path& script) {
  if (ended.spawn_error == ENOENT)
    throw WorldError(
        "draw", picture,
        fmt::format("gnuplot is not installed: apt install gnuplot-nox; the data and the script are in {}",
                    script.parent_path().string()));
  if (ended.spawn_error != 0) throw WorldError("start gnuplot for", picture, errno_text(ended.spawn_error));
  if (WIFSIGNALED(ended.status))
    throw WorldError("draw", picture, fmt::format("signal {} ended gnuplot", WTERMSIG(ended.status)));
  if (WEXITSTATUS(ended.status) != 0)
    throw WorldError("draw", picture,
                     fmt::format("gnuplot on {}: {}", script.string(), on_one_line(ended.said)));
}

/// gnuplot does not notice a full disk: a picture must have its end.
void require_end(const fs::path& picture, std::string_view end) {
  const std::string bytes = base::read_whole_file(picture);
  if (bytes.empty()) throw WorldError("draw", picture, "gnuplot left it empty");
  if (bytes.size() < 16 || bytes.find(end, bytes.size() - 16) == std::string::npos)
    throw WorldError("draw", picture, "gnuplot left it incomplete (is the disk full?)");
}

void replace_all(std::string& text, std::string_view what, std::string_view by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
}

}  // namespace

void run_script(const fs::path& folder, const std::string& name) {
  base::PendingFile svg(folder / (name + ".svg")), png(folder / (name + ".png"));
  const fs::path script = folder / (name + ".gp");
  const std::string outputs = fmt::format("svg = '{}'; png = '{}'", svg.temporary().filename().string(),
                                          png.temporary().filename().string());
  // --default-settings: a user's own ~/.gnuplot does not change the charts of a report.
  const Ended ended = run_child({"gnuplot", "--default-settings", "-e", outputs, name + ".gp"}, folder);
  require_success(ended, folder / (name + ".svg"), script);
  require_end(svg.temporary(), "</svg>");
  require_end(png.temporary(), "IEND");
  svg.commit();
  png.commit();
}

std::string inline_svg(std::string_view svg, const std::string& name, const std::string& title) {
  std::string out;
  std::size_t at = svg.find("<svg");
  while (at < svg.size()) {
    const std::size_t tag = std::min(svg.find('<', at), svg.size());
    out += svg.substr(at, tag - at);
    const std::size_t end = std::min(svg.find('>', tag), svg.size() - 1) + 1;
    if (tag == svg.size()) break;
    std::string text(svg.substr(tag, end - tag));
    for (const std::string before : {" id='", " id=\"", "href='#", "href=\"#", "url(#"})
      replace_all(text, before, before + name + "_");
    if (text.starts_with("<svg"))
      text.insert(4, fmt::format(" role=\"img\" aria-label=\"{}\"", html_escape(title)));
    at = text == "<title>" ? svg.find("</title>", end) + 8 : end;
    if (text != "<title>") out += text;
  }
  return out;
}

}  // namespace rift::studio
