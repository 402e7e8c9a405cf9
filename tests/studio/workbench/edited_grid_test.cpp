#include "studio/workbench/edited_grid.hpp"

#include "engine/scene/parameters.hpp"
#include "engine/scene/scenarios.hpp"

#include <gtest/gtest.h>

namespace rift::studio {
namespace {

TEST(EditedGrid, PartsValuesAtCommasOutsideBracketsAndQuotes) {
  EditedGrid grid({{"crack_velocity", {"\"0.3 c_r\"", "\"0.2 c_r until 40 mm, 0.6 c_r\""}}});
  EXPECT_EQ(grid.values_of("crack_velocity"), "0.3 c_r, \"0.2 c_r until 40 mm, 0.6 c_r\"");
  ASSERT_EQ(grid.grid().size(), 1U);
  EXPECT_EQ(grid.grid()[0].name, "crack_velocity");
  EXPECT_EQ(grid.grid()[0].values, (std::vector<std::string>{"0.3 c_r", "\"0.2 c_r until 40 mm, 0.6 c_r\""}));
  grid.add("path", scene::default_scene());
  grid.set("path", "0.5 H, [[\"0 mm\", \"5 mm\"], [\"9 mm\", \"6 mm\"]]");
  EXPECT_EQ(grid.grid()[1].values,
            (std::vector<std::string>{"0.5 H", "[[\"0 mm\", \"5 mm\"], [\"9 mm\", \"6 mm\"]]"}));
  grid.set("path", " , ");
  EXPECT_TRUE(grid.grid()[1].values.empty());
}

TEST(EditedGrid, KnowsWhatDiffersFromTheFile) {
  EditedGrid grid({{"seed", {"1", "2"}}});
  EXPECT_EQ(grid.changed(), 0);
  grid.set("seed", "1, 2, 3");
  EXPECT_TRUE(grid.is_changed("seed"));
  grid.add("relaxation", scene::default_scene());
  EXPECT_EQ(grid.values_of("relaxation"), "linear");
  EXPECT_EQ(grid.changed(), 2);
  grid.take_back("seed");
  grid.take_back("relaxation");
  EXPECT_EQ(grid.changed(), 0);
  EXPECT_FALSE(grid.values_of("relaxation"));
  grid.drop("seed");
  EXPECT_EQ(grid.changed(), 1);
  EXPECT_EQ(grid.others().size(), scene::axes().size());
  grid.add("seed", scene::default_scene());  // with the file's values, not the scene's
  EXPECT_EQ(grid.values_of("seed"), "1, 2");
}

}  // namespace
}  // namespace rift::studio
