#include "studio/view/player.hpp"

#include <gtest/gtest.h>

namespace rift::studio {
namespace {

TEST(Player, PlaysAtItsRateAndPausesAtTheEnd) {
  Player player(10, 4);
  player.toggle(100);
  player.look(100.9);
  EXPECT_EQ(player.moment(), 3);
  EXPECT_NEAR(player.due_in(100.9), 0.1, 1e-9);
  player.look(200);
  EXPECT_EQ(player.moment(), 9);
  EXPECT_FALSE(player.playing());
  player.toggle(300);
  EXPECT_EQ(player.moment(), 0) << "from the beginning again";
}

TEST(Player, PausesWhereItIs) {
  Player player(10, 4);
  player.toggle(0);
  player.look(0.6);
  player.toggle(0.7);
  player.look(5);
  EXPECT_EQ(player.moment(), 2);
}

TEST(Player, StaysWithinTheMoments) {
  Player player(3, 4);
  player.go_to(-5);
  EXPECT_EQ(player.moment(), 0);
  player.go_to(7);
  EXPECT_EQ(player.moment(), 2);
}

TEST(Player, AnotherSpeedHoldsFromNowOn) {
  Player player(100, 10);
  player.toggle(0);
  player.look(1);
  player.change_speed(0.5, 1);
  player.look(2);
  EXPECT_EQ(player.moment(), 15);
}

TEST(Player, FollowsARunThatGrowsWhereItStandsAtTheEnd) {
  Player player(5, 10);
  player.grow(8);
  EXPECT_EQ(player.moment(), 0);
  player.go_to(7);
  player.grow(12);
  EXPECT_EQ(player.moment(), 11);
}

}  // namespace
}  // namespace rift::studio
