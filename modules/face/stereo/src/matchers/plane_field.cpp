#include "plane_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "disparity_filter.h"
#include "facenav/core/error.h"
#include "facenav/core/parallel_for.h"
#include "strips.h"

namespace facenav::stereo {

namespace {

planes::Window windowOf(double sigma_px) {
  // A block of 4 x 4 pixels has an own variance of 1.25 px^2 along each axis.
  constexpr double kBlockVariance = 1.25, kLeast = 0.3;
  const double sigma = std::sqrt(std::max(sigma_px * sigma_px - kBlockVariance, kLeast)) / planes::kBlock;
  planes::Window window{std::clamp(int(std::ceil(2.2 * sigma)), 1, planes::kLargestRadius), {}, 0};
  double sum = 0, squares = 0;
  for (int i = 0; i <= window.radius; ++i) {
    window.weights[i] = float(std::exp(-0.5 * i * i / (sigma * sigma)));
    sum += (i ? 2 : 1) * window.weights[i];
    squares += (i ? 2 : 1) * double(window.weights[i]) * window.weights[i];
  }
  window.noise_factor = float(squares * squares / (sum * sum));
  return window;
}

}  // namespace

PlaneField::Planes::Planes(cv::Size size) {
  if (size.empty()) return;
  for (cv::Mat* plane : {&d, &a, &b, &a_prior, &b_prior, &offset, &gain, &sigma, &correlation})
    *plane = cv::Mat::zeros(size, CV_32F);
  gain.setTo(1);
}

planes::Field PlaneField::Planes::view() {
  return {d.ptr<float>(),
          a.ptr<float>(),
          b.ptr<float>(),
          a_prior.ptr<float>(),
          b_prior.ptr<float>(),
          offset.ptr<float>(),
          gain.ptr<float>(),
          sigma.ptr<float>(),
          correlation.ptr<float>(),
          d.cols,
          d.rows,
          int(d.step1())};
}

PlaneField::PlaneField(const MatchImages& images, const planes::Kernel& kernel)
    : images_(images.rows()), kernel_(kernel) {}

void PlaneField::setPriors() {
  // Prior of the slopes: smoothed central differences of d, except across jumps.
  cv::Mat &d = now_.d, &a = now_.a_prior, &b = now_.b_prior;
  const auto slope = [](float before, float after, int blocks) {
    const float s = (after - before) / float(planes::kBlock * std::max(blocks, 1));
    return std::abs(s) < 1.0f ? s : 0.0f;
  };
  for (int y = 0; y < d.rows; ++y) {
    const int up = std::max(y - 1, 0), down = std::min(y + 1, d.rows - 1);
    for (int x = 0; x < d.cols; ++x) {
      const int before = std::max(x - 1, 0), after = std::min(x + 1, d.cols - 1);
      a.at<float>(y, x) = slope(d.at<float>(y, before), d.at<float>(y, after), after - before);
      b.at<float>(y, x) = slope(d.at<float>(up, x), d.at<float>(down, x), down - up);
    }
  }
  cv::blur(a, a, {3, 3});
  cv::blur(b, b, {3, 3});
}

void PlaneField::start(const cv::Mat& blocks) {
  now_ = Planes(blocks.size());
  next_ = Planes(blocks.size());
  FACENAV_EXPECT(blocks.cols == (images_.width + 3) / 4 && blocks.rows == (images_.height + 3) / 4,
                 "a block for each 4 x 4 pixels");
  blocks.copyTo(now_.d);
  setPriors();
  now_.a_prior.copyTo(now_.a);
  now_.b_prior.copyTo(now_.b);
  run(4.0, false);
  std::swap(now_.offset, next_.offset);
  std::swap(now_.gain, next_.gain);
}

void PlaneField::run(double window_sigma_px, bool is_fit) {
  const planes::Window window = windowOf(window_sigma_px);
  const planes::Field from = now_.view(), to = next_.view();
  // The number of strips does not change a strip's result, so there are as many as threads.
  const int strips = stripsFor(from.rows);
  parallelRanges(0, strips, [&](int begin, int end) {
    std::vector<float> scratch(std::size_t(planes::scratchSize(from.columns)));
    for (int i = begin; i < end; ++i)
      kernel_.step(images_, from, window, is_fit, from.rows * i / strips, from.rows * (i + 1) / strips,
                   scratch.data(), to);
  });
}

void PlaneField::step(double window_sigma_px) {
  run(window_sigma_px, true);
  std::swap(now_, next_);
  setPriors();
}

bool PlaneField::isAccepted(int x, int y, const MatchOptions& options) const {
  return now_.correlation.at<float>(y, x) >= float(options.least_correlation) &&
         std::abs(now_.a.at<float>(y, x)) <= float(options.largest_slope) &&
         std::abs(now_.b.at<float>(y, x)) <= float(options.largest_slope) &&
         now_.sigma.at<float>(y, x) <= float(options.largest_sigma_px);
}

// Sets a plane to the mean of the accepted neighbours' planes, if they agree.
void PlaneField::carryOn(int x, int y, const cv::Mat& accepted) {
  constexpr int kFewest = 2;
  constexpr float kLargestSpread_px = 2.0f;
  float d = 0, a = 0, b = 0, offset = 0, gain = 0, least = 0, most = 0;
  int count = 0;
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, accepted.rows - 1); ++v)
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, accepted.cols - 1); ++u) {
      if (!accepted.at<std::uint8_t>(v, u)) continue;
      const float slope_x = now_.a.at<float>(v, u), slope_y = now_.b.at<float>(v, u);
      const float carried =
          now_.d.at<float>(v, u) + float(planes::kBlock) * (slope_x * float(x - u) + slope_y * float(y - v));
      least = count ? std::min(least, carried) : carried;
      most = count ? std::max(most, carried) : carried;
      d += carried;
      a += slope_x;
      b += slope_y;
      offset += now_.offset.at<float>(v, u);
      gain += now_.gain.at<float>(v, u);
      ++count;
    }
  if (count < kFewest || !(most - least < kLargestSpread_px)) return;
  const float share = 1.0f / float(count);
  now_.d.at<float>(y, x) = d * share;
  now_.a.at<float>(y, x) = a * share;
  now_.b.at<float>(y, x) = b * share;
  now_.offset.at<float>(y, x) = offset * share;
  now_.gain.at<float>(y, x) = gain * share;
}

