#include "facenav/stereo/dense_matcher.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgproc.hpp>

#include "facenav/core/error.h"
#include "facenav/core/parallel_for.h"
#include "facenav/core/simd.h"
#include "matchers/block_search.h"
#include "matchers/disparity_field.h"
#include "matchers/plane_field.h"
#include "support/dotted_surface.h"
#include "support/sgbm_matcher.h"

using namespace facenav;
using namespace facenav::stereo;
namespace support = facenav::testing;

namespace {

constexpr int kWidth = 320, kHeight = 240, kDisparities = 64;

support::DottedSurface dotted(double noise_grey = 1.5) {
  return support::dottedSurface(kWidth, kHeight, kDisparities, noise_grey, 11);
}

struct MatchAccuracy {
  double rms_px = 0, found = 0, normalised = 0;
  int gross = 0;  // off by more than 1 px
};

// Evaluates pixels where the right image sees the surface and windows fit.
MatchAccuracy accuracyOf(const DisparityMap& map, const cv::Mat& truth) {
  MatchAccuracy e;
  int count = 0, all = 0;
  for (int y = 10; y < truth.rows - 10; ++y)
    for (int x = kDisparities + 10; x < truth.cols - 10; ++x, ++all) {
      const double d = map.disparity_px.at<float>(y, x) - truth.at<float>(y, x);
      if (std::isnan(d)) continue;
      ++count;
      if (std::abs(d) > 1) {
        ++e.gross;
        continue;
      }
      e.rms_px += d * d;
      e.normalised += std::pow(d / map.sigma_px.at<float>(y, x), 2);
    }
  e.rms_px = std::sqrt(e.rms_px / std::max(1, count - e.gross));
  e.normalised = std::sqrt(e.normalised / std::max(1, count - e.gross));
  e.found = double(count) / all;
  return e;
}

DisparityMap match(const support::DottedSurface& surface, const MatchOptions& options = {},
                   const std::string& name = "field") {
  return makeDenseMatcher(name)->match(surface.rectification, surface.images, options);
}

double largestDifference(const cv::Mat& a, const cv::Mat& b) {
  double largest = 0;
  for (int i = 0; i < int(a.total()); ++i) {
    const float p = a.ptr<float>()[i], q = b.ptr<float>()[i];
    if (std::isnan(p) != std::isnan(q)) return std::numeric_limits<double>::infinity();
    if (!std::isnan(p)) largest = std::max(largest, double(std::abs(p - q)));
  }
  return largest;
}

}  // namespace

TEST(FieldMatcher, DotsAreMatchedToATwentyfifthOfAPixel) {
  const auto surface = dotted();
  MatchOptions options;
  const MatchAccuracy fast = accuracyOf(match(surface, options), surface.truth_px);
  EXPECT_LT(fast.rms_px, 0.045);
  EXPECT_GT(fast.found, 0.98);
  EXPECT_LT(fast.gross, 30);
  options.steps = 3;
  const MatchAccuracy converged = accuracyOf(match(surface, options), surface.truth_px);
  EXPECT_LT(converged.rms_px, 0.030);
  EXPECT_EQ(converged.gross, 0);
  EXPECT_GT(converged.normalised, 0.6);  // the given deviation is about true
  EXPECT_LT(converged.normalised, 1.6);
}

// OpenCV's matcher shares no code with ours; agreement supports both.
TEST(FieldMatcher, AgreesWithOpenCvsSemiGlobalMatcher) {
  const auto surface = dotted();
  const MatchOptions options;
  const DisparityMap ours = match(surface, options),
                     peer = support::SgbmMatcher().match(surface.rectification, surface.images, options);
  int both = 0, differ = 0;
  for (int i = 0; i < int(ours.disparity_px.total()); ++i) {
    const float a = ours.disparity_px.ptr<float>()[i], b = peer.disparity_px.ptr<float>()[i];
    if (std::isnan(a) || std::isnan(b)) continue;
    ++both;
    differ += std::abs(a - b) > 0.5f;
  }
  EXPECT_GT(both, 0.6 * ours.disparity_px.total());
  EXPECT_LT(differ, both / 100);
}

TEST(FieldMatcher, TwoCamerasThatSeeDifferentlyBrightMatchAsWell) {
  auto surface = dotted();
  surface.images.right = surface.images.right * 0.7 + 20;
  EXPECT_LT(accuracyOf(match(surface), surface.truth_px).rms_px, 0.045);
}

TEST(FieldMatcher, ThreadsDoNotChangeTheResult) {
  const auto surface = dotted();
  const int threads = cv::getNumThreads();
  MatchOptions options;
  options.details = 2;
  const auto onOneCore = [&] {
    const OneCoreOnly one_core;
    cv::setNumThreads(1);
    return match(surface, options);
  };
  const DisparityMap one = onOneCore();
  cv::setNumThreads(2);
  const DisparityMap two = match(surface, options);
  cv::setNumThreads(threads);
  EXPECT_EQ(largestDifference(one.disparity_px, two.disparity_px), 0.0);
  EXPECT_EQ(largestDifference(one.sigma_px, two.sigma_px), 0.0);
}

