#include "engine/base/json_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rift::base {
namespace {

/// The library escapes C0 only. DEL and C1 stand within strings alone, where \u00NN means the same.
std::string without_c1(std::string text) {
  if (text.find_first_of("\x7f\xc2") == std::string::npos) return text;
  std::string out;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const auto byte = static_cast<unsigned char>(text[k]);
    const auto next = static_cast<unsigned char>(k + 1 < text.size() ? text[k + 1] : '\0');
    if (byte == 0x7F) {
      out += "\\u007f";
    } else if (byte == 0xC2 && next >= 0x80 && next < 0xA0) {
      out += fmt::format("\\u{:04x}", next);
      ++k;
    } else {
      out += text[k];
    }
  }
  return out;
}

template <typename Json>
std::string text_of_json(const Json& value, int indent) {
  return without_c1(value.dump(indent, ' ', false, Json::error_handler_t::replace));
}

}  // namespace

std::string json_text(const nlohmann::ordered_json& value, int indent) { return text_of_json(value, indent); }
std::string json_text(const nlohmann::json& value, int indent) { return text_of_json(value, indent); }

}  // namespace rift::base
