#pragma once
// The contract of every tracker, head or coil. Call expectTrackerContract from the test of each tracker.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <functional>
#include <memory>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <vector>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/core/frame_work.h"
#include "facenav/core/tracked.h"
#include "facenav/geometry/normal_equations.h"

namespace facenav::testing {

/// `start` makes a started tracker; `start_again` restarts a used one. `frames` show the tracked object near
/// the reference, in the order of time. `Track` calls it with an empty context.
template <class Tracker, class Result>
struct TrackerContract {
  std::function<std::unique_ptr<Tracker>()> make;
  std::function<void(Tracker&)> start;
  std::function<Result(Tracker&, const cameras::StereoFrame&)> track;
  std::vector<cameras::StereoFrame> frames;
};

/// Compares two results to the last bit.
template <class Result>
void expectSame(const Result& a, const Result& b, std::size_t frame) {
  ASSERT_EQ(a.isTracked(), b.isTracked()) << frame;
  EXPECT_EQ(a.work.comparisons, b.work.comparisons) << frame;
  if (!a) {
    EXPECT_EQ(a.reason(), b.reason()) << frame;
    return;
  }
  EXPECT_EQ(a.quality(), b.quality()) << frame;
  EXPECT_EQ(a->covariance, b->covariance) << frame;
}

/// Expects a valid covariance with each pose, and no frame beyond its budget.
template <class Result>
void expectSound(const Result& result, std::size_t frame) {
  EXPECT_LE(result.work.comparisons, FrameWork::most()) << frame;
  if (!result) return;
  const Matrix6d& covariance = result->covariance;
  EXPECT_TRUE(covariance.allFinite()) << frame;
  EXPECT_LT((covariance - covariance.transpose()).norm(), 1e-9 * covariance.norm()) << frame;
  EXPECT_GT(principalAxes(covariance).values(0), 0.0) << frame;
}

/// Unusable frames: none, another size, colour, all of one grey.
inline std::vector<cameras::StereoFrame> unusableFrames(const cameras::StereoFrame& good) {
  const cv::Mat small = good.left(cv::Rect(0, 0, good.left.cols / 2, good.left.rows)).clone();
  const cv::Mat colour(good.left.size(), CV_8UC3, cv::Scalar(90, 90, 90));
  const cv::Mat grey(good.left.size(), CV_8UC1, cv::Scalar(90));
  std::vector<cameras::StereoFrame> frames;
  for (const cv::Mat& image : {cv::Mat(), small, colour, grey}) {
    cameras::StereoFrame frame = good;
    frame.left = frame.right = image;
    frames.push_back(frame);
    frame.left = good.left;  // one camera alone
    frames.push_back(frame);
  }
  return frames;
}

/// Plays the frames: the same frames give the same results, in a second tracker and after a second start; an
/// unusable frame gives Lost{camera}, and the next good one is tracked.
template <class Tracker, class Result>
void expectTrackerContract(const TrackerContract<Tracker, Result>& contract) {
  const auto first = contract.make(), second = contract.make();
  EXPECT_THROW(contract.track(*first, contract.frames.front()), std::logic_error) << "before start()";
  contract.start(*first);
  contract.start(*second);
  std::vector<Result> results;
  for (std::size_t i = 0; i < contract.frames.size(); ++i) {
    results.push_back(contract.track(*first, contract.frames[i]));
    ASSERT_TRUE(results[i].isTracked()) << i;
    expectSound(results[i], i);
    expectSame(results[i], contract.track(*second, contract.frames[i]), i);
  }
  contract.start(*second);
  for (std::size_t i = 0; i < contract.frames.size(); ++i)
    expectSame(results[i], contract.track(*second, contract.frames[i]), i);

  contract.start(*second);
  contract.track(*second, contract.frames.front());
  for (const auto& frame : unusableFrames(contract.frames[1])) {
    const Result refused = contract.track(*second, frame);
    ASSERT_FALSE(refused.isTracked());
    EXPECT_EQ(refused.reason(), LostReason::camera);
    expectSound(refused, 1);
  }
  EXPECT_TRUE(contract.track(*second, contract.frames.back()).isTracked());
}

}  // namespace facenav::testing
