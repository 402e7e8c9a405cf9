#include "engine/scene/preset.hpp"
#include "studio/reports/reproduction.hpp"
#include "tests/studio/run_rift.hpp"

#include <gtest/gtest.h>

namespace rift::studio {
namespace {

TEST(ReproductionReport, SaysWhatAllScenariosShareAndLeaveOut) {
  Reproduction report;
  for (const char* velocity : {"0.3 c_r", "0.5 c_r"})
    report.scenes.push_back(
        scene::read_preset_text("", "x.toml", {std::string("crack.velocity=") + velocity}).scene);
  const std::string page = reproduction_html(report), markdown = reproduction_markdown(report);
  for (const char* part : {"Fixed parameters", "specimen.elements", "Left out", "numerical damping"}) {
    EXPECT_TRUE(contains(page, part)) << part;
    EXPECT_TRUE(contains(markdown, part)) << part;
  }
  EXPECT_TRUE(contains(markdown, "| `specimen.elements` | 20000 |"));
  EXPECT_FALSE(contains(markdown, "crack.velocity"));  // it is varied
}

}  // namespace
}  // namespace rift::studio
