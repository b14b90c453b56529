#include <array>
#include <cmath>
#include <deque>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgproc.hpp>

#include "disparity_search.h"
#include "facenav/core/error.h"
#include "facenav/core/parallel_for.h"
#include "matchers/disparity_filter.h"
#include "matchers/matchers.h"
#include "paper/subpixel_kernel.h"

namespace facenav::stereo {
namespace {

constexpr int kFineSteps = 4;  // samples per pixel along x; subpixel_kernel.inl depends on it

// Samples between the pixels by cubic interpolation; linear interpolation between these is then exact enough.
cv::Mat fineAlongRows(const cv::Mat& image) {
  cv::Mat places(image.rows, image.cols * kFineSteps, CV_32FC2), fine;
  for (int y = 0; y < places.rows; ++y)
    for (int x = 0; x < places.cols; ++x) places.at<cv::Vec2f>(y, x) = {float(x) / kFineSteps, float(y)};
  cv::remap(image, fine, places, cv::noArray(), cv::INTER_CUBIC, cv::BORDER_REPLICATE);
  return fine;
}

subpixel::Images imagesOf(const Rectification& rectification, const RectifiedPair& pair,
                          const cv::Mat& right_fine, int window_px) {
  const cv::Mat &left_mask = rectification.left_mask, &right_mask = rectification.right_mask;
  return {pair.left.ptr<float>(),
          right_fine.ptr<float>(),
          left_mask.data,
          right_mask.data,
          int(pair.left.step1()),
          int(right_fine.step1()),
          int(left_mask.step1()),
          int(right_mask.step1()),
          pair.left.cols,
          pair.left.rows,
          right_mask.cols,
          rectification.disparities,
          window_px};
}

DisparityMap emptyMap(const cv::Size& size) {
  DisparityMap map;
  for (cv::Mat* image : {&map.disparity_px, &map.slope_x, &map.slope_y, &map.sigma_px})
    image->create(size, CV_32F);
  return map;
}

subpixel::Field fieldOf(DisparityMap& map) {
  return {map.disparity_px.ptr<float>(), map.slope_x.ptr<float>(), map.slope_y.ptr<float>(),
          map.sigma_px.ptr<float>(), int(map.disparity_px.step1())};
}

class SubpixelStage {
 public:
  SubpixelStage(const Rectification& rectification, const RectifiedPair& pair, const MatchOptions& options)
      : right_fine_(fineAlongRows(pair.right)),
        images_(imagesOf(rectification, pair, right_fine_, options.window_px)),
        refined_window_px_(options.refined_window_px),
        limits_{float(options.largest_sigma_px), float(options.least_correlation),
                float(options.largest_slope), float(options.largest_lever_px),
                float(options.least_centre_texture)},
        kernel_(subpixel::kernel()) {}

  DisparityMap fit(const cv::Mat& whole) const {
    DisparityMap map = emptyMap(whole.size());
    const subpixel::Field field = fieldOf(map);
    parallelRanges(0, whole.rows, [&](int begin, int end) {
      for (int y = begin; y < end; ++y)
        kernel_.fit_row(images_, limits_, y, whole.ptr<std::int16_t>(y), field);
    });
    return map;
  }

  // Grows the surface over steep skin from its fitted part, each pixel starting from its neighbour's plane.
  // There the disparity changes by more than a pixel inside a window, and the whole-pixel search fails.
  DisparityMap grown(DisparityMap map) const {
    const subpixel::Field field = fieldOf(map);
    std::deque<cv::Point> front;
    for (int y = 0; y < images_.height; ++y)
      for (int x = 0; x < images_.width; ++x)
        if (!std::isnan(field.disparity[y * field.stride + x])) front.emplace_back(x, y);
    while (!front.empty()) {
      const cv::Point from = front.front();
      front.pop_front();
      for (const cv::Point step : {cv::Point(1, 0), cv::Point(-1, 0), cv::Point(0, 1), cv::Point(0, -1)})
        if (growInto(field, from, step)) front.push_back(from + step);
    }
    return map;
  }

  DisparityMap refined(DisparityMap seen) const {
    DisparityMap map = emptyMap(seen.disparity_px.size());
    const subpixel::Field from = fieldOf(seen), to = fieldOf(map);
    subpixel::Images images = images_;
    images.window = refined_window_px_;
    parallelRanges(0, images_.height, [&](int begin, int end) {
      for (int y = begin; y < end; ++y) kernel_.refine_row(images, limits_, y, from, to);
    });
    return map;
  }

 private:
  bool growInto(const subpixel::Field& field, const cv::Point& from, const cv::Point& step) const {
    const cv::Point at = from + step;
    if (at.x < 0 || at.y < 0 || at.x >= images_.width || at.y >= images_.height) return false;
    const int i = from.y * field.stride + from.x, to = at.y * field.stride + at.x;
    if (!std::isnan(field.disparity[to])) return false;
    const float a = field.slope_x[i], b = field.slope_y[i];
    const float carried = field.disparity[i] + a * float(step.x) + b * float(step.y);
    const subpixel::Fit fit = kernel_.fit_at(images_, limits_, at.x, at.y, {carried, a, b});
    constexpr float kLargestJump_px = 0.5f;  // difference from the neighbour's plane; more is another surface
    // This form also refuses a NaN fit, which would leave the pixel open and grow for ever.
    if (!fit.is_good || !(std::abs(fit.plane.d - carried) <= kLargestJump_px)) return false;
    field.disparity[to] = fit.plane.d;
    field.slope_x[to] = fit.plane.a;
    field.slope_y[to] = fit.plane.b;
    field.sigma[to] = fit.sigma;
    return true;
  }

  cv::Mat right_fine_;
  subpixel::Images images_;
  int refined_window_px_;
  subpixel::Limits limits_;
  subpixel::Kernel kernel_;
};

class SsdMatcher : public DenseMatcher {
 public:
  DisparityMap match(const Rectification& rectification, const RectifiedPair& pair,
                     const MatchOptions& options) const override {
    const SubpixelStage stage(rectification, pair, options);
    DisparityMap map = stage.fit(searchDisparities(rectification, pair, options.window_px));
    map = stage.grown(withoutSpeckles(std::move(map), options.smallest_patch_px));
    for (int i = 0; i < options.refinements; ++i) map = stage.refined(std::move(map));
    return map;
  }
};

}  // namespace

std::unique_ptr<DenseMatcher> makeSsdMatcher() { return std::make_unique<SsdMatcher>(); }

}  // namespace facenav::stereo
