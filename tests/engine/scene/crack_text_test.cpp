#include "engine/scene/rows_text.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rift::scene {
namespace {

using Pieces = std::vector<VelocityPiece>;

TEST(ReadVelocity, TakesFractionsOfTheRayleighSpeedAndSpeeds) {
  EXPECT_EQ(read_velocity("0.5 c_r").value, (Pieces{{{0.5, true}, {}}}));
  EXPECT_EQ(read_velocity(" 2c_r").value, (Pieces{{{2.0, true}, {}}}));
  EXPECT_EQ(read_velocity("1100 m/s").value, (Pieces{{{1100, false}, {}}}));
}

TEST(ReadVelocity, TakesPieces) {
  EXPECT_EQ(read_velocity("0.2 c_r until 40 mm, 900 m/s until 0.06 m,0.6 c_r").value,
            (Pieces{{{0.2, true}, 0.04}, {{900, false}, 0.06}, {{0.6, true}, {}}}));
}

TEST(ReadVelocity, SaysWhatIsWrong) {
  const auto problem = [](const char* text) { return read_velocity(text).problem; };
  const char* unit = "needs a speed with its unit, such as \"0.5 c_r\" or \"1100 m/s\"";
  for (const char* text : {"0.5", "", "fast", "0.5 c", "0.5 x c_r", "c_r", "0.5 m"})
    EXPECT_EQ(problem(text), unit) << text;
  for (const char* text : {"0 c_r", "-1 c_r", "2.0000001 c_r", "5 c_r", "0 m/s", "-3 m/s"}) {
    EXPECT_EQ(problem(text), "must lie in (0, 2] c_r") << text;
  }
  for (const char* text : {"nan c_r", "inf c_r", "nan m/s"})
    EXPECT_EQ(problem(text), "must be a finite number") << text;
  EXPECT_EQ(problem("0.2 c_r until 40 mm, 5 c_r"), "piece 2: must lie in (0, 2] c_r");
  EXPECT_EQ(problem("0.2 c_r until late, 1 c_r"),
            "piece 1: after 'until': expected a length such as \"2 mm\"");
  EXPECT_EQ(problem("0.2 c_r until 40 mm,"), std::string("piece 2: ") + unit);
}

TEST(ReadVelocity, WantsRisingUntilsOnAllButTheLastPiece) {
  EXPECT_EQ(read_velocity("0.2 c_r until 40 mm").problem,
            "the last piece extends to the end: leave its 'until' out");
  EXPECT_EQ(read_velocity("0.2 c_r, 0.3 c_r").problem,
            "every piece but the last needs an 'until', such as \"0.2 c_r until 40 mm\"");
  EXPECT_EQ(read_velocity("0.2 c_r until 40 mm, 0.3 c_r until 40 mm, 1 c_r").problem,
            "each 'until' must lie beyond the one before");
}

TEST(VelocityText, ReadsBackToTheSamePieces) {
  for (const char* text : {"0.1 c_r", "1100 m/s", "0.30000000000000004 c_r",
                           "0.2 c_r until 40 mm, 900 m/s until 60.000000000000014 mm, 0.6 c_r"}) {
    const auto pieces = read_velocity(text).value;
    ASSERT_TRUE(pieces) << text;
    EXPECT_EQ(read_velocity(velocity_text(*pieces)).value, pieces) << text;
  }
  EXPECT_EQ(velocity_text(*read_velocity("0.20 c_r until 0.04 m, 0.6c_r").value),
            "0.2 c_r until 40 mm, 0.6 c_r");
}

TEST(ReadPath, TakesAFractionOfTheHeightOrALength) {
  EXPECT_EQ(read_path("0.25 H").value, (CrackLine{0.25, true}));
  EXPECT_EQ(read_path("20 mm").value, (CrackLine{0.02, false}));
}

TEST(ReadPath, SaysWhatIsWrong) {
  for (const char* text : {"0 H", "1 H", "-0.5 H", "nan H", "0 mm", "-3 mm"}) {
    EXPECT_EQ(read_path(text).problem, "must lie in (0, 1) H") << text;
  }
  EXPECT_EQ(read_path("nan mm").problem, "must be a finite number");
  EXPECT_EQ(read_path("middle").problem,
            "expected the height of a straight path, such as \"0.5 H\" or \"20 mm\"");
}

TEST(PathText, ReadsBack) {
  EXPECT_EQ(path_text({0.25, true}), "0.25 H");
  EXPECT_EQ(path_text({0.02, false}), "20 mm");
}

TEST(Relaxation, NamesArePaperExponents) {
  EXPECT_EQ(read_relaxation("linear").value, 1.0);
  EXPECT_EQ(read_relaxation("square-root").value, 0.5);
  EXPECT_EQ(read_relaxation("quadratic").value, 2.0);
  EXPECT_EQ(relaxation_name(0.5), "square-root");
  EXPECT_EQ(relaxation_name(3), "power(3)");
  EXPECT_EQ(read_relaxation("cubic").problem,
            "must be \"linear\", \"square-root\", \"quadratic\" or a number in (0, 16]");
}

}  // namespace
}  // namespace rift::scene
