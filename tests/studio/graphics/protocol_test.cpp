#include "studio/graphics/protocol.hpp"

#include <gtest/gtest.h>

#include <map>

namespace rift::studio {
namespace {

std::map<std::string, std::string> environment;

std::string_view variable(const char* name) { return environment[name]; }

TerminalKind kind_with(std::map<std::string, std::string> variables, int colours = 256) {
  environment = std::move(variables);
  return kind_of_terminal(variable, colours, true, true);
}

TEST(Graphics, TheBestThatIsAnsweredIsChosenUnlessOneIsAskedFor) {
  EXPECT_EQ(chosen_graphics({}, {}), Graphics::symbols);
  EXPECT_EQ(chosen_graphics({}, {.answers = true, .sixel = true}), Graphics::sixel);
  EXPECT_EQ(chosen_graphics({}, {.answers = true, .sixel = true, .kitty = true}), Graphics::kitty);
  EXPECT_EQ(chosen_graphics({}, {.iterm = true}), Graphics::iterm);
  EXPECT_EQ(chosen_graphics(Graphics::cells, {.kitty = true}), Graphics::cells);
}

TEST(Graphics, NamesGoThereAndBack) {
  for (const Graphics g :
       {Graphics::cells, Graphics::symbols, Graphics::sixel, Graphics::kitty, Graphics::iterm})
    EXPECT_EQ(graphics_named(name_of(g)), g);
  EXPECT_EQ(graphics_named("auto"), std::nullopt);
  EXPECT_EQ(graphics_named("sixels"), std::nullopt);
}

TEST(Graphics, OnlyTerminalsThatKnowStringsAreSentOne) {
  const auto asks_kitty = [](const TerminalKind& kind) {
    return question_for(kind).find("\033_G") != std::string::npos;
  };
  EXPECT_TRUE(asks_kitty(kind_with({{"TERM", "xterm-256color"}})));
  EXPECT_TRUE(asks_kitty(kind_with({{"TERM", "xterm-kitty"}})));
  EXPECT_FALSE(asks_kitty(kind_with({{"TERM", "linux"}})));
  EXPECT_FALSE(asks_kitty(kind_with({{"TERM", "vt220"}})));
  EXPECT_FALSE(asks_kitty(kind_with({{"TERM", "screen-256color"}})));
  EXPECT_FALSE(asks_kitty(kind_with({{"TERM", "xterm-256color"}, {"TMUX", "/tmp/tmux"}})));
  for (const char* term : {"xterm", "linux", "tmux"})
    EXPECT_TRUE(question_for(kind_with({{"TERM", term}})).ends_with("\033[c"))
        << "its answer ends the waiting";
}

TEST(Graphics, ColoursAreThoseOfTheTerminal) {
  EXPECT_EQ(kind_with({{"COLORTERM", "truecolor"}}).colours, Colours::all);
  EXPECT_EQ(kind_with({}, 256).colours, Colours::many);
  EXPECT_EQ(kind_with({}, 16).colours, Colours::sixteen);
  EXPECT_EQ(kind_with({}, 8).colours, Colours::eight);
  EXPECT_EQ(kind_with({}, -1).colours, Colours::two);
  environment = {{"COLORTERM", "truecolor"}};
  EXPECT_EQ(kind_of_terminal(variable, 256, true, false).colours, Colours::two);
  EXPECT_TRUE(kind_with({{"TERM_PROGRAM", "iTerm.app"}}).iterm);
  EXPECT_FALSE(kind_with({{"TERM_PROGRAM", "iTerm.app"}, {"TMUX", "x"}}).iterm);
}

}  // namespace
}  // namespace rift::studio
