#pragma once
// OpenCV's semi-global matcher as a DenseMatcher: a peer to compare our matchers with. Needs
// modules/face/stereo/src on the include path.

#include <limits>
#include <opencv2/calib3d.hpp>

#include "matchers/disparity_filter.h"

namespace facenav::testing {

/// StereoSGBM, 5 directions, 5 x 5 windows, with the parameters that its documentation suggests.
class SgbmMatcher : public stereo::DenseMatcher {
 public:
  stereo::DisparityMap match(const stereo::Rectification& rectification, const stereo::RectifiedPair& pair,
                             const stereo::MatchOptions& options) const override {
    const int disparities = (rectification.disparities + 15) / 16 * 16, side = 5;
    cv::Mat left, right, sixteenths;
    // The right image is wider by `disparities`: widen the left one by as much, so that columns agree.
    cv::copyMakeBorder(pair.left, left, 0, 0, rectification.disparities, 0, cv::BORDER_REPLICATE);
    left.convertTo(left, CV_8U);
    pair.right.convertTo(right, CV_8U);
    const auto sgbm = cv::StereoSGBM::create(0, disparities, side, 8 * side * side, 32 * side * side, 1, 31,
                                             5, 0, 0, cv::StereoSGBM::MODE_SGBM);
    sgbm->compute(left, right, sixteenths);
    sixteenths = sixteenths.colRange(rectification.disparities, sixteenths.cols);
    stereo::DisparityMap map;
    sixteenths.convertTo(map.disparity_px, CV_32F, 1.0 / 16);
    map.disparity_px.setTo(std::numeric_limits<float>::quiet_NaN(), sixteenths < 0);
    map.disparity_px.setTo(std::numeric_limits<float>::quiet_NaN(), rectification.left_mask == 0);
    constexpr double kMeasured_px = 0.155;  // rms on dots; SGBM itself predicts none
    map.sigma_px = cv::Mat(map.disparity_px.size(), CV_32F, cv::Scalar(kMeasured_px));
    return stereo::withoutSpeckles(map, options.smallest_patch_px);
  }
};

}  // namespace facenav::testing
