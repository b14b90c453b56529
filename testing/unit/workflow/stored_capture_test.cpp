// The capture pair that a case keeps beside its alignment: it says which cameras the alignment belongs to.

#include "facenav/workflow/stored_capture.h"

#include <gmock/gmock.h>

#include "facenav/core/error.h"
#include "support/stereo_rigs.h"
#include "support/test_data.h"

namespace facenav::workflow {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

capture::CapturePair someCapture(const stereo::StereoRig& rig) {
  capture::CapturePair pair;
  for (stereo::StereoFrame* frame : {&pair.pattern, &pair.plain})
    for (cv::Mat* image : {&frame->left, &frame->right})
      *image = cv::Mat(rig.height_px, rig.width_px, CV_8U, cv::Scalar(90));
  return pair;
}

TEST(StoredCapture, AnAlignmentOfOtherCamerasIsRefusedInOneClearLine) {
  const facenav::testing::TemporaryFolder folder;
  const auto rig = facenav::testing::convergingRig();
  EXPECT_FALSE(readStoredCapture(folder.path(), rig).has_value()) << "no capture, no claim";
  writeStoredCapture(folder.path(), rig, someCapture(rig));
  const auto same = readStoredCapture(folder.path(), rig);
  ASSERT_TRUE(same.has_value());
  EXPECT_EQ(same->pattern.left.size(), cv::Size(rig.width_px, rig.height_px));

  auto longer = rig;
  longer.left.k(0, 0) += 0.5;  // a calibration anew
  auto moved = rig;
  moved.right_T_left = {rig.right_T_left.quaternion(),
                        rig.right_T_left.translation_mm() + Eigen::Vector3d(0.05, 0, 0)};
  for (const auto& other : {longer, moved, facenav::testing::verticalRig()})
    EXPECT_THAT([&] { readStoredCapture(folder.path(), other); },
                ThrowsMessage<Error>(HasSubstr("aligned with another camera rig")));
}

}  // namespace
}  // namespace facenav::workflow
