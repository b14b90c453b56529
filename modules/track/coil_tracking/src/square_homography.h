#pragma once
// The projective map from the printed square to the image, in closed form (Heckbert 1989, "Fundamentals of
// Texture Mapping", section 2.2.3), and bilinear grey values.

#include <Eigen/Core>
#include <Eigen/LU>
#include <array>
#include <opencv2/core.hpp>

namespace facenav::coil_tracking {

class SquareHomography {
 public:
  /// `quad`: image of the corners (-.5,-.5), (.5,-.5), (.5,.5), (-.5,.5) of the print.
  explicit SquareHomography(const std::array<Eigen::Vector2d, 4>& quad) {
    const Eigen::Vector2d s = quad[0] - quad[1] + quad[2] - quad[3];
    Eigen::Matrix2d d;
    d << quad[1] - quad[2], quad[3] - quad[2];
    const Eigen::Vector2d gh = d.inverse() * s;
    h_ << quad[1] - quad[0] + gh.x() * quad[1], quad[3] - quad[0] + gh.y() * quad[3], quad[0], gh.x(), gh.y(),
        1.0;
  }
  /// Pixel of a point of the print, -.5..+.5 inside the square.
  Eigen::Vector2d operator()(double x, double y) const {
    const Eigen::Vector3d p = h_ * Eigen::Vector3d(x + 0.5, y + 0.5, 1.0);
    return p.hnormalized();
  }

 private:
  Eigen::Matrix3d h_;
};

/// True if bilinear interpolation at p needs only pixels of the image.
inline bool isInside(const cv::Mat& grey, double x, double y) {
  return x >= 0 && y >= 0 && x < grey.cols - 1 && y < grey.rows - 1;
}
inline double bilinear(const cv::Mat& grey, double x, double y) {
  const int i = int(x), j = int(y);
  const double fx = x - i, fy = y - j;
  const uchar *row = grey.ptr<uchar>(j) + i, *below = grey.ptr<uchar>(j + 1) + i;
  return (1 - fy) * ((1 - fx) * row[0] + fx * row[1]) + fy * ((1 - fx) * below[0] + fx * below[1]);
}

}  // namespace facenav::coil_tracking
