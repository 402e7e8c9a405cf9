#include "engine/base/ownership.hpp"
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

TEST(HomeScreen, SearchShowsOnlyWhatHoldsTheLetters) {
  Shop shop;
  HomeScreen home(shop.context);
  type(home, "/DAMP");
  EXPECT_TRUE(home.typing());
  home.press({key_enter});
  const std::string text = text_of(home);
  EXPECT_EQ(text.find("plate_tiny"), std::string::npos);
  EXPECT_NE(text.find("Can damping repair"), std::string::npos);
  type(home, "/zzzz\n");
  EXPECT_NE(text_of(home).find("no entry contains these letters"), std::string::npos);
  EXPECT_EQ(home.press({key_enter}).to, Navigation::To::stay);
}

TEST(HomeScreen, DeletesARunOnlyAfterYes) {
  Shop shop;
  ASSERT_EQ(shop.run("first").exit_code, 0);
  HomeScreen home(shop.context);
  home.press({key_end});
  type(home, "dno\n");
  EXPECT_TRUE(fs::exists(shop.context.runs / "first"));
  {
    const base::FolderLock lock(shop.context.runs / "first");
    type(home, "dyes\n");
    EXPECT_TRUE(fs::exists(shop.context.runs / "first")) << "it is being written";
  }
  type(home, "dyes\n");
  EXPECT_FALSE(fs::exists(shop.context.runs / "first"));
  home.press({key_home});
  type(home, "d");
  EXPECT_NE(text_of(home).find("presets cannot be deleted here"), std::string::npos);
}

TEST(HomeScreen, ComparesTheMarkedRuns) {
  Shop shop;
  ASSERT_EQ(shop.run("first").exit_code, 0);
  ASSERT_EQ(shop.run("second", "--set crack.technique=simple").exit_code, 0);
  HomeScreen home(shop.context);
  home.press({key_end});
  type(home, " c");
  EXPECT_NE(text_of(home).find("mark two or more runs"), std::string::npos);
  home.press({key_up});
  const Navigation navigation = type(home, " c");
  ASSERT_EQ(navigation.to, Navigation::To::forward);
  const std::string text = text_of(*navigation.next);
  for (const char* part :
       {"2 scenarios side by side", "first: progressive", "second: simple", "G_ID / G_I0", "balance error"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
  expect_drawn_at_any_size(*navigation.next);
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
  home.press({key_end});
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
  home.press({key_end});
  home.press({key_up});  // the latest stands first
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
  const fs::path preset = shop.context.presets / "study_tiny.toml";
  std::string text = read_text(shop.preset());
  text.replace(text.find("velocity = \"0.5 c_r\"\n"), 21, "");
  write_text(preset, text +
                         "[study]\ntechnique = [\"simple\", \"progressive\"]\ncrack_velocity = [\"0.3 c_r\", "
                         "\"0.5 c_r\"]\n");
  const auto screen = screen_of_preset(shop.context, preset, {});
  std::string shown;
  for (int k = 0; k < 600 && shown.find("done: ") == std::string::npos; ++k) {
    screen->look();
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    shown = text_of(*screen);
  }
  for (const char* part :
       {"4 of 4 scenarios", "0.3 c_r", "simple", "progressive", "log10 (run time [s])", "report.html"})
    EXPECT_NE(shown.find(part), std::string::npos) << part << " in\n" << shown;
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
  home.press({key_end});
  EXPECT_NE(text_of(home).find("1 of 2"), std::string::npos) << text_of(home);
  const Navigation navigation = home.press({key_enter});
  ASSERT_EQ(navigation.to, Navigation::To::forward) << text_of(home);
  ASSERT_EQ(navigation.next->where(), Where::study);
  navigation.next->look();
  std::string shown = text_of(*navigation.next, 80, 24);
  for (const char* part : {"half", "1 of 2 scenarios", "press u to resume it", "simple", "progressi"})
    EXPECT_NE(shown.find(part), std::string::npos) << part << " in\n" << shown;
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
  EXPECT_NE(text_of(*screen).find("1 of 5"), std::string::npos);
  expect_drawn_at_any_size(*screen);
  screen->press({key_enter});
  screen->press({key_enter});
  std::string shown;
  for (int k = 0; k < 400 && shown.find("finished") == std::string::npos; ++k) {
    screen->look();
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    shown = text_of(*screen);
  }
  EXPECT_NE(shown.find("1 simple release"), std::string::npos) << shown;
  expect_drawn_at_any_size(*screen);
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
  for (const char* part :
       {"Why nodes must not be released at once", "The answer of this run", "<svg", "<table"})
    EXPECT_NE(html.find(part), std::string::npos) << part;
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
