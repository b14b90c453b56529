// Cameras of a fake kernel that are unplugged, or hang, and return while a session reads them.

#include "facenav/capture/returning_cameras.h"

#include <gmock/gmock.h>

#include "unit/rig/capture/v4l2_bench.h"

namespace facenav::capture {
namespace {

using ::testing::HasSubstr;

class ReturningCamerasTest : public ::testing::Test {
 protected:
  std::unique_ptr<FrameSource> make() {
    return makeReturningCameras([this] { return testing::openPair(left_, right_, 0.3); });
  }
  /// Returns the first frame within `limit_s` that has pictures, or has none; checks all others.
  std::shared_ptr<const cameras::StereoFrame> until(FrameSource& source, bool has_pictures,
                                                    double limit_s = 10) {
    for (const double end_s = Timestamp::now().s + limit_s; Timestamp::now().s < end_s;) {
      const auto frame = source.next();
      if (!frame) return nullptr;
      EXPECT_EQ(frame->number, number_++);
      EXPECT_GT(frame->captured.s, last_s_);
      EXPECT_EQ(frame->left.empty(), !frame->absence.empty());
      EXPECT_EQ(frame->right.empty(), !frame->absence.empty());
      last_s_ = frame->captured.s;
      if (frame->absence.empty() == has_pictures) return frame;
    }
    return nullptr;
  }

  std::shared_ptr<testing::FakeV4l2> kernel_ = std::make_shared<testing::FakeV4l2>();
  V4l2Bench left_{kernel_, "/dev/video0"}, right_{kernel_, "/dev/video2"};
  std::int64_t number_ = 0;
  double last_s_ = -1;
};

TEST_F(ReturningCamerasTest, AnUnpluggedOneIsSaidAndReadAgainWhenItIsBack) {
  const auto source = make();
  ASSERT_TRUE(until(*source, true));
  right_.unplug(true);
  const auto away = until(*source, false);
  ASSERT_TRUE(away);
  EXPECT_THAT(away->absence, HasSubstr("unplugged"));
  EXPECT_THAT(away->absence, HasSubstr("/dev/video2"));
  const Timestamp begin = Timestamp::now();
  for (int i = 0; i < 5; ++i) ASSERT_TRUE(until(*source, false)) << "it stays away";
  EXPECT_LT(Timestamp::now() - begin, 5 * 0.24) << "a session takes an older state for stale";
  // Settings that the camera lost without power are set again.
  right_.camera().controls.at(V4L2_CID_EXPOSURE_AUTO).value = V4L2_EXPOSURE_APERTURE_PRIORITY;
  right_.unplug(false);
  ASSERT_TRUE(until(*source, true));
  EXPECT_EQ(right_.camera().controls.at(V4L2_CID_EXPOSURE_AUTO).value, V4L2_EXPOSURE_MANUAL);
  EXPECT_EQ(kernel_->open_devices, 2) << "nothing is opened twice";
}

TEST_F(ReturningCamerasTest, OneThatHangsIsOpenedAnew) {
  const auto source = make();
  ASSERT_TRUE(until(*source, true));
  left_.hang(true);
  const auto away = until(*source, false);
  ASSERT_TRUE(away);
  EXPECT_THAT(away->absence, HasSubstr("no new picture"));
  left_.hang(false);
  EXPECT_TRUE(until(*source, true));
}

TEST_F(ReturningCamerasTest, WhatIsMissingAtTheStartIsRefusedAndWhatNoPlugMendsEndsIt) {
  right_.unplug(true);
  EXPECT_TRUE(testing::faultOf([this] { make(); }));
  right_.unplug(false);
  int opened = 0;
  const auto source = makeReturningCameras([&] {
    if (++opened == 1) return testing::openPair(left_, right_, 0.3);
    throw CameraError(CameraFault::wrong_size, "it gives no pictures of this size", "Webcam",
                      "use the rig's");
  });
  ASSERT_TRUE(until(*source, true));
  left_.unplug(true);
  ASSERT_TRUE(until(*source, false));
  EXPECT_EQ(testing::faultOf([&] {
              while (source->next()) {
              }
            }),
            CameraFault::wrong_size);
}

}  // namespace
}  // namespace facenav::capture
