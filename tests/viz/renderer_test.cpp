#include "viz/renderer.hpp"

#include "engine/base/world_error.hpp"
#include "tests/viz/scripts.hpp"

namespace rift::viz {
namespace {

Job small_job() {
  Job job;
  job.panes = {{"nowhere", 0, ""}};
  job.width = 4;
  job.height = 2;
  return job;
}

/// Answers each time with a frame of the letter.
std::string drawing(char letter) {
  return std::string("read job; while read t; do printf '") + std::string(24, letter) + "'; done";
}

std::string trouble_of(Renderer& renderer) {
  try {
    renderer.ask(0);
    (void)renderer.next();
  } catch (const base::WorldError& error) {
    return error.what();
  }
  return "no trouble";
}

TEST(Renderer, GivesAFrameForEachTime) {
  const TemporaryFolder folder;
  write_script(folder / "rift-frames-osmesa", drawing('a'));
  Renderer renderer(small_job(), Gl::any, false, folder.path());
  for (const double t : {0.0, 1e-6}) renderer.ask(t);
  for (int k = 0; k < 2; ++k) EXPECT_EQ(renderer.next().rgb, std::vector<std::uint8_t>(24, 'a'));
  EXPECT_EQ(renderer.waiting(), 0U);
}

TEST(Renderer, TurnsToEglWhereOsmesaIsNotToBeHadAndAsksAgain) {
  const TemporaryFolder folder;
  write_script(folder / "rift-frames-osmesa", "echo 'no context' >&2; exit 3");
  write_script(folder / "rift-frames-egl", drawing('e'));
  Renderer renderer(small_job(), Gl::any, false, folder.path());
  for (const double t : {0.0, 1e-6}) renderer.ask(t);
  for (int k = 0; k < 2; ++k) EXPECT_EQ(renderer.next().rgb, std::vector<std::uint8_t>(24, 'e'));
  Renderer only(small_job(), Gl::osmesa, false, folder.path());
  EXPECT_EQ(trouble_of(only), "cannot draw with " + (folder / "rift-frames-osmesa").string() +
                                  ": it ended with code 3: no context");
}

TEST(Renderer, DrawsByEglWhereThereIsNoProgramForOsmesa) {
  const TemporaryFolder folder;
  write_script(folder / "rift-frames-egl", drawing('e'));
  Renderer renderer(small_job(), Gl::any, false, folder.path());
  renderer.ask(0.0);
  EXPECT_EQ(renderer.next().rgb.front(), 'e');
}

TEST(Renderer, TurnsToEglWhereOsmesasLibraryIsGone) {
  const TemporaryFolder folder;
  write_script(folder / "rift-frames-osmesa", "exit 127");
  write_script(folder / "rift-frames-egl", drawing('e'));
  Renderer renderer(small_job(), Gl::any, false, folder.path());
  renderer.ask(0);
  EXPECT_EQ(renderer.next().rgb, std::vector<std::uint8_t>(24, 'e'));
}

TEST(Renderer, ThatCrashesIsAnErrorWithItsLastWords) {
  const TemporaryFolder folder;
  write_script(folder / "rift-frames-osmesa", "read job; echo 'bad vertex' >&2; kill -SEGV $$");
  Renderer renderer(small_job(), Gl::any, false, folder.path());
  EXPECT_EQ(trouble_of(renderer), "cannot draw with " + (folder / "rift-frames-osmesa").string() +
                                      ": it was killed by signal 11 (Segmentation fault): bad vertex");
}

TEST(Renderer, ThatStopsInTheMiddleOfAFrameGivesNone) {
  const TemporaryFolder folder;
  write_script(folder / "rift-frames-osmesa", "read job; read t; printf 'half'; exit 1");
  Renderer renderer(small_job(), Gl::any, false, folder.path());
  EXPECT_NE(trouble_of(renderer), "no trouble");
}

TEST(Renderer, TellsWhatItsRunHas) {
  const TemporaryFolder folder;
  Job job = small_job();
  job.panes = {{folder / "nothing", 0, ""}};
  Renderer renderer(job, Gl::any, false, drawn_plate::programs());
  EXPECT_NE(trouble_of(renderer).find("journal.rift"), std::string::npos);
}

}  // namespace
}  // namespace rift::viz
