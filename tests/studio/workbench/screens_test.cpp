#include "engine/base/ownership.hpp"
#include "engine/results/archive.hpp"
#include "studio/screen/layouts.hpp"
#include "studio/workbench/compare_screen.hpp"
#include "studio/workbench/form_screen.hpp"
#include "studio/workbench/home_screen.hpp"
#include "studio/workbench/lesson_screen.hpp"
#include "studio/workbench/panel_screen.hpp"
#include "studio/workbench/screen.hpp"
#include "studio/workbench/study_screen.hpp"
#include "tests/studio/commands/tiny_plate.hpp"

#include <chrono>
#include <thread>

namespace rift::studio {
namespace {

namespace fs = std::filesystem;

std::string text_of(Screen& screen, int width = 120, int height = 40, Glyphs glyphs = Glyphs::unicode) {
  Canvas canvas(width, height);
  screen.draw(canvas, glyphs);
  std::string text;
  for (int y = 0; y < height; ++y) text += canvas.row(y) + "\n";
  return text;
}

Navigation type(Screen& screen, const std::string& keys) {
  Navigation navigation;
  for (const char key : keys) navigation = screen.press({key});
  return navigation;
}

/// A context in a folder of its own with one tiny preset.
struct Shop {
  TinyPlate plate;
  AppContext context;

