#include "engine/scene/issue.hpp"

#include <fmt/format.h>

#include <utility>

namespace rift {

namespace {

std::string place(const Issue& issue) {
  if (issue.line == 0) return issue.file;
  if (issue.column == 0) return fmt::format("{}:{}", issue.file, issue.line);
  return fmt::format("{}:{}:{}", issue.file, issue.line, issue.column);
}

std::string joined(const std::vector<Issue>& issues) {
  std::string lines;
  for (const Issue& issue : issues) lines += (lines.empty() ? "" : "\n") + to_text(issue);
  return lines;
}

}  // namespace

std::string to_text(const Issue& issue) {
  if (issue.file == "--set") {
    const std::string given = issue.value.empty() ? issue.key : issue.key + "=" + issue.value;
    return fmt::format("--set {}: {}", given, issue.text);
  }
  if (issue.key.empty()) return fmt::format("{}: {}", place(issue), issue.text);
  const std::string given = issue.value.empty() ? issue.key : issue.key + " = " + issue.value;
  return fmt::format("{}: {}: {}", place(issue), given, issue.text);
}

InputError::InputError(std::vector<Issue> found)
    : std::runtime_error(joined(found)), issues(std::move(found)) {}

}  // namespace rift
