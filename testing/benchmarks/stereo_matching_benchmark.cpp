// Dense stereo beside its peers in one run: time on one core and on all, error on a dotted plane with known
// truth, and Aloe (opencv-doc, half size) with its ground truth. Prints a Markdown table.

#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "disparity_search.h"
#include "facenav/stereo/dense_matcher.h"
#include "support/stereo_scene.h"
#include "support/test_data.h"

using namespace facenav;
using namespace facenav::stereo;
namespace support = facenav::testing;

namespace {

// Processor time, which other programs on the machine do not lengthen: for work on one thread.
double processor_ms(const std::function<void()>& work) {
  double best_ms = 1e9;
  for (int i = 0; i < 7; ++i) {
    const std::clock_t start = std::clock();
    work();
    best_ms = std::min(best_ms, 1e3 * double(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return best_ms;
}

double fastest_ms(const std::function<void()>& work) {
  double best_ms = 1e9;
  for (int i = 0; i < 7; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
    best_ms = std::min(best_ms, taken.count());
  }
  return best_ms;
}

struct Pair {
  Rectification rectification;
  RectifiedPair images;
  cv::Mat left8, right8;  // for the peers: same columns on both sides
};

// A pair that is rectified already, with disparities from 0 on.
Pair rectifiedPair(const cv::Mat& left, const cv::Mat& right, int disparities) {
  Pair pair;
  pair.left8 = left;
  pair.right8 = right;
  Rectification& r = pair.rectification;
  r.f_px = 800;
  r.baseline_mm = 120;
  r.disparities = disparities;
  r.left_mask = cv::Mat(left.size(), CV_8U, cv::Scalar(255));
  cv::copyMakeBorder(r.left_mask, r.right_mask, 0, 0, disparities, 0, cv::BORDER_CONSTANT, cv::Scalar(0));
  cv::Mat wide;
  cv::copyMakeBorder(right, wide, 0, 0, disparities, 0, cv::BORDER_REPLICATE);
  left.convertTo(pair.images.left, CV_32F);
  wide.convertTo(pair.images.right, CV_32F);
  return pair;
}

// Random dots on a surface whose disparity changes smoothly from 20 to 100 px, 640 x 480, noise of 1.5 grey
// levels.
struct DottedSurface {
  Pair pair;
  cv::Mat truth_px;
};

DottedSurface dottedSurface() {
  cv::RNG random{std::uint64_t(11)};
  cv::Mat pattern = cv::Mat::zeros(4 * 480, 4 * 800, CV_32F);
  for (int i = 0; i < 12000; ++i)
    cv::circle(pattern, {random.uniform(0, pattern.cols), random.uniform(0, pattern.rows)}, 4,
               cv::Scalar(130), -1);
  cv::GaussianBlur(pattern, pattern, {}, 3.2);
  DottedSurface surface;
  surface.truth_px.create(480, 640, CV_32F);
  cv::Mat left_map(480, 640, CV_32FC2), right_map(480, 640, CV_32FC2), left, right;
  const auto disparity = [](double x, double y) {
    return 60 + 30 * std::sin(x / 140) + 10 * std::sin(y / 90);
  };
  for (int y = 0; y < 480; ++y)
    for (int x = 0; x < 640; ++x) {
      surface.truth_px.at<float>(y, x) = float(disparity(x, y));
      left_map.at<cv::Vec2f>(y, x) = {4 * float(x), 4 * float(y)};
      double seen = x;  // left column that the right pixel sees
      for (int i = 0; i < 40; ++i) seen = x + disparity(seen, y);
      right_map.at<cv::Vec2f>(y, x) = {4 * float(seen), 4 * float(y)};
    }
  cv::remap(pattern, left, left_map, cv::noArray(), cv::INTER_CUBIC);
  cv::remap(pattern, right, right_map, cv::noArray(), cv::INTER_CUBIC);
  cv::Mat noise(480, 640, CV_32F), left8, right8;
  random.fill(noise, cv::RNG::NORMAL, 50, 1.5);
  cv::Mat(left + noise).convertTo(left8, CV_8U);
  random.fill(noise, cv::RNG::NORMAL, 50, 1.5);
  cv::Mat(right + noise).convertTo(right8, CV_8U);
  surface.pair = rectifiedPair(left8, right8, 128);
  return surface;
}

struct Error {
  double rms_px = 0, found = 0;
};

Error errorOf(const cv::Mat& disparity, const cv::Mat& truth, double sixteenths = 1.0) {
  Error error;
  int count = 0, seen = 0;
  for (int y = 20; y < truth.rows - 20; ++y)
    for (int x = 140; x < truth.cols - 20; ++x) {
      const double d =
          disparity.type() == CV_16S ? disparity.at<short>(y, x) * sixteenths : disparity.at<float>(y, x);
      const double difference = d - truth.at<float>(y, x);
      ++seen;
      if (!(std::abs(difference) < 1)) continue;  // NaN too
      ++count;
      error.rms_px += difference * difference;
    }
  error.rms_px = std::sqrt(error.rms_px / std::max(1, count));
  error.found = double(count) / seen;
  return error;
}

void row(const char* name, const std::function<cv::Mat()>& work, const cv::Mat& truth, double scale) {
  cv::setNumThreads(1);
  const double one_ms = processor_ms([&] { work(); });
  cv::setNumThreads(-1);
  const double all_ms = fastest_ms([&] { work(); });
  const Error error = errorOf(work(), truth, scale);
  std::printf("| %s | %.1f | %.1f | %.3f | %.1f |\n", name, one_ms, all_ms, error.rms_px, 100 * error.found);
}

void dottedTable() {
  const DottedSurface surface = dottedSurface();
  const Pair& pair = surface.pair;
  std::printf(
      "\n## Dotted surface, 640 x 480, 128 disparities\n\n| matcher | one core, ms | all cores, ms | rms px "
      "(within 1) | found %% |\n|---|---|---|---|---|\n");
  const auto matcher = makeDenseMatcher("ssd");
  MatchOptions planes;
  planes.refinements = 0;
  row(
      "ssd 11 x 11, whole pixels", [&] { return searchDisparities(pair.rectification, pair.images, 11); },
      surface.truth_px, 1);
  row(
      "ssd 11 x 11, sub-pixel, planes",
      [&] { return matcher->match(pair.rectification, pair.images, planes).disparity_px; }, surface.truth_px,
      1);
  row(
      "ssd 11 x 11, sub-pixel, refined",
      [&] { return matcher->match(pair.rectification, pair.images, {}).disparity_px; }, surface.truth_px, 1);
  const auto bm = cv::StereoBM::create(128, 11);
  bm->setSpeckleWindowSize(100);
  bm->setSpeckleRange(32);
  bm->setDisp12MaxDiff(1);
  const auto sgbm = cv::StereoSGBM::create(0, 128, 5, 200, 800, 1, 31, 5, 100, 2, cv::StereoSGBM::MODE_SGBM);
  cv::Mat out;
  row(
      "cv::StereoBM 11 with post-filter",
      [&] {
        bm->compute(pair.left8, pair.right8, out);
        return out;
      },
      surface.truth_px, 1.0 / 16);
  row(
      "cv::StereoSGBM, 5 directions",
      [&] {
        sgbm->compute(pair.left8, pair.right8, out);
        return out;
      },
      surface.truth_px, 1.0 / 16);
}

// Pixels of the left image whose true match is not hidden behind a nearer surface in the right one.
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
  const double scale = 0.5 * double(left.cols) * 2 / truth.cols;  // the truth counts pixels of its own size
  cv::resize(truth, truth, left.size(), 0, 0, cv::INTER_NEAREST);
  constexpr int kDisparities = 112;
  const Pair pair = rectifiedPair(left, right, kDisparities);
  const cv::Mat seen = seenByBoth(truth, scale);
  const auto bad = [&](const cv::Mat& disparity, double unit) {
    int known = 0, wrong = 0;
    for (int y = 6; y < truth.rows - 6; ++y)
      for (int x = kDisparities + 6; x < truth.cols - 6; ++x) {
        if (!seen.at<std::uint8_t>(y, x)) continue;
        ++known;
        const double d =
            disparity.type() == CV_16S ? disparity.at<short>(y, x) * unit : disparity.at<float>(y, x);
        wrong += !(std::abs(d - scale * truth.at<std::uint8_t>(y, x)) <= 2);
      }
    return 100.0 * wrong / known;
  };
  std::printf(
      "\n## Aloe, half size (%d x %d), pixels seen by both with known truth: off by more than 2 px or "
      "missing\n\n",
      left.cols, left.rows);
  const auto matcher = makeDenseMatcher("ssd");
  const auto ours = matcher->match(pair.rectification, pair.images, {}).disparity_px;
  MatchOptions lenient;  // every surface found, sure or not
  lenient.least_correlation = 0.3;
  lenient.largest_sigma_px = 2.0;
  lenient.largest_lever_px = 6.0;
  lenient.least_centre_texture = 0.0;
  lenient.refinements = 0;
  const auto all = matcher->match(pair.rectification, pair.images, lenient).disparity_px;
  const auto sgbm =
      cv::StereoSGBM::create(0, kDisparities, 5, 200, 800, 1, 31, 5, 100, 2, cv::StereoSGBM::MODE_SGBM);
  const auto bm = cv::StereoBM::create(kDisparities, 11);
  cv::Mat sgbm_out, bm_out;
  sgbm->compute(left, right, sgbm_out);
  bm->compute(left, right, bm_out);
  std::printf(
      "| matcher | bad-2 or missing %% |\n|---|---|\n| ssd | %.1f |\n| ssd, lenient | %.1f |\n| ssd, whole "
      "pixels | %.1f |\n| "
      "cv::StereoSGBM | %.1f |\n| cv::StereoBM | %.1f |\n",
      bad(ours, 1), bad(all, 1), bad(searchDisparities(pair.rectification, pair.images, 11), 1),
      bad(sgbm_out, 1.0 / 16), bad(bm_out, 1.0 / 16));
}

}  // namespace

int main() {
  dottedTable();
  aloeTable();
  return 0;
}
