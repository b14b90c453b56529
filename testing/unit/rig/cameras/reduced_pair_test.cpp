#include "facenav/cameras/reduced_pair.h"

#include <gtest/gtest.h>

#include "support/matchers.h"
#include "support/stereo_rigs.h"

using namespace facenav;
using namespace facenav::cameras;
namespace support = facenav::testing;

TEST(ReducedPair, ProjectsWhereThePixelsOfTheWholePictureLie) {
  const StereoRig rig = support::convergingRig();
  for (const int times : {1, 2, 4}) {
    const StereoRig small = reduced(rig, times);
    EXPECT_EQ(small.width_px, 640 / times);
    const Eigen::Vector3d p(40, -30, 600);
    const Eigen::Vector2f px = project(small.left, p).cast<float>();
    EXPECT_THAT(inWholePicture(px, times),
                support::EigenNear(project(rig.left, p).cast<float>().eval(), 1e-3f));
  }
}

TEST(ReducedPair, PixelsAreTheMeanOfThoseTheyHold) {
  StereoFrame frame;
  frame.left = (cv::Mat_<std::uint8_t>(2, 5) << 10, 20, 100, 104, 7, 30, 40, 100, 96, 7);
  frame.right = frame.left.clone();
  frame.number = 12;
  const StereoFrame small = reduced(frame, 2);
  ASSERT_EQ(small.left.size(), cv::Size(2, 1));  // the fifth column fills no pixel
  EXPECT_EQ(small.left.at<std::uint8_t>(0, 0), 25);
  EXPECT_EQ(small.left.at<std::uint8_t>(0, 1), 100);
  EXPECT_EQ(small.number, 12);
}

TEST(ReducedPair, NoMoreThanTheDepthAllows) {
  const StereoRig rig = support::convergingRig();  // f 800 px: 1.33 px/mm at 600 mm
  EXPECT_EQ(reductionFor(rig, 600, 1.0), 1);
  EXPECT_EQ(reductionFor(rig, 600, 0.6), 2);
  EXPECT_EQ(reductionFor(rig, 200, 1.0), 4);
}
