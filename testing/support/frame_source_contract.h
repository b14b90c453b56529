#pragma once
// The contract of every FrameSource. The test of each source calls expectFrameSourceContract with a factory.

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <opencv2/core.hpp>

#include "facenav/capture/frame_source.h"

namespace facenav::testing {

/// Plays the source twice and checks: sizes and types as in the rig; frame numbers and times strictly
/// increase; the frame count is correct; next() stays null after the end; returned frames do not change
/// later; a second source gives the same frames.
inline void expectFrameSourceContract(const std::function<std::unique_ptr<capture::FrameSource>()>& make) {
  const auto source = make(), again = make();
  std::shared_ptr<const cameras::StereoFrame> first, last;
  cv::Mat first_left;
  std::int64_t count = 0;
  while (const auto frame = source->next()) {
    const cv::Size size(source->rig().width_px, source->rig().height_px);
    ASSERT_EQ(frame->left.size(), size);
    ASSERT_EQ(frame->right.size(), size);
    ASSERT_EQ(frame->left.type(), CV_8U);
    ASSERT_EQ(frame->right.type(), CV_8U);
    if (last) {
      ASSERT_GT(frame->number, last->number);
      ASSERT_GT(frame->captured.s, last->captured.s);
    } else {
      first = frame;
      first_left = frame->left.clone();
    }
    const auto twin = again->next();
    ASSERT_TRUE(twin);
    ASSERT_EQ(twin->number, frame->number);
    ASSERT_EQ(twin->captured.s, frame->captured.s);
    ASSERT_EQ(cv::norm(twin->left, frame->left, cv::NORM_INF), 0);
    ASSERT_EQ(cv::norm(twin->right, frame->right, cv::NORM_INF), 0);
    last = frame;
    ++count;
  }
  ASSERT_GT(count, 0);
  EXPECT_EQ(count, source->frameCount().value_or(count));
  EXPECT_FALSE(source->next());
  EXPECT_FALSE(source->next());
  EXPECT_EQ(cv::norm(first->left, first_left, cv::NORM_INF), 0);
}

}  // namespace facenav::testing
