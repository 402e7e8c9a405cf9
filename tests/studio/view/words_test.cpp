#include "studio/view/words.hpp"

#include "tests/expectations.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace rift::studio {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

TEST(ViewWords, TheNumbersOfAMoment) {
  viz::Answer answer;
  answer.range = {0, 0.4e-3};
  answer.pane[0].since_start_s = 12.34e-6;
  answer.pane[0].tip_m = 0.0345;
  answer.pane[0].velocity_m_s = 1000;
  EXPECT_EQ(numbers_of(answer, {}, 11, 120, true, 2000),
            "frame 12 of 120   t = 12.3 µs   tip 34.5 mm   v 0.50 c_R   uy 0 to 0.4 mm");
}

TEST(ViewWords, AnElementWithWhatIsStoredOfIt) {
  viz::Picked picked;
  picked.kind = viz::Picked::Kind::element;
  picked.index = 7;
  picked.position_m = {0.01, 0.02, 0};
  picked.displacement_m = {0, 1e-4, 0};
  picked.velocity_m_s = {none, none, none};
  picked.elastic_j = none;
  picked.damage = 0.25;
  EXPECT_EQ(text_of(picked), "element 7   at 10.000 20.000 0.000 mm   ux 0 uy 0.1 uz 0 mm   damage 0.25");
  EXPECT_EQ(text_of({}), "nothing is drawn there");
  picked.gauge = {.gauge = 3, .x_m = 0.013, .y_m = 0.024, .uy_m = 2e-4, .vy_m_s = 1.5, .strain_yy = 0.01};
  EXPECT_TRUE(text_of(picked).ends_with("   gauge 3, 5 mm away: uy 0.2 mm vy 1.5 m/s strain yy 0.01"))
      << text_of(picked);
}

TEST(ViewWords, ADistanceUnloadedAndNow) {
  viz::Picked a, b;
  b.position_m = {0.003, 0.004, 0};
  b.displacement_m = {0.003, 0.004, 0};
  EXPECT_EQ(distance_between(a, b), "distance 5 mm unloaded, 10 mm now");
  b.displacement_m = {none, none, none};
  EXPECT_EQ(distance_between(a, b), "distance 5 mm unloaded");
}

TEST(ViewWords, TheCommandHasTheWholeLook) {
  viz::Job job;
  job.panes = {{"runs/a b", 0, ""}, {"runs/a b", 2, ""}};
  job.look.field = "vy";
  job.look.colours = "of the field";  // as a preset's [film] has it
  job.look.range = {-10, 10};
  job.look.title = "it's a plate";
  job.look.camera = viz::Camera::free;
  job.look.view = {0.1, 0.02, 0.05, 0, 0.5};
  job.look.chart = viz::Chart::whole;
  job.width = 960, job.height = 540;
  const std::string line = shell_line(render_arguments(job, {0, 2}));
  EXPECT_TRUE(
      line.starts_with("render 'runs/a b' --lane 0 --lane 2 --field vy --colours coolwarm --range -10,10"))
      << line;
  EXPECT_TRUE(contains(line, "--view 100,20,50,0,28.64789"));
  EXPECT_TRUE(contains(line, " --chart whole "));
  EXPECT_TRUE(contains(line, "--title 'it'\\''s a plate' --size 960x540"));
}

TEST(ViewWords, TheCommandNamesLanesWhereTheyWereAskedForAndARunThatIsCalledRender) {
  viz::Job job;
  job.panes = {{"render", 0, ""}, {"render", 1, ""}};
  EXPECT_TRUE(shell_line(render_arguments(job, {})).starts_with("render render --field "));
}

}  // namespace
}  // namespace rift::studio
