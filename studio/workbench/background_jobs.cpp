#include "studio/workbench/background_jobs.hpp"

#include "engine/base/child_process.hpp"

#include <fmt/format.h>

namespace rift::studio {

namespace fs = std::filesystem;

fs::path BackgroundJobs::free_file(const fs::path& folder, const std::string& stem,
                                   const std::string& ending) {
  fs::path path = folder / (stem + ending);
  for (int k = 2; fs::exists(path) || given_.contains(path); ++k)
    path = folder / fmt::format("{}_{}{}", stem, k, ending);
  given_.insert(path);
  return path;
}

std::string BackgroundJobs::start(const std::vector<std::string>& arguments, const std::string& what) try {
  std::vector<std::string> command{program_.string()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  jobs_.push_back(
      {what, std::make_unique<base::ChildProcess>(std::move(command), base::ChildOptions{.outlives = true})});
  return what + ": in progress";
} catch (const base::WorldError& error) {
  return error.what();
}

std::string BackgroundJobs::report_ended() {
  std::string said;
  std::erase_if(jobs_, [&](const Job& job) {
    if (!job.child->has_ended()) return false;
    const base::ChildProcess::End& end = job.child->wait();
    const bool well = end.code == 0;
    const std::string words = !end.words.empty() ? end.words : well ? "done" : "no reason given";
    said = fmt::format("{}{}: {}", job.what, well ? "" : " failed", words);
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
