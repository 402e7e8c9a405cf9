#include "studio/graphics/pace.hpp"

#include <gtest/gtest.h>

namespace rift::studio {
namespace {

TEST(PicturePace, ThePictureBeforeMustHaveBeenTaken) {
  PicturePace pace(true, 0);
  EXPECT_TRUE(pace.may_send(0));
  pace.begin(100000, 1);
  pace.written(1.1);
  EXPECT_FALSE(pace.may_send(1.9));
  pace.taken(2);
  EXPECT_TRUE(pace.may_send(2));
  EXPECT_DOUBLE_EQ(pace.bytes_per_s(), 100000);
}

TEST(PicturePace, ATerminalThatNeverAnswersIsNotWaitedFor) {
  PicturePace pace(false, 0);
  pace.begin(100000, 1);
  pace.written(1.5);
  EXPECT_TRUE(pace.may_send(1.5));
  EXPECT_DOUBLE_EQ(pace.bytes_per_s(), 200000);
}

TEST(PicturePace, ATerminalThatStopsAnsweringIsNotWaitedForForEver) {
  PicturePace pace(true, 0);
  pace.begin(100000, 1);
  EXPECT_FALSE(pace.may_send(10));
  EXPECT_TRUE(pace.may_send(30));
}

TEST(PicturePace, ALimitIsKept) {
  PicturePace pace(true, 50000);
  pace.begin(100000, 1);
  pace.taken(1.1);
  EXPECT_FALSE(pace.may_send(2.9));
  EXPECT_TRUE(pace.may_send(3));
  EXPECT_DOUBLE_EQ(pace.bytes_per_s(), 50000);
}

TEST(PicturePace, AFewBytesSayNothingOfTheSpeed) {
  PicturePace pace(true, 0);
  pace.begin(20, 1);
  pace.taken(1.2);
  EXPECT_EQ(pace.bytes_per_s(), 0);
}

TEST(PicturePace, AnAnswerThatIsForgottenIsNotWaitedFor) {
  PicturePace pace(true, 0);
  pace.begin(5000, 1);
  pace.written(1);
  EXPECT_TRUE(pace.waits());
  EXPECT_FALSE(pace.may_send(2));
  pace.forget();
  EXPECT_FALSE(pace.waits());
  EXPECT_TRUE(pace.may_send(2));
  EXPECT_EQ(pace.bytes_per_s(), 0) << "nothing was measured";
}

}  // namespace
}  // namespace rift::studio
