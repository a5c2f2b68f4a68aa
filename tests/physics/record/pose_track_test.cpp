#include "physics/record/pose_track.h"

#include <gtest/gtest.h>

namespace carom {
namespace {

// One body per column, all at the same place.
Eigen::Matrix3Xd at_x(double x, Eigen::Index bodies = 2) {
  Eigen::Matrix3Xd q = Eigen::Matrix3Xd::Zero(3, bodies);
  q.row(0).setConstant(x);
  return q;
}

TEST(PoseTrackTest, IsLinearBetweenMoments) {
  PoseTrack track;
  track.add(0.0, at_x(1.0), 0);
  track.add(0.1, at_x(2.0), 0);
  EXPECT_NEAR((*track.at(0.025))(0, 1), 1.25, 1e-6);
  EXPECT_EQ((*track.at(0.1))(0, 0), 2.0);
  EXPECT_FALSE(track.at(-0.001));
  EXPECT_FALSE(track.at(0.101)) << "after the end nothing is known";
}

TEST(PoseTrackTest, KnowsNothingInALongGap) {
  PoseTrack track;
  track.add(0.0, at_x(1.0), 0);
  track.add(2.0 * PoseTrack::kLongestGap, at_x(2.0), 0);
  EXPECT_FALSE(track.at(0.1));
  EXPECT_TRUE(track.at(0.0));
}

TEST(PoseTrackTest, ARunThatGoesBackHasAnotherPast) {
  PoseTrack track;
  for (int i = 0; i <= 10; ++i) track.add(0.1 * i, at_x(i), 0);
  track.add(0.35, at_x(-1.0), 0);
  EXPECT_FALSE(track.at(0.4));
  EXPECT_EQ((*track.at(0.35))(0, 0), -1.0);
  track.cut(0.25);
  EXPECT_FALSE(track.at(0.3));
  EXPECT_NEAR((*track.at(0.2))(0, 0), 2.0, 1e-6);
}

TEST(PoseTrackTest, ABodyThatCameLaterIsLeftOutBeforeIt) {
  PoseTrack track;
  track.add(0.0, at_x(1.0, 2), 0);
  track.add(0.1, at_x(2.0, 3), 0);
  EXPECT_EQ(track.at(0.05)->cols(), 2);
  EXPECT_EQ(track.at(0.1)->cols(), 3);
}

TEST(PoseTrackTest, ItsMemoryIsBoundedAndTheWholeRunStaysKnown) {
  PoseTrack track;
  constexpr int kCount = 200'000;
  constexpr double kStep = 1.0 / 2000.0;
  for (int i = 0; i <= kCount; ++i) track.add(kStep * i, at_x(kStep * i), 0);
  EXPECT_LE(track.bytes(), PoseTrack::kMostBytes);
  EXPECT_GT(track.bytes(), PoseTrack::kMostBytes / 4);
  for (const double time : {0.0, 0.7, 31.4, 99.2, kStep * kCount}) {
    ASSERT_TRUE(track.at(time)) << time;
    EXPECT_NEAR((*track.at(time))(0, 0), time, 1e-5);
  }
}

TEST(PoseTrackTest, KeepsNothingOfACrowd) {
  PoseTrack track;
  track.add(0.0, at_x(1.0), 0);
  track.add(0.1, at_x(1.0, PoseTrack::kMostBodies + 1), 0);
  EXPECT_EQ(track.size(), 0U);
}

TEST(PoseTrack, KnowsNothingBetweenTwoMomentsWithAnImpact) {
  PoseTrack track;
  track.add(0.0, at_x(1.0), 0);
  track.add(0.1, at_x(2.0), 1);
  track.add(0.2, at_x(3.0), 1);
  EXPECT_FALSE(track.at(0.05));
  EXPECT_TRUE(track.at(0.1));
  EXPECT_NEAR((*track.at(0.15))(0, 0), 2.5, 1e-6);
}

}  // namespace
}  // namespace carom
