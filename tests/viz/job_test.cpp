#include "viz/job.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace rift::viz {
namespace {

TEST(Job, ComesBackFromItsText) {
  Job job;
  job.panes = {{.run = "runs/a b", .lane = 2, .title = "simple release, α = 0"}};
  job.width = 640;
  job.height = 360;
  job.look = {.field = "v",
              .range = {0, 12.5},
              .colours = "inferno",
              .camera = Camera::tip,
              .beams = Beams::all,
              .spheres = false,
              .magnification = 3,
              .close_up_m = 0.01,
              .chart = Chart::whole,
              .boundaries = true,
              .large_text = true,
              .title = "a \"title\"\nof two lines",
              .scheme = "linear relaxation, damage zone 1 R, no damping"};
  const std::string text = to_json(job);
  EXPECT_EQ(text.find('\n'), std::string::npos);
  EXPECT_EQ(to_json(job_from_json(text)), text);
  EXPECT_EQ(job_from_json(text).panes[0].title, "simple release, α = 0");
  EXPECT_EQ(job_from_json(text).look.scheme, job.look.scheme);
  EXPECT_EQ(job_from_json(text).look.camera, Camera::tip);
  EXPECT_EQ(job_from_json(text).look.range[1], 12.5);
}

TEST(Job, KeepsThePathOfARunByteByByte) {
  Job job;
  const std::filesystem::path run = "r\xe9s\x1b[2J\nb/run";
  job.panes = {{.run = run, .lane = 0, .title = "r\xe9s"}};
  EXPECT_EQ(job_from_json(to_json(job)).panes[0].run, run);
}

TEST(Job, TextThatIsNoJobIsRefused) {
  EXPECT_THROW((void)job_from_json("hello"), std::invalid_argument);
  EXPECT_THROW((void)job_from_json("{}"), std::invalid_argument);
}

}  // namespace
}  // namespace rift::viz