TEST(FieldMatcher, KernelsOfBothInstructionSetsAgree) {
  if (instructionSet() != InstructionSet::avx2) GTEST_SKIP() << "this processor has no AVX2";
  const auto surface = dotted();
  const MatchImages images(surface.rectification, surface.images);
  const cv::Mat start = searchBlocks(surface.rectification, surface.images);
  PlaneField fast(images, planes::avx2Kernel()), base(images, planes::baseKernel());
  for (PlaneField* field : {&fast, &base}) {
    field->start(start);
    field->step(3.0);
    field->step(3.0);
  }
  EXPECT_LT(cv::norm(fast.nodes(), base.nodes(), cv::NORM_INF), 0.02);
}

TEST(FieldMatcher, AHoleIsGrownOverFromItsSides) {
  const auto surface = dotted();
  const MatchImages images(surface.rectification, surface.images);
  cv::Mat blocks;
  cv::resize(surface.truth_px, blocks, {kWidth / 4, kHeight / 4}, 0, 0, cv::INTER_AREA);
  const cv::Rect hole(40, 25, 4, 4);  // blocks, where the search went wrong
  blocks(hole) += 5.0;
  const auto inHole = [&](int growths) {
    PlaneField field(images);
    field.start(blocks);
    for (int i = 0; i < 2; ++i) field.step(3.0);
    for (int i = 0; i < growths; ++i) field.grow(3.0, {});
    const cv::Rect pixels(4 * hole.x, 4 * hole.y, 4 * hole.width, 4 * hole.height);
    const cv::Mat off = cv::abs(field.map({}).disparity_px - surface.truth_px)(pixels);
    return cv::countNonZero(off < 0.15) / double(pixels.area());  // NaN is not
  };
  EXPECT_LT(inHole(0), 0.5);
  EXPECT_GT(inHole(6), 0.95);
}

TEST(FieldMatcher, APredictedSurfaceNeedsNoSearch) {
  const auto surface = dotted();
  MatchOptions options;
  options.steps = 3;
  const MatchAccuracy searched = accuracyOf(match(surface, options), surface.truth_px);
  cv::resize(surface.truth_px + 0.5, options.predicted_px, {kWidth / 4, kHeight / 4}, 0, 0, cv::INTER_AREA);
  const MatchAccuracy predicted = accuracyOf(match(surface, options), surface.truth_px);
  EXPECT_LT(predicted.rms_px, 1.2 * searched.rms_px);
  EXPECT_GT(predicted.found, 0.98);
}

// For any images each matcher terminates, and its accepted disparities are finite and inside the searched
// range.
TEST(DenseMatchers, ComeBackFromImagesThatHoldNothingToMatch) {
  const float nan = std::numeric_limits<float>::quiet_NaN(),
              infinite = std::numeric_limits<float>::infinity();
  cv::RNG random{std::uint64_t(3)};
  for (int kind = 0; kind < 7; ++kind) {
    auto surface = dotted();
    cv::Mat &left = surface.images.left, &right = surface.images.right;
    if (kind == 0) left.setTo(nan), right.setTo(nan);
    if (kind == 1) left.setTo(infinite);
    if (kind == 2) left.setTo(120), right.setTo(120);
    if (kind == 3) left.setTo(255), right.setTo(0);
    if (kind == 4) random.fill(left, cv::RNG::UNIFORM, 0, 255), random.fill(right, cv::RNG::UNIFORM, 0, 255);
    if (kind == 5) left = cv::max(left * 10, 0), left = cv::min(left, 255);
    if (kind == 6)
      for (int i = 0; i < int(left.total()); i += 97) left.ptr<float>()[i] = i % 2 ? nan : infinite;
    for (const char* name : {"field", "ssd"}) {
      MatchOptions options;
      options.details = 2;
      const DisparityMap map = match(surface, options, name);
      int outside = 0;
      for (int i = 0; i < int(map.disparity_px.total()); ++i) {
        const float d = map.disparity_px.ptr<float>()[i];
        outside += !std::isnan(d) && !(d >= -1 && d <= kDisparities + 1 && map.sigma_px.ptr<float>()[i] < 1);
      }
      EXPECT_EQ(outside, 0) << name << " on images of kind " << kind;
    }
  }
}

TEST(DenseMatchers, AreMadeByName) {
  for (const std::string& name : denseMatcherNames()) EXPECT_NE(makeDenseMatcher(name), nullptr);
  EXPECT_THROW(makeDenseMatcher("guess"), facenav::Error);
}
