#include <opencv2/core/utility.hpp>

#include "disparity_filter.h"
#include "disparity_search.h"
#include "facenav/core/error.h"
#include "matchers.h"
#include "subpixel_kernel.h"

namespace facenav::stereo {
namespace {

class SsdMatcher : public DenseMatcher {
 public:
  DisparityMap match(const Rectification& rectification, const RectifiedPair& pair,
                     const MatchOptions& options) const override {
    const cv::Mat whole = searchDisparities(rectification, pair, options.window_px);
    return withoutSpeckles(fitSubpixel(rectification, pair, options, whole), options.smallest_patch_px);
  }

 private:
  static DisparityMap fitSubpixel(const Rectification& rectification, const RectifiedPair& pair,
                                  const MatchOptions& options, const cv::Mat& whole) {
    static_assert(kFineSteps == 4, "subpixel_kernel.inl counts on it");
    const cv::Mat &left_mask = rectification.left_mask, &right_mask = rectification.right_mask;
    const subpixel::Images images{pair.left.ptr<float>(), pair.right_fine.ptr<float>(),
                                  left_mask.data,         right_mask.data,
                                  int(pair.left.step1()), int(pair.right_fine.step1()),
                                  int(left_mask.step1()), int(right_mask.step1()),
                                  pair.left.cols,         pair.left.rows,
                                  right_mask.cols,        rectification.disparities,
                                  options.window_px};
    const subpixel::Limits limits{float(options.largest_sigma_px), float(options.least_correlation),
                                  float(options.largest_slope)};
    DisparityMap map;
    for (cv::Mat* image : {&map.disparity_px, &map.slope_x, &map.slope_y, &map.sigma_px})
      image->create(pair.left.size(), CV_32F);
    const auto fit = cv::checkHardwareSupport(CV_CPU_AVX2) ? subpixel::fitRowAvx2 : subpixel::fitRowBase;
    cv::parallel_for_({0, whole.rows}, [&](const cv::Range& rows) {
      for (int y = rows.start; y < rows.end; ++y)
        fit(images, limits, y,
            {whole.ptr<std::int16_t>(y), map.disparity_px.ptr<float>(y), map.slope_x.ptr<float>(y),
             map.slope_y.ptr<float>(y), map.sigma_px.ptr<float>(y)});
    });
    return map;
  }
};

}  // namespace

std::unique_ptr<DenseMatcher> makeSsdMatcher() { return std::make_unique<SsdMatcher>(); }

}  // namespace facenav::stereo