  Shop() {
    fs::create_directories(plate.path() / "presets");
    fs::copy_file(plate.preset(), plate.path() / "presets" / "plate_tiny.toml");
    context.presets = plate.path() / "presets";
    context.own_presets = plate.path() / "own";
    context.runs = plate.path() / "runs";
    context.studies = plate.path() / "studies";
    context.program = RIFT_EXE;
    context.cache = shared_cache();
  }
  fs::path preset() const { return context.presets / "plate_tiny.toml"; }
  Ran run(const std::string& name, const std::string& more = "") const {
    return run_rift(
        "run '" + preset().string() + "' --quiet --out '" + (context.runs / name).string() + "' " + more,
        plate.environment());
  }
};

void expect_drawn_at_any_size(Screen& screen) {
  for (const int width : {1, 2, 7, 20, 59, 60, 61, 80, 99, 100, 120, 200, 300})
    for (const int height : {1, 2, 3, 10, 15, 16, 17, 24, 40, 60, 100}) {
      Canvas canvas(width, height);
      screen.draw(canvas, Glyphs::ascii);
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
          ASSERT_LT(canvas.at(x, y).glyph, 256U) << width << "x" << height << " at " << x << "," << y;
    }
  EXPECT_NE(text_of(screen, 40, 10).find("40x10 is too small: 60x16 needed"), std::string::npos);
}

TEST(HomeScreen, ShowsPresetsByGroupLessonsAndRunsWithTheirOutcome) {
  const Shop shop;
  ASSERT_EQ(shop.run("first").exit_code, 0);
  AppContext context = shop.context;
  HomeScreen home(context);
  const std::string text = text_of(home);
  for (const char* part : {"Start here", "plate_tiny", "A tiny plate", "Lessons", "node-release",
                           "Recent runs", "first", "finished", "enter open"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
  expect_drawn_at_any_size(home);
}

TEST(HomeScreen, ShowsWhatIsOnesOwnFirstAndEveryPresetInItsGroup) {
  Shop shop;
  ASSERT_EQ(shop.run("first").exit_code, 0);
  fs::create_directories(shop.context.own_presets);
  fs::copy_file(shop.preset(), shop.context.own_presets / "mine.toml");
  for (const char* name : {"experiment_twin", "path_curved", "table2_elastic_parameters", "sec2_linear"})
    fs::copy_file(shop.preset(), shop.context.presets / (std::string(name) + ".toml"));
  HomeScreen home(shop.context);
  const std::string text = text_of(home);
  std::size_t before = 0;
  for (const char* part :
       {"Recent runs", "first", "Your presets", "mine", "Start here", "plate_tiny", "From a measured crack",
        "experiment_twin", "Inclined, curved", "path_curved", "Figures, tables and sections",
        "table2_elastic_parameters", "sec2_linear", "Lessons"}) {
    const std::size_t at = text.find(part, before);
    ASSERT_NE(at, std::string::npos) << part << " in\n" << text;
    before = at;
  }
  EXPECT_EQ(text.find("Others"), std::string::npos);
  type(home, "\t\t");
  Canvas canvas(120, 40);
  const auto chosen = [&] {
    home.draw(canvas, Glyphs::unicode);
    for (int y = 2; y < 36; ++y)
      if (canvas.at(4, y).style.reverse) return canvas.row(y);
    return std::string();
  };
  ASSERT_NE(chosen().find("plate_tiny"), std::string::npos) << text_of(home);
  ASSERT_EQ(shop.run("second").exit_code, 0);
  home.resume();
  EXPECT_NE(chosen().find("plate_tiny"), std::string::npos) << "a run more above it: " << text_of(home);
}

TEST(HomeScreen, GivesADescriptionTheWholeLine) {
  Shop shop;
  const std::string shows = "A description of seventy letters and some more, which ends with the word END";
  write_text(shop.context.presets / "fig99.toml", "# " + shows + "\n" + read_text(shop.preset()));
  HomeScreen home(shop.context);
  EXPECT_NE(text_of(home, 110, 34).find(shows), std::string::npos) << text_of(home, 110, 34);
}

TEST(HomeScreen, SearchShowsOnlyWhatHoldsTheLetters) {
  Shop shop;
  HomeScreen home(shop.context);
  type(home, "/DAMP");
  EXPECT_TRUE(home.typing());
  home.press({key_enter});
  const std::string text = text_of(home);
  EXPECT_EQ(text.find("plate_tiny"), std::string::npos);
  EXPECT_NE(text.find("Can damping repair"), std::string::npos);
  type(home, "/\x15lesson\n");  // a whole group by its name
  EXPECT_NE(text_of(home).find("Can damping repair"), std::string::npos) << text_of(home);
  EXPECT_NE(text_of(home).find("node-release"), std::string::npos) << text_of(home);
  type(home, "/zzzz\n");
  EXPECT_NE(text_of(home).find("no entry contains these letters"), std::string::npos);
  EXPECT_EQ(home.press({key_enter}).to, Navigation::To::stay);
}

TEST(HomeScreen, DeletesARunOnlyAfterYes) {
  Shop shop;
  ASSERT_EQ(shop.run("first").exit_code, 0);
  HomeScreen home(shop.context);
  home.press({key_home});
  type(home, "dno\n");
  EXPECT_TRUE(fs::exists(shop.context.runs / "first"));
  {
    const base::FolderLock lock(shop.context.runs / "first");
    type(home, "dyes\n");
    EXPECT_TRUE(fs::exists(shop.context.runs / "first")) << "it is being written";
  }
  type(home, "dyes\n");
  EXPECT_FALSE(fs::exists(shop.context.runs / "first"));
  home.press({key_end});
  type(home, "d");
  EXPECT_NE(text_of(home).find("presets cannot be deleted here"), std::string::npos);
}

TEST(HomeScreen, ComparesTheMarkedRuns) {
  Shop shop;
  ASSERT_EQ(shop.run("first").exit_code, 0);
  ASSERT_EQ(shop.run("second", "--set crack.technique=simple").exit_code, 0);
  HomeScreen home(shop.context);
  home.press({key_home});
  type(home, " c");
  EXPECT_NE(text_of(home).find("mark two or more runs"), std::string::npos);
  home.press({key_down});
  const Navigation navigation = type(home, " c");
  ASSERT_EQ(navigation.to, Navigation::To::forward);
  const std::string text = text_of(*navigation.next);
  for (const char* part :
       {"2 scenarios side by side", "first: progressive", "second: simple", "G_ID / G_I0", "balance error"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
  expect_drawn_at_any_size(*navigation.next);
}

/// A picture that says what it is asked for.
struct Told {
  std::vector<fs::path> runs;
  PlateView view;
  Area place;
};

MakePlatePicture told_picture(Told& told) {
  struct Picture : PlatePicture {
    explicit Picture(Told& to) : told(to) {}
    void look(const Area& place, const PictureRoom&, const PlateView& view) override {
      told.place = place, told.view = view;
    }
    std::optional<ScreenPicture> picture() const override {
      if (told.place.empty()) return {};
      return ScreenPicture{.area = told.place, .width = 2, .height = 2, .rgb = pixels, .number = 1};
    }
    int descriptor() const override { return -1; }
    std::string trouble() const override { return {}; }
    Told& told;
    std::vector<std::uint8_t> pixels = std::vector<std::uint8_t>(12);
  };
  return [&told](const std::vector<fs::path>& runs) {
    told.runs = runs;
    return std::make_unique<Picture>(told);
  };
}

constexpr PictureRoom pixels_room{.pictures = true, .cell_width = 10, .cell_height = 20};

/// A round of the event loop.
void round_of(Screen& screen, const PictureRoom& room, Canvas& canvas) {
  if (screen.wants_picture()) screen.take_room(room);
  (void)screen.look();
  screen.draw(canvas, Glyphs::unicode);
}

/// Whether nothing is written where a picture lies.
bool is_blank(const Canvas& canvas, const Area& area) {
  for (int y = area.y; y < area.y + area.height; ++y)
    for (int x = area.x; x < area.x + area.width; ++x)
      if (canvas.at(x, y).glyph != U' ') return false;
  return true;
}

bool rounds_until(Screen& screen, const PictureRoom& room, const std::function<bool(const Canvas&)>& is_so) {
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(patience_s);
  while (std::chrono::steady_clock::now() < until) {
    Canvas canvas(120, 40);
    round_of(screen, room, canvas);
    if (is_so(canvas)) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return false;
}

std::string all_of(const Canvas& canvas) {
  std::string text;
  for (int y = 0; y < canvas.height(); ++y) text += canvas.row(y) + "\n";
  return text;
}

TEST(HomeScreen, ShowsTheLoadedSpecimenOfAPresetInCellsOrAsAPicture) {
  Shop shop;
  for (const bool pixels : {false, true}) {
    Told told;
    shop.context.plate_picture = told_picture(told);
    HomeScreen home(shop.context);
    EXPECT_FALSE(home.wants_picture());
    type(home, "p");
    EXPECT_TRUE(home.wants_picture());
    ASSERT_TRUE(rounds_until(home, pixels ? pixels_room : PictureRoom{}, [&](const Canvas& canvas) {
      return all_of(canvas).find(" elements, ") != std::string::npos &&
             (pixels ? home.picture().has_value() : all_of(canvas).find("▀") != std::string::npos);
    }));
    if (pixels) {
      EXPECT_TRUE(fs::exists(told.runs.at(0) / results::journal_name));
      Canvas canvas(120, 40);
      round_of(home, pixels_room, canvas);
      EXPECT_TRUE(is_blank(canvas, home.picture()->area)) << all_of(canvas);
    } else {
      EXPECT_TRUE(told.runs.empty());
    }
    expect_drawn_at_any_size(home);
    type(home, "p");
    EXPECT_FALSE(home.picture());
  }
}

TEST(HomeScreen, ShowsTheLastMomentOfARun) {
  Shop shop;
  ASSERT_EQ(shop.run("first").exit_code, 0);
  Told told;
  shop.context.plate_picture = told_picture(told);
  HomeScreen home(shop.context);
  type(home, "p");
  ASSERT_TRUE(rounds_until(home, pixels_room, [&](const Canvas&) { return home.picture().has_value(); }));
  EXPECT_EQ(told.runs.at(0), shop.context.runs / "first");
  home.press({key_down});
  home.press({key_down});
  Canvas canvas(120, 40);
  round_of(home, pixels_room, canvas);
  EXPECT_FALSE(home.picture()) << "of another row";
}

TEST(CompareScreen, ShowsThePlatesOfTheRunsAtOneMoment) {
  Shop shop;
  ASSERT_EQ(shop.run("first").exit_code, 0);
  ASSERT_EQ(shop.run("second").exit_code, 0);
  Told told;
  shop.context.plate_picture = told_picture(told);
  const std::vector<fs::path> runs{shop.context.runs / "first", shop.context.runs / "second"};
  CompareScreen screen(shop.context, runs);
  Canvas canvas(120, 40);
  type(screen, "p");
  round_of(screen, PictureRoom{}, canvas);
  EXPECT_NE(all_of(canvas).find("▀"), std::string::npos) << "cells: " << all_of(canvas);
  round_of(screen, pixels_room, canvas);
  round_of(screen, pixels_room, canvas);
  EXPECT_EQ(told.runs, runs);
  EXPECT_TRUE(told.view.lanes.empty());
  EXPECT_TRUE(told.view.titles);
  EXPECT_EQ(told.view.until, 1);
  Canvas drawn(120, 40);
  round_of(screen, pixels_room, drawn);
  ASSERT_TRUE(screen.picture());
  EXPECT_TRUE(is_blank(drawn, screen.picture()->area)) << all_of(drawn);
  screen.press({key_left});
  round_of(screen, pixels_room, canvas);
  EXPECT_NEAR(told.view.until, 0.975, 1e-12);
  expect_drawn_at_any_size(screen);
  type(screen, "p");
  EXPECT_FALSE(screen.picture());
}

TEST(HomeScreen, AClickChoosesAndASecondOneOpens) {
  Shop shop;
  HomeScreen home(shop.context);
  Canvas canvas(100, 30);
  home.draw(canvas, Glyphs::unicode);
  int lesson = 0;
  while (canvas.row(lesson).find("velocity") == std::string::npos) ++lesson;
  EXPECT_EQ(home.press({key_click, 10, 2}).to, Navigation::To::stay);  // a heading
  EXPECT_EQ(home.press({key_click, 10, lesson}).to, Navigation::To::stay);
  EXPECT_NE(text_of(home).find("What a faster crack leaves behind"), std::string::npos);
  EXPECT_EQ(home.press({key_click, 10, 3}).to, Navigation::To::stay);
  const Navigation navigation = home.press({key_click, 10, 3});
  ASSERT_EQ(navigation.to, Navigation::To::forward);
  EXPECT_EQ(navigation.next->where(), Where::form);
}

TEST(HomeScreen, ResumesWhatWasStoppedAndSaysWhatHasEnded) {
  Shop shop;
  ASSERT_EQ(shop.run("first").exit_code, 0);
  HomeScreen home(shop.context);
  home.press({key_home});
  EXPECT_EQ(type(home, "u").to, Navigation::To::stay);
  EXPECT_NE(text_of(home).find("is already finished"), std::string::npos);
  const std::string second = (shop.context.runs / "second").string();
  run_shell("for limit in 0.1 0.2 0.4 0.8 1.6; do env " +
            shop.plate.environment() +  // on a machine of any speed
            " timeout -s INT $limit '" RIFT_EXE "' run '" + shop.preset().string() +
            "' --quiet --force --set 'crack.velocity=0.006 c_r' --out '" + second + "'; test -e '" + second +
            "/journal.rift' && break; done");
  home.resume();
  std::string text = text_of(home);
  ASSERT_NE(text.find("stopped"), std::string::npos) << text;
  home.press({key_home});  // the latest stands first
  Navigation navigation = type(home, "u");
  ASSERT_EQ(navigation.to, Navigation::To::forward) << text_of(home);
  text.clear();
  for (int k = 0; k < 3000 && text.find("finished") == std::string::npos; ++k) {
    navigation.next->look();
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    text = text_of(*navigation.next);
  }
  EXPECT_NE(text.find("second  finished"), std::string::npos) << text;
}

TEST(FormScreen, AMistakeIsShownAtItsFieldWhileItIsTyped) {
  Shop shop;
  FormScreen form(shop.context, shop.preset());
  EXPECT_NE(text_of(form).find("ready to run"), std::string::npos);
  type(form, "/poisson\n");
  form.press({key_enter});
  for (int k = 0; k < 8; ++k) form.press({key_backspace});
  type(form, "0.7");
  const std::string text = text_of(form);
  EXPECT_NE(text.find("1 mistake"), std::string::npos) << text;
  EXPECT_NE(text.find("must lie in"), std::string::npos) << text;
  form.press({key_enter});
  type(form, "r");
  EXPECT_NE(text_of(form).find("correct them before running it"), std::string::npos);
  type(form, "d");
  EXPECT_NE(text_of(form).find("ready to run"), std::string::npos);
  expect_drawn_at_any_size(form);
}

TEST(FormScreen, EscapeLeavesTheValueAsItWas) {
  Shop shop;
  FormScreen form(shop.context, shop.preset());
  type(form, "/crack.velocity\n\n");
  type(form, "9");
  form.press({key_escape});
  EXPECT_NE(text_of(form).find("0 changed"), std::string::npos) << text_of(form);
}

TEST(FormScreen, AsksBeforeChangesAreDropped) {
  Shop shop;
  FormScreen form(shop.context, shop.preset());
  EXPECT_EQ(form.press({key_escape}).to, Navigation::To::back) << "nothing was changed";
  type(form, "/damage_zone\n\n");
  form.press({key_backspace});
  type(form, "6\n");
  for (const int key : {int{'q'}, int{key_escape}}) {
    EXPECT_EQ(form.press({key}).to, Navigation::To::stay);
    EXPECT_NE(text_of(form, 60, 16).find("1 changed, not saved: leave? yes, no or save"), std::string::npos)
        << text_of(form, 60, 16);
    EXPECT_TRUE(form.typing()) << "no letter is a key of another screen";
    EXPECT_EQ(type(form, "0.2 c_r").to, Navigation::To::stay);
    EXPECT_EQ(form.press({key_escape}).to, Navigation::To::stay);
    EXPECT_NE(text_of(form).find("nothing was dropped"), std::string::npos);
    EXPECT_NE(text_of(form).find("1 changed"), std::string::npos);
  }
  EXPECT_EQ(type(form, "qno\n").to, Navigation::To::stay);
  EXPECT_EQ(type(form, "qyes\n").to, Navigation::To::back);
  type(form, "qsave\n");
  for (int k = 0; k < 40; ++k) form.press({key_backspace});
  EXPECT_EQ(type(form, "mine\n").to, Navigation::To::back) << "saved, and left";
  EXPECT_TRUE(fs::exists(shop.context.own_presets / "mine.toml"));
  EXPECT_EQ(type(form, "q").to, Navigation::To::back) << "it is saved";
}

TEST(FormScreen, ADigitBeginsANewValue) {
  Shop shop;
  FormScreen form(shop.context, shop.preset());
  type(form, "/crack.velocity\n");
  EXPECT_EQ(type(form, "0.2 c_r\n").to, Navigation::To::stay) << "no letter of it runs anything";
  EXPECT_NE(text_of(form).find("* velocity              0.2 c_r"), std::string::npos) << text_of(form);
}

/// The tiny plate with two axes.
fs::path tiny_study(const Shop& shop) {
  const fs::path preset = shop.context.presets / "study_tiny.toml";
  std::string text = read_text(shop.preset());
  text.replace(text.find("velocity = \"0.5 c_r\"\n"), 21, "");
  write_text(preset, text +
                         "[study]\ntechnique = [\"simple\", \"progressive\"]\ncrack_velocity = "
                         "[\"0.3 c_r\", \"0.5 c_r\"]\n");
  return preset;
}

TEST(FormScreen, ShowsAndEditsTheAxesOfAStudy) {
  Shop shop;
  FormScreen form(shop.context, tiny_study(shop));
  for (const char* part : {"a study of 4 scenarios", "technique             simple, progressive",
                           "crack_velocity        0.3 c_r, 0.5 c_r", "add an axis"})
    EXPECT_NE(text_of(form).find(part), std::string::npos) << part << " in\n" << text_of(form);
  type(form, "/crack.velocity\n");
  EXPECT_NE(text_of(form).find("velocity              varied by the study"), std::string::npos)
      << text_of(form);
  type(form, "\n\n, 0.7 c_r");  // enter leads to the axis, and again to its values
  EXPECT_NE(text_of(form).find("a study of 6 scenarios, 1 changed"), std::string::npos) << text_of(form);
  form.press({key_backspace});
  EXPECT_NE(text_of(form).find("mistake"), std::string::npos) << text_of(form);
  type(form, "r\n");
  type(form, "a");
  EXPECT_NE(text_of(form).find("damping_region"), std::string::npos) << text_of(form);
  form.press({key_down});
  type(form, "\n");  // relaxation is the first that is not varied, damage_zone_ratio the second
  for (int k = 0; k < 40; ++k) form.press({key_backspace});
  type(form, "1, 2, 4\n");
  const std::string text = text_of(form);
  for (const char* part :
       {"a study of 12 scenarios", "6 of 18 combinations", "damage_zone_ratio     1, 2, 4"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
  expect_drawn_at_any_size(form);
  type(form, "s");
  for (int k = 0; k < 40; ++k) form.press({key_backspace});
  type(form, "mine\n");
  const scene::Preset saved = scene::read_preset(shop.context.own_presets / "mine.toml");
  EXPECT_TRUE(saved.issues.empty());
  EXPECT_EQ(saved.study.size(), 12U);
  ASSERT_EQ(saved.grid.size(), 3U);
  EXPECT_EQ(saved.grid[2].values, (std::vector<std::string>{"1", "2", "4"}));
  type(form, "d");  // as in the file, where there is no such axis
  EXPECT_NE(text_of(form).find("a study of 6 scenarios"), std::string::npos) << text_of(form);
}

TEST(FormScreen, MakesAStudyOfAScene) {
  Shop shop;
  FormScreen form(shop.context, shop.preset());
  type(form, "a");
  const std::string choice = text_of(form, 60, 16);
  EXPECT_NE(choice.find("technique"), std::string::npos) << choice;
  form.press({key_escape});
  EXPECT_NE(text_of(form).find("one scenario, 0 changed"), std::string::npos) << text_of(form);
  type(form, "a\n, simple\n");  // beside the preset's own technique
  EXPECT_NE(text_of(form).find("a study of 2 scenarios"), std::string::npos) << text_of(form);
  std::string text;
  for (int k = 0; k < 300 && text.find("at 100 M beams/s") == std::string::npos; ++k) {
    form.look();
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    text = text_of(form);
  }
  EXPECT_NE(text.find("at 100 M beams/s"), std::string::npos) << text;
  const Navigation navigation = type(form, "r");
  ASSERT_EQ(navigation.to, Navigation::To::forward) << text_of(form);
  EXPECT_EQ(navigation.next->where(), Where::study);
  type(form, "x");
  EXPECT_NE(text_of(form).find("one scenario"), std::string::npos) << text_of(form);
}

TEST(FormScreen, WhatFollowsIsExactAfterAMoment) {
  Shop shop;
  FormScreen form(shop.context, shop.preset());
  EXPECT_NE(text_of(form).find("starting"), std::string::npos);
  std::string text;
  for (int k = 0; k < 300 && text.find("of the critical") == std::string::npos; ++k) {
    form.look();
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    text = text_of(form);
  }
  for (const char* part : {"of the critical", "left out", "steps", "cost"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
}

TEST(FormScreen, SavesAPresetOfOnesOwnThatReadsBack) {
  Shop shop;
  FormScreen form(shop.context, shop.preset());
  type(form, "/damage_zone\n\n");
  form.press({key_backspace});
  type(form, "6\ns");
  for (int k = 0; k < 40; ++k) form.press({key_backspace});
  type(form, "mine\n");
  const fs::path file = shop.context.own_presets / "mine.toml";
  ASSERT_TRUE(fs::exists(file)) << text_of(form);
  EXPECT_EQ(scene::read_preset(file).scene.crack.damage_zone_ratio, 6);
  EXPECT_TRUE(scene::read_preset(file).issues.empty());
  type(form, "s");
  for (int k = 0; k < 40; ++k) form.press({key_backspace});
  type(form, "mine\n");
  EXPECT_NE(text_of(form).find("exists already"), std::string::npos);
  type(form, "s/../x\n");
  EXPECT_NE(text_of(form).find("is not a valid preset name"), std::string::npos);
}

TEST(StudyScreen, FillsItsGridAndWritesItsReport) {
  Shop shop;
  const fs::path preset = tiny_study(shop);
  const auto screen = screen_of_preset(shop.context, preset);
  std::string shown;
  for (int k = 0; k < 600 && shown.find("done: ") == std::string::npos; ++k) {
    screen->look();
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    shown = text_of(*screen);
  }
  for (const char* part :
       {"4 of 4 scenarios", "0.3 c_r", "a simple", "b progressive", "run time [s]",
        "|difference to Broberg|  efficient", "G_ID/G_I0  Broberg strip", "report.html", "a: simple"})
    EXPECT_NE(shown.find(part), std::string::npos) << part << " in\n" << shown;
  Canvas canvas(120, 40);
  screen->draw(canvas, Glyphs::unicode);
  const StudyLayout layout = study_layout(120, 40);
  for (const Area& plot : {layout.velocities, layout.errors})
    for (const char32_t letter : {U'a', U'b'}) {
      int marks = 0;  // the only bold letters of a plot that stand alone
      for (int y = plot.y + 1; y < plot.y + plot.height - 1; ++y)
        for (int x = plot.x + 7; x < plot.x + plot.width; ++x) {
          const Cell& cell = canvas.at(x, y);
          if (cell.glyph != letter) continue;
          EXPECT_EQ(cell.style.ink,
                    canvas.at(layout.grid.x, layout.grid.y + (letter == U'a' ? 1 : 2)).style.ink);
          ++marks;
        }
      EXPECT_GE(marks, 1) << static_cast<char>(letter);
    }
  screen->press({key_down});
  EXPECT_NE(text_of(*screen).find("b: progressive"), std::string::npos) << text_of(*screen);
  EXPECT_TRUE(fs::exists(shop.context.studies / "study_tiny" / "report.html"));
  expect_drawn_at_any_size(*screen);
}

TEST(StudyScreen, OpensAStudyOfTheListWithoutComputingAndGoesOnWhenAsked) {
  Shop shop;
  const fs::path folder = shop.context.studies / "half";
  write_text(shop.plate.preset(),
             read_text(shop.plate.preset()) + "[study]\ntechnique = [\"simple\", \"progressive\"]\n");
  ASSERT_EQ(run_rift("study '" + shop.plate.preset().string() + "' --shard 1/2 --quiet --out '" +
                     folder.string() + "'")
                .exit_code,
            0);
  shop.context.build.version = nlohmann::json::parse(read_text(folder / "study.json")).at("version");
  HomeScreen home(shop.context);
  home.press({key_home});
  EXPECT_NE(text_of(home).find("1 of 2"), std::string::npos) << text_of(home);
  const Navigation navigation = home.press({key_enter});
  ASSERT_EQ(navigation.to, Navigation::To::forward) << text_of(home);
  ASSERT_EQ(navigation.next->where(), Where::study);
  navigation.next->look();
  std::string shown = text_of(*navigation.next, 80, 24);
  for (const char* part :
       {"half", "1 of 2 scenarios", "press u to resume it", "simple", "progressi", "u resume"})
    EXPECT_NE(shown.find(part), std::string::npos) << part << " in\n" << shown;
  EXPECT_EQ(shown.find("s stop"), std::string::npos) << shown;  // nothing is computed
  expect_drawn_at_any_size(*navigation.next);
  type(*navigation.next, "u");
  for (int k = 0; k < 600 && shown.find("done: ") == std::string::npos; ++k) {
    navigation.next->look();
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    shown = text_of(*navigation.next);
  }
  EXPECT_NE(shown.find("2 of 2 scenarios"), std::string::npos) << shown;
  const auto again = screen_of_run(shop.context, folder);
  EXPECT_NE(text_of(*again).find("half/report.html"), std::string::npos) << text_of(*again);
}

TEST(StudyTable, HasARowPerCombinationAndItsEfficientFront) {
  const scene::Preset preset = scene::read_preset_text(
      "[study]\ntechnique = [\"simple\", \"progressive\"]\ncrack_velocity = [\"0.3 c_r\", \"0.5 c_r\"]\n"
      "damage_zone_ratio = [2, 4]\n",
      "x.toml");
  const StudyTable table(preset);
  EXPECT_EQ(table.axis, "crack_velocity");
  EXPECT_EQ(table.columns, (std::vector<std::string>{"0.3 c_r", "0.5 c_r"}));
  EXPECT_EQ(table.rows, (std::vector<std::string>{"simple", "progressive r_l 2", "progressive r_l 4"}));
  StudyResults results(preset.study.size());
  const auto result = [](double seconds, double difference) {
    results::LaneSummary s;
    s.cost_s = seconds, s.error_broberg = difference;
    return s;
  };
  results[0] = result(1, -0.1), results[1] = result(2, 0.2), results[2] = result(10, 0.01);
  results[3] = result(100, 0.02), results[4] = result(1, 0.3);
  const std::vector<ErrorPoint> points = error_points(table, results);
  ASSERT_EQ(points.size(), 5U);  // one is not computed
  const auto front = efficient_front(points);
  ASSERT_EQ(front.size(), 2U);
  EXPECT_EQ(front[0], (std::array<double, 2>{0, std::log10(0.1)}));
  EXPECT_EQ(front[1], (std::array<double, 2>{1, std::log10(0.01)}));
}

TEST(Lesson, TheAnswerFollowsFromTheNumbersOfTheRun) {
  const auto lane = [](double fracture, double ratio, double v) {
    results::LaneSummary s;
    s.ratio_fracture = fracture, s.ratio = ratio;
    s.broberg = 0.9, s.crack_velocity_over_cr = v;
    s.energy_kinetic_translation_j = 1, s.energy_kinetic_rotation_j = 0;
    return s;
  };
  const Lesson& release = lesson_of("node-release");
  EXPECT_EQ(release.answer({lane(0.3, 0.3, 0.1), lane(0.9, 0.9, 0.1)}).right, 1);
  EXPECT_EQ(release.answer({lane(0.9, 0.9, 0.1), lane(0.3, 0.3, 0.1)}).right, 0);
  EXPECT_EQ(release.answer({lane(0.9, 0.9, 0.1), lane(0.91, 0.91, 0.1)}).right, 2);
  const Lesson& damping = lesson_of("damping");
  EXPECT_EQ(damping.answer({lane(0.3, 0.3, 0.2), lane(0.3, 0.35, 0.2), lane(0.3, 0.4, 0.2)}).right, 0);
  EXPECT_EQ(damping.answer({lane(0.3, 0.3, 0.2), lane(0.3, 0.3, 0.2), lane(0.2, 0.2, 0.2)}).right, 1);
  const Lesson& velocity = lesson_of("velocity");
  EXPECT_EQ(velocity.answer({lane(0.9, 0.9, 0.2), lane(0.5, 0.5, 0.5)}).right, 0);
  EXPECT_EQ(velocity.answer({lane(0.5, 0.5, 0.2), lane(0.9, 0.9, 0.5)}).right, 1);
  EXPECT_THROW((void)lesson_of("node-relase"), scene::InputError);
}

TEST(LessonScreen, LeadsFromTextThroughTheRunToItsAnswerAndAHandout) {
  Shop shop;
  std::string text = read_text(shop.preset());
  write_text(shop.context.presets / "teach_node_release.toml",
             text + "[[lanes]]\ntechnique = \"simple\"\n[[lanes]]\ntechnique = \"progressive\"\n");
  const auto screen = lesson_screen(shop.context, "node-release");
  EXPECT_NE(text_of(*screen).find("1 of 6"), std::string::npos);
  EXPECT_EQ(text_of(*screen).find("handout"), std::string::npos);  // there is no run yet to make it of
  expect_drawn_at_any_size(*screen);
  screen->press({key_enter});
  screen->press({key_enter});
  EXPECT_NE(text_of(*screen).find("e elastic"), std::string::npos);  // what the letters of the curves mean
  type(*screen, "q");                                                // the run has not finished: it asks
  EXPECT_NE(text_of(*screen).find("leave? yes or no"), std::string::npos) << text_of(*screen);
  type(*screen, "no");
  EXPECT_EQ(screen->press({key_enter}).to, Navigation::To::stay);
  screen->press({key_enter});
  std::string shown;
  for (int k = 0; k < 400 && shown.find("finished") == std::string::npos; ++k) {
    screen->look();
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    shown = text_of(*screen);
  }
  EXPECT_NE(shown.find("1 simple release"), std::string::npos) << shown;
  expect_drawn_at_any_size(*screen);
  for (const auto& [width, height] : {std::pair{80, 24}, {60, 16}}) {
    Canvas canvas(width, height);
    screen->draw(canvas, Glyphs::unicode);
    int coloured = 0, dots = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        coloured += canvas.at(x, y).style.ink == Ink::shades ? 1 : 0;
        dots += canvas.at(x, y).glyph == U'●' ? 1 : 0;
      }
    EXPECT_GT(coloured, 2 * width) << "both plates at " << width << "x" << height;
    EXPECT_GE(dots, 2) << "their tips at " << width << "x" << height << "\n"
                       << text_of(*screen, width, height);
  }
  screen->press({key_enter});
  EXPECT_NE(text_of(*screen).find("Which of the two"), std::string::npos);
  screen->look();
  type(*screen, "3");
  shown = text_of(*screen);
  EXPECT_NE(shown.find("The answer of this run:"), std::string::npos) << shown;
  type(*screen, "h");
  const fs::path handout = shop.context.runs / "lesson_node-release" / "handout.html";
  ASSERT_TRUE(fs::exists(handout)) << text_of(*screen);
  const std::string html = read_text(handout);
  for (const char* part : {"Why nodes must not be released at once", "The answer of this run", "<svg",
                           "<table", "Broberg, ", "strip"})
    EXPECT_NE(html.find(part), std::string::npos) << part;
  EXPECT_EQ(screen->press({'q'}).to, Navigation::To::back);  // it has finished
}

TEST(LessonScreen, IsWatchedAsAPictureWhereTheTerminalHasPixels) {
  Shop shop;
  write_text(shop.context.presets / "teach_node_release.toml",
             read_text(shop.preset()) +
                 "[[lanes]]\ntechnique = \"simple\"\n[[lanes]]\ntechnique = \"progressive\"\n");
  Told told;
  shop.context.plate_picture = told_picture(told);
  constexpr PictureRoom letters{.pictures = true, .symbols = true};
  for (const bool pixels : {true, false}) {
    const auto screen = lesson_screen(shop.context, "node-release");
    EXPECT_FALSE(screen->wants_picture());
    for (int k = 0; k < 3; ++k) screen->press({key_enter});
    const PictureRoom& room = pixels ? pixels_room : letters;
    const auto is_drawn = [&](const Canvas& canvas) {
      return all_of(canvas).find("1 simple release") != std::string::npos &&
             (!pixels || screen->picture().has_value());
    };
    ASSERT_TRUE(rounds_until(*screen, room, is_drawn));
    EXPECT_EQ(screen->picture().has_value(), pixels);
    Canvas canvas(120, 40);
    round_of(*screen, room, canvas);
    if (pixels) {
      EXPECT_TRUE(told.view.velocity);
      EXPECT_TRUE(is_blank(canvas, screen->picture()->area)) << all_of(canvas);
      EXPECT_GT(screen->picture()->area.y, told.place.y) << "below the lesson's text";
    }
    type(*screen, "p");
    round_of(*screen, room, canvas);
    EXPECT_EQ(screen->wants_picture(), !pixels);
    screen->press({key_enter});
    EXPECT_FALSE(screen->picture()) << "the question has none";
  }
}

TEST(LessonScreen, ARunWithoutAHandoutGivesWayToTheNext) {
  Shop shop;
  write_text(shop.context.presets / "teach_node_release.toml",
             read_text(shop.preset()) +
                 "[[lanes]]\ntechnique = \"simple\"\n[[lanes]]\ntechnique = \"progressive\"\n");
  const fs::path first = shop.context.runs / "lesson_node-release", second = first.string() + "-2";
  const auto lesson_is_run_in = [&](const fs::path& folder) {
    const auto screen = lesson_screen(shop.context, "node-release");
    return text_of(*screen).find(folder.filename().string() + "\n") != std::string::npos;
  };
  EXPECT_TRUE(lesson_is_run_in(first));
  EXPECT_TRUE(lesson_is_run_in(first));
  fs::create_directories(first);
  write_text(first / "handout.html", "kept");
  EXPECT_TRUE(lesson_is_run_in(second));
  EXPECT_EQ(read_text(first / "handout.html"), "kept");
}

TEST(FormScreen, SaysHowManyLinesDoNotFitAndShowsThemAll) {
  Shop shop;
  const auto screen = form_of_preset(shop.context, shop.preset());
  const std::string small = text_of(*screen, 80, 24);
  const auto at = small.find(" more lines (i)");
  ASSERT_NE(at, std::string::npos) << small;
  EXPECT_EQ(small.find("numerical damping"), std::string::npos) << small;
  type(*screen, "i");
  EXPECT_NE(text_of(*screen, 80, 24).find("numerical damping"), std::string::npos)
      << text_of(*screen, 80, 24);
  const std::string before = text_of(*screen, 60, 16);
  screen->press({key_down});
  EXPECT_NE(text_of(*screen, 60, 16), before);  // it scrolls
  screen->press({key_escape});
  EXPECT_NE(text_of(*screen, 80, 24).find(" more lines (i)"), std::string::npos);
}

TEST(LessonScreen, EveryLessonsPresetIsShipped) {
  for (const Lesson& lesson : not_empty(lessons())) {
    const scene::Preset preset =
        scene::read_preset(fs::path(RIFT_SOURCE_DIR) / "presets" / (std::string(lesson.preset) + ".toml"));
    EXPECT_TRUE(preset.issues.empty()) << lesson.name;
    EXPECT_GE(preset.lanes.size(), 2U) << lesson.name;
  }
}

TEST(WatchScreen, ShowsTheRunThatHasTakenThePlaceOfTheFollowedOne) {
  Shop shop;
  ASSERT_EQ(shop.run("one").exit_code, 0);
  WatchScreen screen(shop.context, shop.context.runs / "one");
  (void)screen.look();
  const auto steps_shown = [&] {
    const std::string text = text_of(screen);
    return text.substr(text.find("step "), text.find('\n') - text.find("step "));
  };
  const std::string before = steps_shown();
  ASSERT_EQ(shop.run("one", "--force --set crack.technique=simple").exit_code, 0);
  for (int k = 0; k < 2; ++k) (void)screen.look();
  const std::string text = text_of(screen);
  EXPECT_TRUE(contains(text, "another run has replaced the one that was shown"));
  EXPECT_NE(steps_shown(), before);  // simple release takes another number of steps
  fs::remove_all(shop.context.runs / "one");
  (void)screen.look();
  EXPECT_TRUE(contains(text_of(screen), "another process has replaced or removed this run"));
}

}  // namespace
}  // namespace rift::studio
