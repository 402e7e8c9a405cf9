#include "studio/charts/label.hpp"

#include "engine/base/text.hpp"

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

namespace {

/// Whether a subscript or superscript ends before this byte: a group in braces, or one letter.
bool ends_script(std::string_view label, std::size_t at) {
  if (at < 2) return false;
  if (label[at - 1] == '}') return true;
  std::size_t letter = at - 1;
  while (letter > 1 && base::continues_letter(label[letter])) --letter;
  const std::size_t markup = letter - 1;
  return (label[markup] == '_' || label[markup] == '^') && (markup == 0 || label[markup - 1] != '\\');
}

}  // namespace

std::string label_string(std::string_view label) {
  constexpr std::string_view joiner = "\u2060";  // without width; not a blank
  std::string out;
  for (std::size_t k = 0; k < label.size(); ++k) {
    if (label[k] == ' ' && ends_script(label, k)) out += joiner;
    out += label[k];
  }
  return script_string(out);
}

std::size_t letters(std::string_view label) { return base::count_letters(plain_text(label)); }

std::string gnuplot_field(std::string text) {
  text = base::escaped(text, "\n\r");
  for (char& c : text) {
    if (c == ',') c = ';';
    if (c == '"') c = '\'';
    if (c == '\n' || c == '\r') c = ' ';
  }
  return text;
}

}  // namespace rift::studio
