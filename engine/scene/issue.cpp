#include "engine/scene/issue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace rift::scene {

namespace {

std::string place(const Issue& issue) {
  if (issue.line == 0) return issue.file;
  if (issue.column == 0) return fmt::format("{}:{}", issue.file, issue.line);
  return fmt::format("{}:{}:{}", issue.file, issue.line, issue.column);
}

std::string joined(const std::vector<Issue>& issues) {
  std::string lines;
  const std::size_t shown = std::min(issues.size(), most_issues_shown);
  for (std::size_t k = 0; k < shown; ++k) lines += (k == 0 ? "" : "\n") + to_text(issues[k]);
  if (issues.size() > shown) lines += fmt::format("\nand {} more", issues.size() - shown);
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

}  // namespace rift::scene
