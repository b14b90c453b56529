#include "disparity_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgproc.hpp>

#include "disparity_filter.h"
#include "facenav/core/error.h"
#include "facenav/core/parallel_for.h"
#include "strips.h"

namespace facenav::stereo {
namespace {

field::Window windowOf(double sigma_px) {
  // The 2 x 2 pixels of a node are part of the window; their own variance is 1/4.
  const double sigma = std::sqrt(std::max(sigma_px * sigma_px - 0.25, 0.05)) / 2.0;
  field::Window window{std::clamp(int(std::ceil(2.5 * sigma)), 1, field::kLargestRadius), {}, 0};
  double sum = 0, squares = 0;
  for (int i = 0; i <= window.radius; ++i) {
    window.weights[i] = float(std::exp(-0.5 * i * i / (sigma * sigma)));
    sum += (i ? 2 : 1) * window.weights[i];
  }
  for (int i = 0; i <= window.radius; ++i) {
    window.weights[i] /= float(sum);
    squares += (i ? 2 : 1) * double(window.weights[i]) * window.weights[i];
  }
  window.independent = float(4.0 / (squares * squares));
  return window;
}

cv::Mat smoothed(const cv::Mat& plane, double sigma) {
  cv::Mat out;
  cv::GaussianBlur(plane, out, {}, sigma, sigma, cv::BORDER_REPLICATE);
  return out;
}

}  // namespace

DisparityField::DisparityField(const MatchImages& images)
    : images_(images.rows()),
      nodes_{(images_.width + 1) / 2, (images_.height + 1) / 2, (images_.width + 1) / 2},
      kernel_(field::kernel()) {}

void DisparityField::start(const cv::Mat& nodes) {
  FACENAV_EXPECT(nodes.cols == nodes_.columns && nodes.rows == nodes_.rows, "a node for each 2 x 2 pixels");
  disparity_ = nodes.clone();
}

void DisparityField::estimate(double window_sigma_px, cv::Mat& change, cv::Mat& sigma,
                              cv::Mat& correlation) const {
  for (cv::Mat* plane : {&change, &sigma, &correlation}) plane->create(nodes_.rows, nodes_.columns, CV_32F);
  const field::Window window = windowOf(window_sigma_px);
  const field::Step out{change.ptr<float>(), sigma.ptr<float>(), correlation.ptr<float>()};
  // The number of strips does not change a strip's result, so there are as many as threads.
  const int strips = stripsFor(nodes_.rows);
  parallelRanges(0, strips, [&](int begin, int end) {
    std::vector<float> scratch(std::size_t(field::scratchSize(nodes_.columns)));
    for (int i = begin; i < end; ++i)
      kernel_.step(images_, nodes_, disparity_.ptr<float>(), window, nodes_.rows * i / strips,
                   nodes_.rows * (i + 1) / strips, scratch.data(), out);
  });
}

void DisparityField::step(double window_sigma_px) {
  cv::Mat change;
  estimate(window_sigma_px, change, sigma_, correlation_);
  disparity_ += change;
}

void DisparityField::addDetail(double window_sigma_px) {
  cv::Mat change, sigma, correlation;
  estimate(window_sigma_px, change, sigma, correlation);
  cv::Mat ratio(change.size(), CV_32F);
  for (int i = 0; i < int(ratio.total()); ++i) {
    const float r = change.ptr<float>()[i] / sigma.ptr<float>()[i];
    ratio.ptr<float>()[i] = std::min(r * r, 100.0f);
  }
  ratio = smoothed(ratio, window_sigma_px / 2.0);
  cv::Mat added(change.size(), CV_32F);  // squared change by this step
  for (int i = 0; i < int(ratio.total()); ++i) {
    const float share = std::max(0.0f, 1.0f - 1.0f / std::max(ratio.ptr<float>()[i], 1e-6f));
    const float part = share * change.ptr<float>()[i];
    disparity_.ptr<float>()[i] += part;
    added.ptr<float>()[i] = part * part;
    float& s = sigma_.ptr<float>()[i];
    const float fine = sigma.ptr<float>()[i];
    s = std::sqrt(share * fine * fine + (1 - share) * s * s);
  }
  // If a smaller window still changes the surface, the next smaller ones would change it by about as much
  // again.
  constexpr float kRemaining = 3.0f;
  added = smoothed(added, window_sigma_px / 2.0);
  for (int i = 0; i < int(added.total()); ++i) {
    float& s = sigma_.ptr<float>()[i];
    s = std::sqrt(s * s + kRemaining * added.ptr<float>()[i]);
  }
}

DisparityMap DisparityField::map(const MatchOptions& options) const {
  constexpr float kLargestStep_px = 1.5f;  // between neighbouring nodes of one surface
  const float nan = std::numeric_limits<float>::quiet_NaN();
  cv::Mat accepted = disparity_.clone();
  for (int i = 0; i < int(accepted.total()); ++i)
    if (!(correlation_.ptr<float>()[i] >= float(options.least_correlation) &&
          sigma_.ptr<float>()[i] <= float(options.largest_sigma_px)))
      accepted.ptr<float>()[i] = nan;
  removeSpeckles(accepted, options.smallest_patch_px / 4, kLargestStep_px);
  DisparityMap map;
  for (cv::Mat* image : {&map.disparity_px, &map.slope_x, &map.slope_y, &map.sigma_px})
    image->create(images_.height, images_.width, CV_32F);
  const float steepest = float(options.largest_slope);
  parallelRanges(0, images_.height, [&](int begin, int end) {
    std::vector<float> scratch(4 * std::size_t(nodes_.columns));
    for (int y = begin; y < end; ++y) {
      float* d = map.disparity_px.ptr<float>(y);
      kernel_.pixel_row(nodes_, disparity_.ptr<float>(), y, images_.width, scratch.data(), d);
      const int row = y / 2, above = std::max(row - 1, 0), below = std::min(row + 1, nodes_.rows - 1);
      const float *here = disparity_.ptr<float>(row), *up = disparity_.ptr<float>(above),
                  *down = disparity_.ptr<float>(below), *s = sigma_.ptr<float>(row),
                  *b = accepted.ptr<float>(row);
      float *a_out = map.slope_x.ptr<float>(y), *b_out = map.slope_y.ptr<float>(y),
            *s_out = map.sigma_px.ptr<float>(y);
      const float across = 0.5f / float(std::max(below - above, 1));
      for (int x = 0; x < images_.width; ++x) {
        const int i = x / 2, before = std::max(i - 1, 0), after = std::min(i + 1, nodes_.columns - 1);
        a_out[x] = (here[after] - here[before]) * 0.5f / float(std::max(after - before, 1));
        b_out[x] = (down[i] - up[i]) * across;
        s_out[x] = s[i];
        const bool is_good = b[i] == b[i] && std::abs(a_out[x]) <= steepest &&
                             std::abs(b_out[x]) <= steepest && x >= images_.left_first[y] &&
                             x < images_.left_end[y] && d[x] >= 0;
        if (!is_good) d[x] = nan;
      }
    }
  });
  return map;
}

}  // namespace facenav::stereo
