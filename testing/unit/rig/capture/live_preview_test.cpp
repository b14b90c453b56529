#include "facenav/capture/live_preview.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "facenav/core/error.h"

namespace facenav::capture {
namespace {

/// Source of frames every `interval_s` of their own clock; after the last one a failure or the end.
class Frames : public FrameSource {
 public:
  Frames(int count, double interval_s, bool fails) : count_(count), interval_s_(interval_s), fails_(fails) {}
  const cameras::StereoRig& rig() const override { return rig_; }
  std::shared_ptr<const cameras::StereoFrame> next() override {
    if (number_ == count_ && fails_) throw Error("camera gives no image", "camera 2", "check the cable");
    if (number_ == count_) return nullptr;
    auto frame = std::make_shared<cameras::StereoFrame>();
    frame->number = number_;
    frame->captured = {100.0 + number_++ * interval_s_};
    return frame;
  }

 private:
  cameras::StereoRig rig_;
  int count_, number_ = 0;
  double interval_s_;
  bool fails_;
};

void waitForTheEnd(const LivePreview& preview) {
  for (int i = 0; i < 500 && !preview.hasEnded(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

TEST(LivePreview, ShowsTheNewestPairAndTheEnd) {
  LivePreview preview(std::make_unique<Frames>(4, 10.0, false), false);
  waitForTheEnd(preview);
  ASSERT_TRUE(preview.hasEnded());
  ASSERT_NE(preview.latest(), nullptr);
  EXPECT_EQ(preview.latest()->number, 3);
  EXPECT_TRUE(preview.failure().empty());
  EXPECT_LT(preview.age_s(), 60.0);
}

TEST(LivePreview, SaysWhyNoMorePicturesCome) {
  LivePreview preview(std::make_unique<Frames>(2, 0.0, true), false);
  waitForTheEnd(preview);
  EXPECT_NE(preview.failure().find("camera 2"), std::string::npos);
}

TEST(LivePreview, APacedRecordingTakesItsTimeAndStopsAtOnce) {
  const auto begun = std::chrono::steady_clock::now();
  {
    LivePreview paced(std::make_unique<Frames>(3, 0.05, false), true);
    waitForTheEnd(paced);
    EXPECT_GE(std::chrono::steady_clock::now() - begun, std::chrono::milliseconds(95));
  }
  LivePreview endless(std::make_unique<Frames>(1000, 3600.0, false), true);  // destroyed without waiting
}

}  // namespace
}  // namespace facenav::capture
