#pragma once
// EdgeProfile: where a black/white edge lies across a predicted line, to a few hundredths of a pixel.

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <optional>

namespace facenav::tracking {

struct EdgePoint {
  double offset_px;  // from the predicted point along `into_black`
  double contrast;   // grey levels, > 0
};

/// Samples grey values across the edge at `at` over +-`half_px` along the unit vector `into_black` and
/// returns the centroid of the grey gradient: the place of the equivalent sharp step, whatever the
/// (symmetric) blur. Nothing where the profile leaves the image or does not fall from white to black by
/// `least_contrast`.
std::optional<EdgePoint> locateEdge(const cv::Mat& grey, const Eigen::Vector2d& at,
                                    const Eigen::Vector2d& into_black, double half_px, double least_contrast);

}  // namespace facenav::tracking
