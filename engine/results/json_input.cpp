#include "engine/results/json_input.hpp"

#include "engine/base/world_error.hpp"

namespace rift::results {

std::string_view trouble_with_json(std::string_view text) {
  static_assert(deepest_json == 64 && largest_json == std::size_t{256} << 20);  // as the words say
  if (text.size() > largest_json) return "is larger than 256 MiB";
  int depth = 0;
  bool quoted = false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (quoted) {
      if (c == '\\') ++k;
      quoted = c != '"';
    } else if (c == '"') {
      quoted = true;
    } else if (c == '[' || c == '{') {
      if (++depth > deepest_json) return "nests deeper than 64";
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return {};
}

nlohmann::ordered_json read_json(std::string_view text, const std::filesystem::path& path) {
  if (const std::string_view trouble = trouble_with_json(text); !trouble.empty())
    throw base::WorldError("read", path, "its JSON " + std::string(trouble));
  nlohmann::ordered_json value = nlohmann::ordered_json::parse(text, nullptr, false);
  if (value.is_discarded()) throw base::WorldError("read", path, "its JSON is damaged");
  return value;
}

}  // namespace rift::results
