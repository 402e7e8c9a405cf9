#include "studio/slurm/queue.hpp"

#include "engine/base/child_process.hpp"
#include "engine/base/world_error.hpp"
#include "engine/scene/issue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <map>
#include <sstream>
#include <tuple>

namespace rift::studio {
namespace {

struct Said {
  std::string text, errors;
  int code = 0;
};

/// Runs one of Slurm's commands to its end.
Said slurm_said(const std::vector<std::string>& command) try {
  base::ChildProcess child(command, {.piped = true});
  child.close_input();
  Said said;
  std::array<std::uint8_t, 4096> piece{};
  for (std::size_t count = 0; (count = child.read(piece)) > 0;)
    said.text.append(piece.begin(), piece.begin() + count);
  said.code = child.wait().code;
  said.errors = child.wait().words;
  return said;
} catch (const base::StartError&) {
  throw base::WorldError("start", command.front(),
                         "Slurm's commands are not on this machine: submit from a login node");
}

Said slurm_must_say(const std::vector<std::string>& command) {
  Said said = slurm_said(command);
  if (said.code != 0)
    throw base::WorldError(
        "submit with", command.front(),
        said.errors.empty() ? fmt::format("it ended with code {}", said.code) : said.errors);
  return said;
}

std::vector<std::string> said_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    if (!line.empty()) lines.push_back(line);
  return lines;
}

std::string comma_list(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ",") + word;
  return text;
}

std::vector<std::string> said_fields(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, '|');) fields.push_back(field);
  return fields;
}

/// "12|RUNNING|reason" a line, of an array "12_3" as well, counted by job, state and reason.
std::vector<JobState> counted_states(const std::string& text) {
  std::map<std::tuple<std::string, std::string, std::string>, int> count;
  for (const std::string& line : said_lines(text)) {
    std::vector<std::string> fields = said_fields(line);
    if (fields.size() < 2) continue;
    fields.resize(3);
    const bool no_reason = fields[2] == "None" || fields[2] == "(null)";
    ++count[{fields[0].substr(0, fields[0].find_first_of("_.")), fields[1].substr(0, fields[1].find(' ')),
             no_reason ? "" : fields[2]}];
  }
  std::vector<JobState> states;
  for (const auto& [what, tasks] : count)
    states.push_back({std::get<0>(what), std::get<1>(what), std::get<2>(what), tasks});
  return states;
}

/// "JobState=FAILED" of a line of scontrol.
std::string scontrol_value(const std::string& line, const std::string& name) {
  const std::size_t at = line.find(" " + name + "=");
  const std::size_t from = line.starts_with(name + "=") ? name.size() + 1 : at + name.size() + 2;
  if (at == std::string::npos && !line.starts_with(name + "=")) return {};
  return line.substr(from, line.find(' ', from) - from);
}

[[noreturn]] void refuse_partition(const std::string& partition) {
  std::string known;
  for (const std::string& name : said_lines(slurm_must_say({"sinfo", "--noheader", "--format=%R"}).text))
    known += (known.empty() ? "" : ", ") + name;
  throw scene::InputError(
      {scene::Issue{.file = "--partition " + partition,
                    .key = {},
                    .text = "Slurm has no partition of this name with nodes; it has " + known}});
}

}  // namespace

std::string submit_job(const std::filesystem::path& script, const std::string& dependency) {
  std::vector<std::string> command{"sbatch", "--parsable"};
  if (!dependency.empty())
    command.insert(command.end(), {"--dependency=" + dependency, "--kill-on-invalid-dep=yes"});
  command.push_back(script.string());
  const std::string said = slurm_must_say(command).text;
  return said.substr(0, said.find_first_of(";\n"));
}

std::vector<JobState> jobs_in_queue(const std::vector<std::string>& jobs) {
  // Slurm says "Invalid job id specified" where none of them is known any more.
  return counted_states(
      slurm_said({"squeue", "--noheader", "--array", "--format=%i|%T|%r", "--jobs=" + comma_list(jobs)})
          .text);
}

std::vector<JobState> ended_jobs(const std::vector<std::string>& jobs) {
  const Said accounting = slurm_said({"sacct", "--noheader", "--allocations", "--parsable2",
                                      "--format=JobID,State", "--jobs=" + comma_list(jobs)});
  std::string text = accounting.code == 0 ? accounting.text : "";
  if (text.empty())
    for (const std::string& job : jobs)
      for (const std::string& line :
           said_lines(slurm_said({"scontrol", "--oneliner", "show", "job", job}).text))
        text +=
            fmt::format("{}|{}|{}\n", job, scontrol_value(line, "JobState"), scontrol_value(line, "Reason"));
  std::vector<JobState> states = counted_states(text);
  std::erase_if(states, [](const JobState& job) {
    return job.state == "RUNNING" || job.state == "PENDING" || job.state == "COMPLETING";
  });
  return states;
}

std::optional<std::string> lowest_instruction_set(const std::string& partition) {
  std::vector<std::string> command{"sinfo", "--noheader", "--Node", "--format=%f"};
  if (!partition.empty()) command.push_back("--partition=" + partition);
  const std::vector<std::string> nodes = said_lines(slurm_must_say(command).text);
  if (nodes.empty()) refuse_partition(partition);
  constexpr std::array names{"baseline", "AVX2", "AVX-512"};
  std::size_t lowest = names.size() - 1;
  for (std::string features : nodes) {
    std::transform(features.begin(), features.end(), features.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (features.find("avx512") != features.npos || features.find("avx-512") != features.npos) continue;
    if (features.find("avx2") == features.npos) return std::nullopt;
    lowest = 1;
  }
  return names[lowest];
}

}  // namespace rift::studio