void PlaneField::grow(double window_sigma_px, const MatchOptions& options) {
  cv::Mat accepted(now_.d.size(), CV_8U);
  for (int y = 0; y < accepted.rows; ++y)
    for (int x = 0; x < accepted.cols; ++x) accepted.at<std::uint8_t>(y, x) = isAccepted(x, y, options);
  for (int y = 0; y < accepted.rows; ++y)
    for (int x = 0; x < accepted.cols; ++x)
      if (!accepted.at<std::uint8_t>(y, x)) carryOn(x, y, accepted);
  setPriors();
  step(window_sigma_px);
}

cv::Mat PlaneField::nodes() const {
  const planes::Field view = now_.view();
  cv::Mat out((images_.height + 1) / 2, (images_.width + 1) / 2, CV_32F);
  const int width = planes::kBlock * view.columns;
  std::vector<float> scratch(2 * std::size_t(view.columns) + 8), rows(2 * std::size_t(width));
  for (int y = 0; y < out.rows; ++y) {
    const float *above = rows.data(), *below = above + width;
    for (int k = 0; k < 2; ++k) kernel_.pixel_row(view, 2 * y + k, scratch.data(), rows.data() + k * width);
    for (int x = 0; x < out.cols; ++x)
      out.at<float>(y, x) = 0.25f * (above[2 * x] + above[2 * x + 1] + below[2 * x] + below[2 * x + 1]);
  }
  return out;
}

DisparityMap PlaneField::map(const MatchOptions& options) const {
  constexpr float kLargestStep_px = 2.5f;  // between neighbouring blocks of one surface
  const int blocks = options.smallest_patch_px / (planes::kBlock * planes::kBlock);
  cv::Mat accepted = now_.d.clone();
  for (int y = 0; y < accepted.rows; ++y)
    for (int x = 0; x < accepted.cols; ++x)
      if (!isAccepted(x, y, options)) accepted.at<float>(y, x) = std::numeric_limits<float>::quiet_NaN();
  removeSpeckles(accepted, blocks, kLargestStep_px);
  DisparityMap map;
  for (cv::Mat* image : {&map.disparity_px, &map.slope_x, &map.slope_y, &map.sigma_px})
    image->create(images_.height, images_.width, CV_32F);
  const planes::Field view = now_.view();
  parallelRanges(0, images_.height, [&](int begin, int end) {
    std::vector<float> scratch(2 * std::size_t(view.columns) + 8),
        row(std::size_t(planes::kBlock) * view.columns);
    for (int y = begin; y < end; ++y) {
      kernel_.pixel_row(view, y, scratch.data(), row.data());
      const planes::Output out{map.disparity_px.ptr<float>(y), map.slope_x.ptr<float>(y),
                               map.slope_y.ptr<float>(y), map.sigma_px.ptr<float>(y)};
      kernel_.map_row(view, accepted.ptr<float>(y / planes::kBlock), y, images_.left_first[y],
                      images_.left_end[y], images_.width, row.data(), out);
    }
  });
  return map;
}

}  // namespace facenav::stereo
