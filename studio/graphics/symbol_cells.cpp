#include "studio/graphics/symbol_cells.hpp"

#include "studio/graphics/answers.hpp"
#include "studio/graphics/encoder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace rift::studio {
namespace {

/// "38;2;200;10;0;7" part by part.
std::vector<std::string_view> parts_of(std::string_view text) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find(';');
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

int number_of(std::string_view text) {
  int number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

/// SGR, as far as pictures use it   [ECMA-48, 8.3.117].
void apply(std::string_view parameters, SymbolCell& style) {
  const std::vector<std::string_view> parts = parts_of(parameters);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const int code = number_of(parts[k]);
    std::string& colour = code / 10 % 10 == 4 || code / 10 == 10 ? style.background : style.foreground;
    if (code == 0) {
      style = {};
    } else if (code == 7 || code == 27) {
      style.reverse = code == 7;
    } else if (code == 39 || code == 49) {
      colour.clear();
    } else if (code == 38 || code == 48) {  // "38;5;N" or "38;2;R;G;B"
      const std::size_t more = k + 1 < parts.size() && number_of(parts[k + 1]) == 2 ? 4 : 2;
      const std::size_t last = std::min(k + more, parts.size() - 1);
      colour.assign(parts[k].data(), parts[last].data() + parts[last].size());
      k = last;
    } else if (code >= 30 && code <= 107) {
      colour = parts[k];
    }
  }
}

std::size_t length_of_letter(char first) {
  const auto byte = static_cast<unsigned char>(first);
  return byte < 0x80 ? 1 : byte < 0xe0 ? 2 : byte < 0xf0 ? 3 : 4;
}

SymbolCell as_seen(SymbolCell cell) {
  if (cell.letter == "█" && !cell.reverse && !cell.foreground.empty())
    cell.letter = " ", cell.background = cell.foreground;
  if (cell.letter == " " && !cell.reverse) cell.foreground.clear();
  return cell;
}

/// "38;2;R;G;B" with each in steps; others as they are.
std::string coarse(const std::string& colour) {
  constexpr int step = 16;
  const std::vector<std::string_view> parts = parts_of(colour);
  if (parts.size() != 5 || parts[1] != "2") return colour;
  std::string result = fmt::format("{};2", parts[0]);
  for (std::size_t k = 2; k < 5; ++k)
    result += fmt::format(";{}", std::min(255, (number_of(parts[k]) + step / 2) / step * step));
  return result;
}

/// The same colour of the other ground: 38 becomes 48, 31 becomes 41, and back.
std::string exchanged(const std::string& colour, bool to_background) {
  if (colour.empty()) return colour;
  const std::size_t end = std::min(colour.find(';'), colour.size());
  const int code = number_of(std::string_view(colour).substr(0, end)) + (to_background ? 10 : -10);
  return fmt::format("{}{}", code, colour.substr(end));
}

/// The other half of a half block; empty for other letters.
std::string_view other_half(std::string_view letter) {
  constexpr std::array<std::string_view, 4> halves{"▀", "▄", "▌", "▐"};
  const auto at = std::find(halves.begin(), halves.end(), letter);
  return at == halves.end() ? std::string_view{} : halves[static_cast<std::size_t>(at - halves.begin()) ^ 1U];
}

bool is_blank(const SymbolCell& cell) { return cell.letter == " " && !cell.reverse; }

}  // namespace

std::vector<SymbolCell> cells_of(std::string_view row) {
  std::vector<SymbolCell> cells;
  SymbolCell style;
  while (!row.empty()) {
    if (const int length = length_of_sequence(row); length > 0) {
      if (row[static_cast<std::size_t>(length) - 1] == 'm')
        apply(row.substr(2, static_cast<std::size_t>(length) - 3), style);
      row.remove_prefix(static_cast<std::size_t>(length));
      continue;
    }
    style.letter = row.substr(0, length_of_letter(row.front()));
    cells.push_back(as_seen(style));
    row.remove_prefix(style.letter.size());
  }
  return cells;
}

void make_coarse(SymbolCell& cell) {
  cell.foreground = coarse(cell.foreground);
  cell.background = coarse(cell.background);
  if (cell.background.size() > 2 && cell.foreground.size() == cell.background.size() &&
      cell.foreground.compare(2, std::string::npos, cell.background, 2) == 0)
    cell.letter = " ";
  cell = as_seen(std::move(cell));
}

/// Of a blank any foreground will do.
void SymbolChanges::set_colours(const SymbolCell& cell, bool first) {
  const bool same_foreground = is_blank(cell) || cell.foreground == now_.foreground;
  const bool to_own = (!same_foreground && cell.foreground.empty()) ||
                      (cell.background.empty() && !now_.background.empty()) || now_.reverse != cell.reverse;
  std::string parameters;
  const auto say = [&](const std::string& part) { parameters += (parameters.empty() ? "" : ";") + part; };
  if (first || to_own) {
    say("0");
    now_ = {};
    if (cell.reverse) say("7");
  }
  if (!is_blank(cell) && cell.foreground != now_.foreground) say(cell.foreground), now_.foreground = cell.foreground;
  if (cell.background != now_.background) say(cell.background), now_.background = cell.background;
  now_.reverse = cell.reverse;
  if (!parameters.empty()) codes_ += "\033[" + parameters + "m";
}

/// As the other half where one of the colours need not be said then.
SymbolCell SymbolChanges::as_cheap(const SymbolCell& cell) const {
  const std::string_view half = other_half(cell.letter);
  if (half.empty() || cell.reverse || now_.reverse || cell.foreground.empty() || cell.background.empty())
    return cell;
  SymbolCell other{std::string(half), exchanged(cell.background, false), exchanged(cell.foreground, true)};
  const auto said = [&](const SymbolCell& one) {
    return (one.foreground == now_.foreground ? 0 : 1) + (one.background == now_.background ? 0 : 1);
  };
  return said(other) < said(cell) ? other : cell;
}

void SymbolChanges::add(int x, int y, const std::vector<SymbolCell>& before,
                        const std::vector<SymbolCell>& after) {
  std::string place = at_cell(x, y);
  int passed = 0;  // cells that stay, since the last one that changed
  for (std::size_t k = 0; k < after.size(); ++k) {
    if (k < before.size() && before[k] == after[k]) {
      ++passed;
      continue;
    }
    const SymbolCell cell = as_cheap(after[k]);
    if (!place.empty() && passed > 0) place = at_cell(x + passed, y);
    if (place.empty() && passed > 0) place = fmt::format("\033[{}C", passed);
    const bool first = codes_.empty();
    codes_ += place;
    set_colours(cell, first);
    codes_ += cell.letter;
    place.clear();
    passed = 0;
  }
}

std::string SymbolChanges::codes() const { return codes_.empty() ? codes_ : codes_ + "\033[0m"; }

}  // namespace rift::studio
