#include "studio/report/label.hpp"

#include "engine/base/text.hpp"

#include <algorithm>

namespace rift::studio {

std::string escape_label(std::string_view text) {
  std::string out;
  for (const char c : base::escaped(text)) {
    if (std::string_view("\\_^{}@&~").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

std::string plain_text(std::string_view label) {
  std::string out;
  for (std::size_t k = 0; k < label.size(); ++k) {
    if (label[k] == '\\' && k + 1 < label.size())
      out += label[++k];
    else if (label[k] != '{' && label[k] != '}')
      out += label[k];
  }
  return out;
}

std::string script_string(std::string_view label) {
  std::string out = "'";
  for (const char c : base::escaped(label, "\n\r")) {
    out += c == '\n' || c == '\r' ? ' ' : c;
    if (c == '\'') out += '\'';
  }
  return out + "'";
}

std::size_t letters(std::string_view label) {
  const std::string text = plain_text(label);
  const auto begins_a_letter = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins_a_letter));
}

std::string csv_field(std::string text) {
  text = base::escaped(text, "\n\r");
  for (char& c : text) {
    if (c == ',') c = ';';
    if (c == '"') c = '\'';
    if (c == '\n' || c == '\r') c = ' ';
  }
  return text;
}

}  // namespace rift::studio
