#include "studio/commands/budget.hpp"

#include "engine/scene/issue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace rift::studio {

std::optional<double> read_budget(const std::string& command, const std::string& text) {
  if (text.empty()) return std::nullopt;
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, value);
  std::string unit(at, end);
  unit.erase(0, std::min(unit.find_first_not_of(' '), unit.size()));
  const double seconds = unit == "s" ? 1.0 : unit == "min" ? 60.0 : unit == "h" ? 3600.0 : 0.0;
  if (error != std::errc() || seconds == 0.0 || !(value > 0.0) || !(value * seconds < 1e9))
    throw scene::InputError({scene::Issue{
        .file = command,
        .key = {},
        .text = fmt::format(
            "--budget {}: expected a time with its unit, such as \"90 s\", \"10 min\" or \"2 h\"", text)}});
  return value * seconds;
}

}  // namespace rift::studio
