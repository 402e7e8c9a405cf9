#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <string_view>

/// JSON that a file holds: read with one bound of depth and one of size, whoever wrote the file.
namespace rift::results {

/// No JSON text of ours nests deeper than this: nlohmann::json frees, compares and writes by recursion, so
/// that a text of a hundred thousand brackets would exhaust the stack.
inline constexpr int deepest_json = 64;
inline constexpr std::size_t largest_json = std::size_t{256} << 20;

/// Why a text is not read at all: "nests deeper than 64", "is larger than 256 MiB"; empty where it may be.
/// Cost O(|text|), no allocation.
[[nodiscard]] std::string_view trouble_with_json(std::string_view text);

/// The value of a JSON text; discarded (is_discarded()) where it is none or is not read at all.
template <class Json = nlohmann::ordered_json>
[[nodiscard]] Json json_or_discarded(std::string_view text) {
  if (!trouble_with_json(text).empty()) return Json(nlohmann::detail::value_t::discarded);
  return Json::parse(text, nullptr, false);
}

/// The same; throws WorldError with `path`, where the text stands, and the cause in place of a discarded
/// value.
[[nodiscard]] nlohmann::ordered_json read_json(std::string_view text, const std::filesystem::path& path);

}  // namespace rift::results
