#include "studio/workbench/background_jobs.hpp"

#include "engine/base/world_error.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

extern char** environ;

namespace rift::studio {
namespace {

std::string new_file() {
  std::string name = (std::filesystem::temp_directory_path() / "rift_errand_XXXXXX").string();
  const int descriptor = mkstemp(name.data());
  if (descriptor < 0) throw base::WorldError("create", name, std::strerror(errno));
  close(descriptor);
  return name;
}

/// The last line that says something.
std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of("\n\r ");
  if (end == std::string::npos) return {};
  const std::size_t start = text.find_last_of("\n\r", end);
  return text.substr(start == std::string::npos ? 0 : start + 1,
                     end - (start == std::string::npos ? 0 : start + 1) + 1);
}

}  // namespace

BackgroundJob::BackgroundJob(const std::vector<std::string>& command, std::string what)
    : what_(std::move(what)), output_(new_file()) {
  std::vector<char*> arguments;
  for (const std::string& part : command) arguments.push_back(const_cast<char*>(part.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, output_.c_str(), O_WRONLY | O_APPEND, 0);
  posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  posix_spawnattr_t attributes;  // a group of its own: a Ctrl-C in the terminal does not reach it
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  const int error = posix_spawnp(&pid_, arguments[0], &files, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  if (error != 0) throw base::WorldError("start", command.front(), std::strerror(error));
}

bool BackgroundJob::ended() {
  if (pid_ < 0) return true;
  int status = 0;
  if (waitpid(pid_, &status, WNOHANG) == 0) return false;
  pid_ = -1;
  std::ifstream file(output_, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  std::error_code ignored;
  std::filesystem::remove(output_, ignored);
  const bool well = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  const std::string said = last_line(text);
  what_ = well ? fmt::format("{}: {}", what_, said.empty() ? "done" : said)
               : fmt::format("{} failed: {}", what_, said.empty() ? "no word why" : said);
  return true;
}

namespace fs = std::filesystem;
namespace {

/// The first of stem.png, stem_2.png, ... that does not exist yet.
fs::path free_file(const fs::path& folder, const std::string& stem, const std::string& ending) {
  fs::path path = folder / (stem + ending);
  for (int k = 2; fs::exists(path); ++k) path = folder / fmt::format("{}_{}{}", stem, k, ending);
  return path;
}

}  // namespace

std::string BackgroundJobs::start(const std::vector<std::string>& arguments, const std::string& what) try {
  std::vector<std::string> command{program_.string()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  jobs_.emplace_back(command, what);
  return what + ": under way";
} catch (const base::WorldError& error) {
  return error.what();
}

std::string BackgroundJobs::report_ended() {
  std::string said;
  std::erase_if(jobs_, [&](BackgroundJob& job) {
    if (!job.ended()) return false;
    said = job.what();
    return true;
  });
  return said;
}

std::string BackgroundJobs::picture(const fs::path& run, int lane) {
  const fs::path file = free_file(run, "frame", ".png");
  return start({"render", run.string(), "--lane", std::to_string(lane), "--at", "1", "--picture",
                file.string(), "--quiet"},
               "frame");
}

std::string BackgroundJobs::film(const fs::path& run, const std::vector<int>& lanes, double from_us,
                                 double to_us) {
  const fs::path file = free_file(run, "film", ".mp4");
  std::vector<std::string> arguments{"render", run.string(), "--film", file.string(), "--quiet"};
  for (const int lane : lanes) arguments.insert(arguments.end(), {"--lane", std::to_string(lane)});
  if (to_us > from_us)
    arguments.insert(arguments.end(),
                     {"--from", fmt::format("{:.6f} us", from_us), "--to", fmt::format("{:.6f} us", to_us)});
  return start(arguments, "film");
}

std::string BackgroundJobs::tables(const fs::path& run) {
  return start({"export", run.string(), "--to", "csv"}, "export");
}

}  // namespace rift::studio
