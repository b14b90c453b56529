#include "upright_image.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

namespace facenav::face {
namespace {

// Maps image pixels to pixels of a copy in which a face with roll `roll_rad` is upright.
cv::Matx23d uprightFromImage(const cv::Size& size, double roll_rad, double scale) {
  const double c = scale * std::cos(roll_rad), s = scale * std::sin(roll_rad);
  const double half = 0.5 * scale * std::hypot(size.width, size.height);
  const bool is_upright = roll_rad == 0.0;
  const double cx = is_upright ? 0.5 * scale * (size.width - 1) : half;
  const double cy = is_upright ? 0.5 * scale * (size.height - 1) : half;
  const double mx = 0.5 * (size.width - 1), my = 0.5 * (size.height - 1);
  return {c, s, cx - c * mx - s * my, -s, c, cy + s * mx - c * my};
}

}  // namespace

Eigen::Vector2d apply(const cv::Matx23d& m, const Eigen::Vector2d& p) {
  return {m(0, 0) * p.x() + m(0, 1) * p.y() + m(0, 2), m(1, 0) * p.x() + m(1, 1) * p.y() + m(1, 2)};
}

cv::Rect aroundCentre(const Eigen::Vector2d& centre, double width, double height) {
  return {static_cast<int>(std::lround(centre.x() - width / 2)),
          static_cast<int>(std::lround(centre.y() - height / 2)), static_cast<int>(std::lround(width)),
          static_cast<int>(std::lround(height))};
}

Eigen::Vector2d centreOf(const cv::Rect& box) {
  return {box.x + 0.5 * (box.width - 1), box.y + 0.5 * (box.height - 1)};
}

UprightImage makeUpright(const cv::Mat& grey, double roll_rad, double scale) {
  UprightImage upright;
  upright.upright_from_image = uprightFromImage(grey.size(), roll_rad, scale);
  const double diagonal = scale * std::hypot(grey.cols, grey.rows);
  const cv::Size size = roll_rad == 0.0
                            ? cv::Size(std::lround(scale * grey.cols), std::lround(scale * grey.rows))
                            : cv::Size(std::lround(diagonal), std::lround(diagonal));
  if (roll_rad == 0.0)
    cv::resize(grey, upright.image, size, 0, 0, scale < 1 ? cv::INTER_AREA : cv::INTER_LINEAR);
  else
    cv::warpAffine(grey, upright.image, upright.upright_from_image, size, cv::INTER_LINEAR);
  cv::invertAffineTransform(upright.upright_from_image, upright.image_from_upright);
  return upright;
}

}  // namespace facenav::face
