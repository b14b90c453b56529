// Dense stereo and its peers in one run: time on one core and on all, error on a dotted surface with known
// truth, and on Aloe (opencv-doc, half size) with its ground truth. Prints Markdown tables.

#include <cmath>
#include <cstdio>
#include <functional>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "facenav/stereo/dense_matcher.h"
#include "paper/disparity_search.h"
#include "support/dotted_surface.h"
#include "support/stopwatch.h"
#include "support/test_data.h"

using namespace facenav;
using namespace facenav::stereo;
namespace support = facenav::testing;

namespace {

constexpr double kNoise_grey = 1.5;

struct Error {
  double rms_px = 0, found = 0;
};

// Error over pixels that both images show, with a margin. `unit`: px per step of a 16-bit disparity.
Error errorOf(const cv::Mat& disparity, const cv::Mat& truth, double unit) {
  Error error;
  int count = 0, seen = 0;
  for (int y = 20; y < truth.rows - 20; ++y)
    for (int x = 140; x < truth.cols - 20; ++x) {
      const double d =
          disparity.type() == CV_16S ? disparity.at<short>(y, x) * unit : disparity.at<float>(y, x);
      const double difference = d - truth.at<float>(y, x);
      ++seen;
      if (!(std::abs(difference) < 1)) continue;  // skips NaN, too
      ++count;
      error.rms_px += difference * difference;
    }
  error.rms_px = std::sqrt(error.rms_px / std::max(1, count));
  error.found = double(count) / seen;
  return error;
}

struct Contender {
  const char* name;
  std::function<cv::Mat()> work;
  double unit = 1.0;
  int runs = 7;
};

// Cramer-Rao bound: standard error of a disparity fitted to a window of `side` pixels in two images with this
// noise, rms over the image. A matcher with larger windows may be below it.
double bound_px(const cv::Mat& left, int side) {
  cv::Mat grey, gradient, information;
  left.convertTo(grey, CV_32F);
  cv::GaussianBlur(grey, grey, {}, 0.7);  // reduces gradients of the noise itself
  cv::Sobel(grey, gradient, CV_32F, 1, 0, 1, 0.5);
  cv::boxFilter(gradient.mul(gradient), information, CV_32F, {side, side}, {-1, -1}, false);
  double sum = 0;
  int count = 0;
  for (int y = 20; y < left.rows - 20; ++y)
    for (int x = 140; x < left.cols - 20; ++x, ++count)
      sum += 2 * kNoise_grey * kNoise_grey / std::max(1.0f, information.at<float>(y, x));
  return std::sqrt(sum / count);
}

void table(const std::vector<Contender>& contenders, const cv::Mat& truth, double bm_ms, double sgbm_ms) {
  std::printf(
      "| matcher | one core, ms | all cores, ms | StereoBM / this | StereoSGBM / this | rms px (within 1) | "
      "found %% "
      "|\n|---|---|---|---|---|---|---|\n");
  for (const Contender& c : contenders) {
    const double one_ms = support::oneCore_ms([&] { c.work(); }, c.runs);
    const double all_ms = support::allCores_ms([&] { c.work(); }, c.runs);
    const Error error = errorOf(c.work(), truth, c.unit);
    std::printf("| %s | %.1f | %.1f | %.1f | %.1f | %.3f | %.1f |\n", c.name, one_ms, all_ms, bm_ms / one_ms,
                sgbm_ms / one_ms, error.rms_px, 100 * error.found);
    std::fflush(stdout);
  }
}

void dottedTable() {
  const support::DottedSurface scene = support::dottedSurface(640, 480, 128, kNoise_grey, 11);
  const auto bm = cv::StereoBM::create(128, 11);
  bm->setSpeckleWindowSize(100);
  bm->setSpeckleRange(32);
  bm->setDisp12MaxDiff(1);
  const auto sgbm = cv::StereoSGBM::create(0, 128, 5, 200, 800, 1, 31, 5, 100, 2, cv::StereoSGBM::MODE_SGBM);
  const auto peer = [&](const cv::Ptr<cv::StereoMatcher>& matcher) {
    return [&scene, matcher] {
      cv::Mat out;
      matcher->compute(scene.left8, scene.right8, out);
      return out;
    };
  };
  const auto ours = [&](const char* name, const MatchOptions& options) {
    return [&scene, name, options] {
      return makeDenseMatcher(name)->match(scene.rectification, scene.images, options).disparity_px;
    };
  };
  MatchOptions two, detailed, predicted, lines;
  two.steps = 2;
  detailed.steps = 2;
  detailed.details = 3;
  cv::resize(scene.truth_px + 0.3, predicted.predicted_px, {160, 120}, 0, 0, cv::INTER_AREA);
  lines.refinements = 0;
  std::printf(
      "\n## Dotted surface, 640 x 480, 128 disparities\n\nCramer-Rao bound of 11 x 11 windows: %.3f px "
      "rms.\n\n",
      bound_px(scene.left8, 11));
  const double bm_ms = support::oneCore_ms([&] { peer(bm)(); }),
               sgbm_ms = support::oneCore_ms([&] { peer(sgbm)(); });
  table({{"field, all disparities searched, one step", ours("field", {})},
         {"field, two steps", ours("field", two)},
         {"field, two steps and three of detail (face cloud)", ours("field", detailed)},
         {"field, one step from a predicted surface, no search", ours("field", predicted)},
         {"ssd 11 x 11, whole pixels",
          [&] { return searchDisparities(scene.rectification, scene.images, 11); }},
         {"ssd 11 x 11, sub-pixel, planes", ours("ssd", lines), 1.0, 2},
         {"sgm, 8 paths", ours("sgm", {}), 1.0, 2},
         {"cv::StereoBM 11 with post-filter", peer(bm), 1.0 / 16},
         {"cv::StereoSGBM, 5 directions", peer(sgbm), 1.0 / 16}},
        scene.truth_px, bm_ms, sgbm_ms);
}

// Pixels of the left image whose true match is not occluded in the right one.
cv::Mat seenByBoth(const cv::Mat& truth, double scale) {
  cv::Mat seen = cv::Mat::zeros(truth.size(), CV_8U);
  for (int y = 0; y < truth.rows; ++y) {
    std::vector<double> nearest(std::size_t(truth.cols), 0.0);
    const auto column = [&](int x) { return int(std::lround(x - scale * truth.at<std::uint8_t>(y, x))); };
    for (int x = 0; x < truth.cols; ++x)
      if (truth.at<std::uint8_t>(y, x) && column(x) >= 0)
        nearest[column(x)] = std::max(nearest[column(x)], scale * truth.at<std::uint8_t>(y, x));
    for (int x = 0; x < truth.cols; ++x)
      if (truth.at<std::uint8_t>(y, x) && column(x) >= 0)
        seen.at<std::uint8_t>(y, x) =
            nearest[column(x)] < scale * truth.at<std::uint8_t>(y, x) + 1.5 ? 255 : 0;
  }
  return seen;
}

void aloeTable() {
  const auto folder = support::openCvSamples();
  cv::Mat left = cv::imread(folder / "aloeL.jpg", cv::IMREAD_GRAYSCALE),
          right = cv::imread(folder / "aloeR.jpg", cv::IMREAD_GRAYSCALE);
  cv::Mat truth = cv::imread(folder / "aloeGT.png", cv::IMREAD_GRAYSCALE);
  if (left.empty() || right.empty() || truth.empty()) {
    std::printf("\nAloe is not here (Debian opencv-doc): left out.\n");
    return;
  }
  cv::resize(left, left, {}, 0.5, 0.5, cv::INTER_AREA);
  cv::resize(right, right, {}, 0.5, 0.5, cv::INTER_AREA);
  // Converts from pixels of the truth's own size.
  const double scale = 0.5 * double(left.cols) * 2 / truth.cols;
  cv::resize(truth, truth, left.size(), 0, 0, cv::INTER_NEAREST);
  constexpr int kDisparities = 112;
  const auto scene = support::rectifiedScene(left, right, kDisparities);
  const cv::Mat seen = seenByBoth(truth, scale);
  std::printf(
      "\n## Aloe, half size (%d x %d), %d disparities, pixels seen by both with known truth\n\n| matcher | "
      "one core, "
      "ms | off by more than 2 px or missing %% |\n|---|---|---|\n",
      left.cols, left.rows, kDisparities);
  const auto row = [&](const char* name, double unit, const std::function<cv::Mat()>& work) {
    const double one_ms = support::oneCore_ms([&] { work(); }, 2);
    const cv::Mat disparity = work();
    int known = 0, wrong = 0;
    for (int y = 6; y < truth.rows - 6; ++y)
      for (int x = kDisparities + 6; x < truth.cols - 6; ++x) {
        if (!seen.at<std::uint8_t>(y, x)) continue;
        ++known;
        const double d =
            disparity.type() == CV_16S ? disparity.at<short>(y, x) * unit : disparity.at<float>(y, x);
        wrong += !(std::abs(d - scale * truth.at<std::uint8_t>(y, x)) <= 2);
      }
    std::printf("| %s | %.0f | %.1f |\n", name, one_ms, 100.0 * wrong / known);
    std::fflush(stdout);
  };
  MatchOptions lenient;  // accepts every match, certain or not
  lenient.least_correlation = 0.3;
  lenient.largest_sigma_px = 2.0;
  lenient.largest_lever_px = 6.0;
  lenient.least_centre_texture = 0.0;
  lenient.refinements = 0;
  for (const char* name : {"sgm", "field", "ssd"})
    row(name, 1, [&] {
      return makeDenseMatcher(name)->match(scene.rectification, scene.images, lenient).disparity_px;
    });
  const auto peer = [&](const char* name, const cv::Ptr<cv::StereoMatcher>& matcher) {
    row(name, 1.0 / 16, [&] {
      cv::Mat out;
      matcher->compute(left, right, out);
      return out;
    });
  };
  peer("cv::StereoSGBM, 5 directions",
       cv::StereoSGBM::create(0, kDisparities, 5, 200, 800, 1, 31, 5, 100, 2, cv::StereoSGBM::MODE_SGBM));
  peer("cv::StereoBM 11", cv::StereoBM::create(kDisparities, 11));
}

}  // namespace

int main() {
  dottedTable();
  aloeTable();
  return 0;
}
