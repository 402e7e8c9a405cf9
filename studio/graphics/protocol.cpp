#include "studio/graphics/protocol.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace rift::studio {
namespace {

constexpr std::array names{std::pair{"cells", Graphics::cells}, std::pair{"symbols", Graphics::symbols},
                           std::pair{"sixel", Graphics::sixel}, std::pair{"kitty", Graphics::kitty},
                           std::pair{"iterm", Graphics::iterm}};

bool starts_with_any(std::string_view text, std::initializer_list<std::string_view> beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](std::string_view beginning) { return text.starts_with(beginning); });
}

}  // namespace

TerminalKind kind_of_terminal(std::string_view (*variable)(const char*), int colours, bool unicode,
                              bool wants_color) {
  TerminalKind kind;
  kind.term = variable("TERM");
  kind.multiplexer =
      !variable("TMUX").empty() || !variable("STY").empty() || starts_with_any(kind.term, {"tmux", "screen"});
  kind.iterm =
      !kind.multiplexer && (variable("TERM_PROGRAM") == "iTerm.app" || variable("LC_TERMINAL") == "iTerm2");
  kind.unicode = unicode;
  const std::string_view deep = variable("COLORTERM");
  kind.colours = !wants_color || colours < 8                     ? Colours::two
                 : deep == "truecolor" || deep == "24bit"        ? Colours::all
                 : kind.term.find("direct") != std::string::npos ? Colours::all
                 : colours >= 256                                ? Colours::many
                 : colours >= 16                                 ? Colours::sixteen
                                                                 : Colours::eight;
  return kind;
}

std::optional<Graphics> graphics_named(std::string_view word) {
  for (const auto& [name, graphics] : names)
    if (word == name) return graphics;
  return std::nullopt;
}

std::string_view name_of(Graphics graphics) {
  for (const auto& [name, one] : names)
    if (graphics == one) return name;
  return {};
}

Graphics chosen_graphics(std::optional<Graphics> asked, const Capabilities& capabilities) {
  if (asked) return *asked;
  if (capabilities.kitty) return Graphics::kitty;
  if (capabilities.sixel) return Graphics::sixel;
  if (capabilities.iterm) return Graphics::iterm;
  return Graphics::symbols;
}

// A terminal that does not know an application's string shows it, and a multiplexer takes it for a title:
// only terminals after xterm's manner are sent one.
std::string question_for(const TerminalKind& kind) {
  const bool knows_strings =
      !kind.multiplexer && !starts_with_any(kind.term, {"linux", "vt", "cons", "ansi", "dumb"});
  std::string question;
  if (knows_strings) {
    question += "\033_Gi=31,s=1,v=1,a=q,t=d,f=24;AAAA\033\\";  // kitty's pictures
    question += "\033[?2;1;0S";                                // the largest sixel
    question += "\033[14t\033[16t";                            // the window and a cell in pixels
  }
  return question + "\033[c";  // device attributes
}

}  // namespace rift::studio
