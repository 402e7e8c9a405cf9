#include "engine/packing/specimen.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace rift::packing {
namespace {

using Pairs = std::vector<std::array<int, 2>>;

const Box box{.length = 12.0, .height = 8.0, .thickness = 2.0};

/// Unit spheres: a column of four that overlap by a little, y = 1.1, 3.03, 4.97, 6.9.
Packing column() {
  return {.centre = {{1.0, 1.1, 1.0}, {1.0, 3.03, 1.0}, {1.0, 4.97, 1.0}, {1.0, 6.9, 1.0}},
          .radius = {1.0, 1.0, 1.0, 1.0}};
}

void add(Packing& packing, double x, double y, double radius) {
  packing.centre.emplace_back(x, y, 1.0);
  packing.radius.push_back(radius);
}

TEST(Plate, JoinsTheElementsInContactAndGripsThoseAtTheFaces) {
  const Specimen plate = make_plate(column(), box, 1.0);
  EXPECT_EQ(plate.beam, (Pairs{{0, 1}, {1, 2}, {2, 3}}));
  EXPECT_EQ(plate.grip, (std::vector<Grip>{Grip::bottom, Grip::none, Grip::none, Grip::top}));
  EXPECT_EQ(plate.centre, column().centre);
  EXPECT_EQ(plate.radius, column().radius);
  EXPECT_EQ(plate.rattlers, 0);
  EXPECT_EQ(plate.box.length, box.length);
  EXPECT_EQ(plate.box.height, box.height);
  EXPECT_EQ(plate.box.thickness, box.thickness);
}

TEST(Plate, LeavesOutRattlersAndCountsThem) {
  Packing packing = column();
  packing.centre.insert(packing.centre.begin() + 1, Eigen::Vector3d(4.0, 4.0, 1.0));  // touches nothing
  packing.radius.insert(packing.radius.begin() + 1, 0.9);
  add(packing, 7.0, 4.0, 1.0);  // these two touch each other only
  add(packing, 8.9, 4.0, 1.0);
  const Specimen plate = make_plate(packing, box, 1.0);
  EXPECT_EQ(plate.rattlers, 3);
  EXPECT_EQ(plate.centre, column().centre);
  EXPECT_EQ(plate.radius, column().radius);
  EXPECT_EQ(plate.beam, (Pairs{{0, 1}, {1, 2}, {2, 3}}));
  EXPECT_EQ(plate.grip, (std::vector<Grip>{Grip::bottom, Grip::none, Grip::none, Grip::top}));
  // The statistics are of the packing, rattlers included.
  EXPECT_NEAR(plate.packing.coordination, 2.0 * 4.0 / 7.0, 1e-15);
  EXPECT_NEAR(plate.packing.mean_radius, 6.9 / 7.0, 1e-15);
}

TEST(Plate, KeepsWhatHangsOnOneGripOnly) {
  Packing packing = column();
  add(packing, 6.0, 1.1, 1.0);  // a stump on the bottom grip
  add(packing, 6.0, 3.0, 1.0);
  add(packing, 9.0, 6.9, 1.0);  // and one below the top grip
  const Specimen plate = make_plate(packing, box, 1.0);
  EXPECT_EQ(plate.rattlers, 0);
  EXPECT_EQ(plate.beam, (Pairs{{0, 1}, {1, 2}, {2, 3}, {4, 5}}));
  EXPECT_EQ(plate.grip[4], Grip::bottom);
  EXPECT_EQ(plate.grip[5], Grip::none);
  EXPECT_EQ(plate.grip[6], Grip::top);
}

TEST(Plate, GripsElementsWithinOnePointThreeOfTheirRadius) {
  Packing packing = column();
  for (const double radius : {0.5, 1.0}) {
    add(packing, 3.0 + 4.0 * radius, 1.299 * radius, radius);
    add(packing, 3.0 + 4.0 * radius, 8.0 - 1.299 * radius, radius);
  }
  Specimen plate = make_plate(packing, box, 1.0);
  EXPECT_EQ(plate.rattlers, 0);
  EXPECT_EQ(std::count(plate.grip.begin(), plate.grip.end(), Grip::bottom), 3);
  EXPECT_EQ(std::count(plate.grip.begin(), plate.grip.end(), Grip::top), 3);
  for (int i : {4, 6}) packing.centre[i].y() = 1.301 * packing.radius[i];
  for (int i : {5, 7}) packing.centre[i].y() = 8.0 - 1.301 * packing.radius[i];
  plate = make_plate(packing, box, 1.0);
  EXPECT_EQ(plate.rattlers, 4);  // not gripped, and joined to nothing
}

TEST(Plate, TakesTheContactTolerance) {
  Packing packing = column();
  add(packing, 3.1, 3.03, 1.0);  // 5 % away from the column
  EXPECT_EQ(make_plate(packing, box, 1.0).rattlers, 1);
  const Specimen joined = make_plate(packing, box, 1.06);
  EXPECT_EQ(joined.rattlers, 0);
  EXPECT_EQ(joined.beam, (Pairs{{0, 1}, {1, 2}, {1, 4}, {2, 3}}));
}

std::string message_of(const Packing& packing) {
  try {
    make_plate(packing, box, 1.0);
  } catch (const PackingError& error) {
    return error.what();
  }
  return "no PackingError";
}

TEST(Plate, IsRefusedWhereNothingJoinsTheGrips) {
  const std::string refusal = "no path of beams joins the bottom grip to the top grip";
  Packing parted = column();
  parted.centre[1].y() -= 0.1;  // a gap in the middle
  EXPECT_EQ(message_of(parted), refusal);
  Packing bottomless = column();
  bottomless.centre[0].y() = 1.31;
  EXPECT_EQ(message_of(bottomless), refusal);
  Packing topless = column();
  topless.centre[3].y() = 6.69;
  EXPECT_EQ(message_of(topless), refusal);
  Packing two_columns = parted;  // the second one does not reach the bottom
  for (const double y : {3.03, 4.97, 6.9}) add(two_columns, 6.0, y, 1.0);
  EXPECT_EQ(message_of(two_columns), refusal);
}

TEST(ReachedFrom, FollowsBeamsOfAnyOrderAndDirection) {
  // 1 joined to 0, 2 and 3, the anchor at 2; 4-5 without one, 6 an anchor alone, 7 alone.
  const std::vector<char> anchor = {0, 0, 1, 0, 0, 0, 1, 0};
  const std::vector<char> expected = {1, 1, 1, 1, 0, 0, 1, 0};
  Pairs beam = {{0, 1}, {1, 2}, {1, 3}, {4, 5}};
  std::sort(beam.begin(), beam.end());
  do {
    Pairs turned = beam;
    for (auto& [i, j] : turned) std::swap(i, j);
    EXPECT_EQ(reached_from(anchor, beam), expected);
    EXPECT_EQ(reached_from(anchor, turned), expected);
  } while (std::next_permutation(beam.begin(), beam.end()));
}

TEST(ReachedFrom, GoesAsFarAsAChainDoes) {
  const int n = 100'000;
  std::vector<char> anchor(n, 0);
  anchor[n / 2] = 1;
  Pairs beam;
  for (int i = 0; i + 1 < n; ++i)
    if (i != 10) beam.push_back({i, i + 1});
  const std::vector<char> reached = reached_from(anchor, beam);
  EXPECT_EQ(std::count(reached.begin(), reached.end(), 1), n - 11);
  EXPECT_FALSE(reached[10]);
  EXPECT_TRUE(reached[11]);
}

TEST(ReachedFrom, IsNothingWithoutAnAnchor) {
  EXPECT_EQ(reached_from({0, 0}, {{0, 1}}), (std::vector<char>{0, 0}));
  EXPECT_EQ(reached_from({}, {}), std::vector<char>{});
}

}  // namespace
}  // namespace rift::packing
