#include "studio/screen/keymap.hpp"
#include "studio/screen/prompt.hpp"
#include "tests/expectations.hpp"

#include <gtest/gtest.h>

#include <map>

namespace rift::studio {
namespace {

constexpr Where screens[] = {Where::home,    Where::form,   Where::live,       Where::watch, Where::study,
                             Where::compare, Where::lesson, Where::lesson_run, Where::view};

TEST(Keymap, AKeyMeansOneThingOnAScreen) {
  for (const Where where : screens) {
    std::map<int, std::string> meant;
    for (const Binding& b : not_empty(bindings())) {
      if (b.where != where && b.where != Where::anywhere) continue;
      for (const int key : {b.key, b.other}) {
        if (key == key_none) continue;
        const auto [it, fresh] = meant.emplace(key, b.label);
        EXPECT_TRUE(fresh) << static_cast<int>(where) << ": " << b.label << " and " << it->second;
      }
    }
    EXPECT_GT(meant.size(), 2U) << static_cast<int>(where) << ": help, leave and what the screen is for";
  }
}

TEST(Keymap, EveryBindingIsActedOnAndExplained) {
  for (const Binding& b : not_empty(bindings())) {
    EXPECT_FALSE(b.help.empty()) << b.label;
    const Where where = b.where == Where::anywhere ? Where::home : b.where;
    EXPECT_EQ(action_of(where, b.key), b.action) << b.label;
  }
  EXPECT_EQ(action_of(Where::live, 'k'), Action::up);
  EXPECT_EQ(action_of(Where::live, 'Z'), Action::none);
  EXPECT_EQ(action_of(Where::home, key_none), Action::none);
}

TEST(Keymap, TheFootFitsAndAlwaysTellsHelpAndTheWayOut) {
  for (const Where where : screens)
    for (int width = 24; width < 200; ++width) {
      const std::string foot = foot_of(where, width);
      EXPECT_LE(static_cast<int>(foot.size()), width) << foot;
      EXPECT_NE(foot.find("? keys"), std::string::npos) << foot;
      EXPECT_NE(foot.find("q leave"), std::string::npos) << foot;
    }
}

TEST(Keymap, HelpListsEveryKeyOfTheScreen) {
  Canvas canvas(120, 50);
  EXPECT_EQ(draw_help(canvas, Where::live, 0, Glyphs::unicode), 0);
  std::string text;
  for (int y = 0; y < 50; ++y) text += canvas.row(y) + "\n";
  int listed = 0;
  for (const Binding& b : bindings()) {
    if (b.where != Where::live && b.where != Where::anywhere) continue;
    EXPECT_NE(text.find(std::string(b.help)), std::string::npos) << b.help;
    ++listed;
  }
  EXPECT_GT(listed, 10);
  EXPECT_EQ(text.find("Mark a run"), std::string::npos);  // of the first screen
}

TEST(Keymap, HelpOfEveryScreenIsReadPageByPageOnAnOrdinaryTerminal) {
  for (const Where where : screens) {
    std::string text;
    int from = 0, pages = 0;
    do {
      Canvas canvas(80, 24);
      from = draw_help(canvas, where, from, Glyphs::unicode);
      for (int y = 0; y < 24; ++y) text += canvas.row(y) + "\n";
    } while (from > 0 && ++pages < 9);
    for (const Binding& b : bindings())
      if (b.where == where || b.where == Where::anywhere) {
        EXPECT_NE(text.find(std::string(b.help)), std::string::npos) << b.help << " in\n" << text;
      }
  }
}

TEST(Prompt, TakesLettersOfAnyAlphabetAndDropsThemWhole) {
  Prompt prompt("name", "");
  for (const int letter : {int{'a'}, 0xFC, 0x1D70E}) prompt.press({letter});
  EXPECT_EQ(prompt.text(), "aü\U0001D70E");
  prompt.press({key_backspace});
  EXPECT_EQ(prompt.text(), "aü");
  prompt.press({key_backspace});
  EXPECT_EQ(prompt.text(), "a");
  prompt.press({key_up});  // no letter
  EXPECT_EQ(prompt.text(), "a");
  EXPECT_EQ(prompt.press({key_enter}), Prompt::State::entered);
  EXPECT_FALSE(prompt.typing());
  Prompt given_up("name", "x");
  EXPECT_EQ(given_up.press({key_escape}), Prompt::State::cancelled);
}

TEST(Prompt, TheEndOfALongTextIsAlwaysToBeSeen) {
  Canvas canvas(12, 1);
  Prompt("n", "abcdefghijklmnop").draw(canvas, {0, 0, 12, 1});
  EXPECT_EQ(canvas.row(0), "n: ijklmnop");
}

TEST(ListView, TheChosenRowStaysOnTheScreen) {
  ListView list;
  for (int k = 0; k < 30; ++k) {
    list.move(Action::down, 20, 5);
    EXPECT_LE(list.chosen, 19);
    EXPECT_TRUE(list.top <= list.chosen && list.chosen < list.top + 5);
  }
  EXPECT_EQ(list.chosen, 19);
  list.move(Action::first, 20, 5);
  EXPECT_EQ(list.top, 0);
  list.move(Action::page_down, 20, 5);
  EXPECT_EQ(list.chosen, 4);
  list.move(Action::down, 0, 5);
  EXPECT_EQ(list.chosen, 0);
  EXPECT_FALSE(list.move(Action::pause, 20, 5));
}

}  // namespace
}  // namespace rift::studio
