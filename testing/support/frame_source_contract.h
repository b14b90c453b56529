#pragma once
// What every FrameSource promises. Call expectFrameSourceContract with a factory from the test of each
// source.

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <opencv2/core.hpp>

#include "facenav/capture/frame_source.h"

namespace facenav::testing {

/// Plays the source twice: sizes and types as the rig says, numbers and times rise strictly, the count is as
/// stated, the end stays the end, frames handed out earlier do not change, and a second source gives the same
/// frames.
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
