#pragma once
// The contract of every Camera. The test of each backend calls expectCameraContract with a CameraBench, and
// expectLivePairContract with two.

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <opencv2/core.hpp>

#include "facenav/capture/camera_pair_source.h"

namespace facenav::testing {

/// Camera with the events that the test can cause. A hook that returns false cannot be tested with this
/// camera.
class CameraBench {
 public:
  virtual ~CameraBench() = default;
  /// Opens the camera. Throws CameraError as the backend does.
  virtual std::unique_ptr<capture::Camera> open() = 0;
  virtual capture::CameraSettings settings() const = 0;  // settings that the camera supports
  virtual bool hang(bool /*is_hung*/) { return false; }
  virtual bool unplug(bool /*is_unplugged*/) { return false; }
  virtual bool slowDown(double /*factor*/) { return false; }
  virtual double noticesUnplugWithin_s() const { return 1.0; }
  /// Part of the message about a wrong size that names an available size.
  virtual std::string sizeItHas() const { return std::to_string(settings().width_px); }
  virtual bool canStartAgain() const { return true; }
};

/// Returns the CameraFault that `action` throws; a failure if it throws none.
inline std::optional<capture::CameraFault> faultOf(const std::function<void()>& action,
                                                   std::string* words = nullptr) {
  try {
    action();
  } catch (const capture::CameraError& error) {
    if (words) *words = error.what();
    return error.fault();
  }
  return std::nullopt;
}

inline void expectPictures(capture::Camera& camera, const capture::CameraSettings& settings, int count) {
  std::optional<capture::CameraPicture> first, last;
  cv::Mat first_pixels;
  for (int i = 0; i < count; ++i) {
    auto picture = camera.next(2.0);
    ASSERT_TRUE(picture) << "picture " << i;
    ASSERT_EQ(picture->grey.size(), cv::Size(settings.width_px, settings.height_px));
    ASSERT_EQ(picture->grey.type(), CV_8U);
    const double age_s = Timestamp::now() - picture->captured;
    EXPECT_GE(age_s, 0.0);
    EXPECT_LT(age_s, 1.0);
    if (last) {
      ASSERT_GT(picture->sequence, last->sequence);
      ASSERT_GT(picture->captured.s, last->captured.s);
    } else {
      first = picture;
      first_pixels = picture->grey.clone();
    }
    last = picture;
  }
  EXPECT_EQ(cv::norm(first->grey, first_pixels, cv::NORM_INF), 0)
      << "a picture changed after it was delivered";
}

inline void expectStartAndStop(CameraBench& bench) {
  const auto camera = bench.open();
  const auto state = camera->configure(bench.settings());
  EXPECT_EQ(state.width_px, bench.settings().width_px);
  EXPECT_FALSE(state.format.empty());
  camera->start();
  ASSERT_NO_FATAL_FAILURE(expectPictures(*camera, bench.settings(), 5));
  EXPECT_FALSE(camera->state().clock.empty());
  EXPECT_GE(camera->counts().delivered, 5);
  camera->stop();
  camera->stop();
  if (!bench.canStartAgain()) return;
  camera->start();
  ASSERT_NO_FATAL_FAILURE(expectPictures(*camera, bench.settings(), 2));
}

inline void expectWrongSizeIsRefused(CameraBench& bench) {
  const auto camera = bench.open();
  auto wrong = bench.settings();
  wrong.width_px = 4999;
  std::string words;
  EXPECT_EQ(faultOf([&] { camera->configure(wrong); }, &words), capture::CameraFault::wrong_size);
  EXPECT_NE(words.find("4999"), std::string::npos) << words;
  EXPECT_NE(words.find(bench.sizeItHas()), std::string::npos) << "the sizes it has: " << words;
  camera->configure(bench.settings());
  camera->start();
  EXPECT_TRUE(camera->next(2.0));
}

inline void expectHangIsSurvived(CameraBench& bench) {
  const auto camera = bench.open();
  camera->configure(bench.settings());
  camera->start();
  ASSERT_TRUE(camera->next(2.0));
  if (!bench.hang(true)) return;
  while (camera->next(0.1)) {
  }
  const double begun_s = Timestamp::now().s;
  EXPECT_FALSE(camera->next(0.1));
  EXPECT_LT(Timestamp::now().s - begun_s, 0.6) << "next() must return in time";
  bench.hang(false);
  EXPECT_TRUE(camera->next(2.0));
}

inline void expectSlownessShowsInTheTimes(CameraBench& bench) {
  if (!bench.slowDown(5.0)) return;
  const auto camera = bench.open();
  camera->configure(bench.settings());
  camera->start();
  const auto first = camera->next(2.0), second = camera->next(2.0);
  bench.slowDown(1.0);
  ASSERT_TRUE(first && second);
  const double interval_s = 5.0 / bench.settings().frames_per_s;
  EXPECT_NEAR(second->captured - first->captured, interval_s, 0.3 * interval_s);
}

inline void expectUnplugIsSaidAndHeals(CameraBench& bench) {
  auto camera = bench.open();
  camera->configure(bench.settings());
  camera->start();
  ASSERT_TRUE(camera->next(2.0));
  if (!bench.unplug(true)) return;
  const double until_s = Timestamp::now().s + bench.noticesUnplugWithin_s();
  std::optional<capture::CameraFault> fault;
  std::string words;
  while (!fault && Timestamp::now().s < until_s) fault = faultOf([&] { camera->next(0.1); }, &words);
  EXPECT_EQ(fault, capture::CameraFault::unplugged);
  EXPECT_NE(words.find("unplugged"), std::string::npos) << words;
  camera.reset();
  EXPECT_TRUE(faultOf([&] { bench.open(); }));
  bench.unplug(false);
  camera = bench.open();
  camera->configure(bench.settings());
  camera->start();
  EXPECT_TRUE(camera->next(2.0));
}

inline void expectCameraContract(CameraBench& bench) {
  expectStartAndStop(bench);
  expectWrongSizeIsRefused(bench);
  expectHangIsSurvived(bench);
  expectSlownessShowsInTheTimes(bench);
  expectUnplugIsSaidAndHeals(bench);
}

inline cameras::StereoRig rigOfSize(const capture::CameraSettings& settings) {
  cameras::StereoRig rig;
  rig.width_px = settings.width_px;
  rig.height_px = settings.height_px;
  return rig;
}

inline std::unique_ptr<capture::CameraPairSource> openPair(CameraBench& left, CameraBench& right,
                                                           double patience_s = 2.0) {
  return capture::openCameraPair(rigOfSize(left.settings()), left.open(), right.open(),
                                 {left.settings(), right.settings(), patience_s});
}

/// Contract of a live FrameSource: sizes, rising numbers and times, the delay between the sides; a quick
/// stop; a silent camera and an unplugged one are named; afterwards both can be opened again.
inline void expectLivePairContract(CameraBench& left, CameraBench& right) {
  auto source = openPair(left, right);
  std::shared_ptr<const cameras::StereoFrame> first, last;
  cv::Mat first_left;
  for (int i = 0; i < 5; ++i) {
    const auto frame = source->next();
    ASSERT_TRUE(frame);
    ASSERT_EQ(frame->left.size(), cv::Size(source->rig().width_px, source->rig().height_px));
    ASSERT_EQ(frame->right.size(), frame->left.size());
    ASSERT_TRUE(frame->right_late_s);
    EXPECT_LE(std::abs(*frame->right_late_s), 0.61 / left.settings().frames_per_s);
    if (last) {
      ASSERT_GT(frame->number, last->number);
      ASSERT_GT(frame->captured.s, last->captured.s);
    } else {
      first = frame;
      first_left = frame->left.clone();
    }
    last = frame;
  }
  EXPECT_EQ(cv::norm(first->left, first_left, cv::NORM_INF), 0);
  EXPECT_GE(source->timing().pairs, 5);
  const double begun_s = Timestamp::now().s;
  source.reset();
  EXPECT_LT(Timestamp::now().s - begun_s, 1.5);
  if (right.hang(true)) {
    std::string words;
    EXPECT_EQ(faultOf(
                  [&] {
                    for (const auto silent = openPair(left, right, 0.4); silent->next();) {
                    }
                  },
                  &words),
              capture::CameraFault::hung);
    right.hang(false);
    EXPECT_NE(words.find(inWords(right.open()->identity())), std::string::npos) << words;
    EXPECT_EQ(words.find(inWords(left.open()->identity())), std::string::npos) << words;
  }
  source = openPair(left, right);
  ASSERT_TRUE(source->next());
  if (!right.unplug(true)) return;
  EXPECT_TRUE(faultOf([&] {
    while (source->next()) {
    }
  }));
  source.reset();
  right.unplug(false);
  EXPECT_TRUE(openPair(left, right)->next());
}

}  // namespace facenav::testing
