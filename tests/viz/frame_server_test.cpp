#include "viz/frame_server.hpp"

#include "tests/expectations.hpp"
#include "tests/viz/scripts.hpp"

#include <poll.h>
#include <signal.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <functional>
#include <thread>

namespace rift::viz {
namespace {

using namespace drawn_plate;

Order order_for(const Job& job, int moment) { return {job, 1e-6 * moment, {}}; }

/// Looks until something is so; false where it never is.
bool looks_until(FrameServer& server, const std::function<bool()>& is_so) {
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(patience_s);
  while (std::chrono::steady_clock::now() < until) {
    server.look();
    if (is_so()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return false;
}

const Image& served(FrameServer& server, const Order& order) {
  server.want(order);
  EXPECT_TRUE(looks_until(server, [&] { return !server.busy(); })) << server.trouble();
  return server.image();
}

/// The server's only child.
pid_t child_of_this_process() {
  std::ifstream file("/proc/thread-self/children");
  pid_t child = -1;
  file >> child;
  return child;
}

TEST(FrameServer, ShowsThePictureThatIsWrittenToFiles) {
  const TemporaryFolder folder;
  Job job = job_for(write_run(folder / "run"));
  FrameServer server(Gl::any, programs());
  for (const int moment : {0, 3, 5, 2})
    EXPECT_TRUE(served(server, order_for(job, moment)).rgb == drawn(job, moment).rgb) << "moment " << moment;
  std::vector<Job> jobs(9, job);
  jobs[0].look.field = "v", jobs[0].look.range = {0, 50};
  jobs[1].look.camera = Camera::free, jobs[1].look.view = {0.012, 0.004, 0.006, 0, 0};
  jobs[2].look.camera = Camera::free, jobs[2].look.view = {0.012, 0.004, 0.006, 0.5, -0.3};
  jobs[3].look.range_of_moment = true;
  jobs[4].look.chart = Chart::none, jobs[4].look.beams = Beams::all;
  jobs[5].look.texts = false, jobs[5].look.magnification = 3;
  jobs[6].width = 800, jobs[6].height = 500;
  jobs[7].width = 320, jobs[7].height = 180, jobs[7].look.beams = Beams::crossing;
  jobs[8].width = 800, jobs[8].height = 500, jobs[8].look.camera = Camera::side;
  for (std::size_t k = 0; k < jobs.size(); ++k)
    EXPECT_TRUE(served(server, order_for(jobs[k], 4)).rgb == drawn(jobs[k], 4).rgb) << "job " << k;
  EXPECT_TRUE(served(server, order_for(job, 3)).rgb == drawn(job, 3).rgb) << "again";  // nothing old stays
}

TEST(FrameServer, OfOrdersThatWaitTheNewestWins) {
  const TemporaryFolder folder;
  const Job job = job_for(write_run(folder / "run"));
  FrameServer server(Gl::any, programs());
  for (int moment = 0; moment < 6; ++moment) server.want(order_for(job, moment));
  int pictures = 0;
  ASSERT_TRUE(looks_until(server, [&] {
    pictures += server.answer().width > 0 && server.order().time_s >= 0 ? 1 : 0;
    return !server.busy();
  }));
  EXPECT_DOUBLE_EQ(server.answer().pane[0].since_start_s, 5e-6);
  EXPECT_DOUBLE_EQ(server.answer().pane[0].tip_m, tip_at_moment(5));
}

TEST(FrameServer, SaysWhatItShows) {
  const TemporaryFolder folder;
  Job job = job_for(write_run(folder / "run"));
  job.look.range_of_moment = true;
  FrameServer server(Gl::any, programs());
  served(server, order_for(job, 5));
  EXPECT_EQ(server.answer().panes, 1);
  EXPECT_TRUE(server.answer().pane[0].is_last);
  EXPECT_NEAR(server.answer().range[1], pulled, 1e-9);
  EXPECT_NEAR(server.answer().pane[0].velocity_m_s, 1000, 1e-9);
}

TEST(FrameServer, ThatIsKilledCostsOnePictureAndIsStartedAgain) {
  const TemporaryFolder folder;
  const Job job = job_for(write_run(folder / "run"));
  FrameServer server(Gl::any, programs());
  served(server, order_for(job, 1));
  ASSERT_EQ(kill(child_of_this_process(), SIGKILL), 0);
  server.want(order_for(job, 4));
  ASSERT_TRUE(looks_until(server, [&] { return !server.trouble().empty(); }));
  EXPECT_TRUE(contains(server.trouble(), "it was killed by signal 9"));
  ASSERT_TRUE(looks_until(server, [&] { return !server.busy(); }));
  EXPECT_EQ(server.trouble(), "");
  EXPECT_EQ(server.image().rgb, drawn(job, 4).rgb);
}

TEST(FrameServer, AtRestWakensNobodyAlsoWhereItsProgramEnds) {
  const TemporaryFolder folder;
  const Job job = job_for(write_run(folder / "run"));
  FrameServer server(Gl::any, programs());
  server.want(order_for(job, 1));
  EXPECT_GE(server.descriptor(), 0);
  ASSERT_TRUE(looks_until(server, [&] { return !server.busy(); }));
  EXPECT_EQ(server.descriptor(), -1);
  ASSERT_EQ(kill(child_of_this_process(), SIGKILL), 0);
  server.look();
  EXPECT_EQ(server.descriptor(), -1);
  EXPECT_EQ(server.trouble(), "");
}

TEST(FrameServer, ThatAlwaysFailsIsStartedOnceASecond) {
  const TemporaryFolder folder;
  write_script(folder / "rift-frames-osmesa",
               "echo started >> '" + (folder / "starts").string() + "'; exit 1");
  FrameServer server(Gl::any, folder.path());
  server.want(order_for(job_for(folder / "nothing"), 0));
  const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(700);
  while (std::chrono::steady_clock::now() < until) server.look();
  EXPECT_EQ(read_text(folder / "starts"), "started\n");
  EXPECT_TRUE(contains(server.trouble(), "it ended with code 1"));
  EXPECT_TRUE(server.busy());
}

TEST(FrameServer, WithoutAProgramSaysSo) {
  const TemporaryFolder folder;
  FrameServer server(Gl::osmesa, folder.path());
  server.want(order_for(job_for(folder / "nothing"), 0));
  EXPECT_TRUE(contains(server.trouble(), "cannot start "));
}

TEST(FrameServer, WithoutMemoryForAPictureSaysSo) {
  const TemporaryFolder folder;
  Job job = job_for(folder / "nothing");
  job.width = job.height = 2'000'000'000;
  FrameServer server(Gl::any, programs());
  EXPECT_NO_THROW(server.want(order_for(job, 0)));
  EXPECT_TRUE(contains(server.trouble(), "no room in shared memory"));
}

TEST(FrameServer, TurnsToEglWhereOsmesaIsNotToBeHad) {
  const TemporaryFolder folder;
  const Job job = job_for(write_run(folder / "run"));
  write_script(folder / "rift-frames-osmesa", "read order; exit 3");
  std::filesystem::create_symlink(programs() / "rift-frames-osmesa", folder / "rift-frames-egl");
  FrameServer server(Gl::any, folder.path());
  EXPECT_EQ(served(server, order_for(job, 2)).rgb, drawn(job, 2).rgb);
}

TEST(FrameServer, FollowsARunThatGoesOn) {
  const TemporaryFolder folder;
  const auto run = folder / "run";
  std::filesystem::create_directories(run);
  results::JournalWriter journal(run / results::journal_name);
  journal.write(results::RunHeader{header().dump()});
  journal.write(geometry());
  journal.write(frame(0));
  journal.flush();
  Job job = job_for(run);
  job.look.chart = Chart::none;
  FrameServer server(Gl::any, programs());
  served(server, order_for(job, 3));
  EXPECT_DOUBLE_EQ(server.answer().pane[0].tip_m, 0);
  for (int k = 1; k <= 3; ++k) journal.write(frame(k));
  journal.flush();
  served(server, order_for(job, 3));
  EXPECT_DOUBLE_EQ(server.answer().pane[0].tip_m, tip_at_moment(3));
}

TEST(FrameServer, NamesTheElementAtAPixel) {
  const TemporaryFolder folder;
  const Job job = job_for(write_run(folder / "run"));
  FrameServer server(Gl::any, programs());
  const int i = element(30, 6);
  const results::Frame shown = frame(3);
  Order order = order_for(job, 3);
  order.asked = place_of(
      job, {geometry().position[i][0], geometry().position[i][1] + shown.displacement[i][1]}, {0, 0});
  served(server, order);
  const Picked picked = server.answer().picked;
  EXPECT_EQ(picked.kind, Picked::Kind::element);
  EXPECT_EQ(picked.index, i);
  EXPECT_EQ(picked.pane, 0);
  EXPECT_FLOAT_EQ(static_cast<float>(picked.displacement_m[1]), shown.displacement[i][1]);
  EXPECT_FLOAT_EQ(static_cast<float>(picked.velocity_m_s[0]), 30);
  EXPECT_TRUE(std::isnan(picked.elastic_j));
  EXPECT_EQ(picked.damage, 0);
  order.asked = std::array{1.0, 1.0};
  served(server, order);
  EXPECT_EQ(server.answer().picked.kind, Picked::Kind::nothing);
  EXPECT_EQ(server.answer().picked.pane, -1);
}

TEST(FrameServer, NamesABeamWhereNoElementIs) {
  const TemporaryFolder folder;
  Job job = job_for(write_run(folder / "run"));
  job.look.beams = Beams::crossing;
  job.look.magnification = 5;  // opens the crack
  FrameServer server(Gl::any, programs());
  Order order = order_for(job, 3);
  order.asked = place_of(job, {0.0055, 0.5 * height + 2.5 * pulled}, {0, 0});  // column 5, which is broken
  served(server, order);
  const Picked picked = server.answer().picked;
  EXPECT_EQ(picked.kind, Picked::Kind::beam);
  EXPECT_EQ(picked.first, element(5, rows / 2 - 1));
  EXPECT_EQ(picked.second, element(5, rows / 2));
  EXPECT_EQ(picked.damage, 1);
}

}  // namespace
}  // namespace rift::viz
