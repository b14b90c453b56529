#pragma once
// UprightImage: a reduced copy of an image in which a leaning face is upright; the detectors search it.

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace facenav::face {

struct UprightImage {
  cv::Mat image;
  cv::Matx23d upright_from_image, image_from_upright;  // pixels to pixels
};

/// Turns an 8-bit grey image by -roll_rad and scales it.
UprightImage makeUpright(const cv::Mat& grey, double roll_rad, double scale);

/// Applies an affine map to a pixel.
Eigen::Vector2d apply(const cv::Matx23d& map, const Eigen::Vector2d& px);

/// A rectangle of that centre and size, rounded to pixels.
cv::Rect aroundCentre(const Eigen::Vector2d& centre, double width, double height);

/// Centre of a rectangle, px.
Eigen::Vector2d centreOf(const cv::Rect& box);

}  // namespace facenav::face
