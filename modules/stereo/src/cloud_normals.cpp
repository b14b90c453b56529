#include "cloud_normals.h"

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <opencv2/core/utility.hpp>

namespace facenav::stereo {
namespace {

constexpr int kRadius_px = 5;
constexpr int kFewest = 20;              // disparities in the disk
constexpr float kSameSurface_px = 1.0f;  // plus the slope's share

struct DisparityPlane {
  double d, a, b;  // at the pixel, along x, along y
};

bool fitPlane(const cv::Mat& disparity, int x0, int y0, DisparityPlane& plane) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d rhs = Eigen::Vector3d::Zero();
  const float centre = disparity.at<float>(y0, x0);
  for (int v = -kRadius_px; v <= kRadius_px; ++v) {
    const int y = y0 + v;
    if (y < 0 || y >= disparity.rows) continue;
    const float* row = disparity.ptr<float>(y);
    for (int u = -kRadius_px; u <= kRadius_px; ++u) {
      if (u * u + v * v > kRadius_px * kRadius_px || x0 + u < 0 || x0 + u >= disparity.cols) continue;
      const float difference = row[x0 + u] - centre;
      if (!(std::abs(difference) < kSameSurface_px + 0.5f * float(std::abs(u) + std::abs(v)))) continue;
      const Eigen::Vector3d term(1, u, v);
      normal += term * term.transpose();
      rhs += term * double(difference);
    }
  }
  if (normal(0, 0) < kFewest) return false;
  const Eigen::Vector3d solution = normal.ldlt().solve(rhs);
  plane = {centre + solution[0], solution[1], solution[2]};
  return solution.allFinite();
}

}  // namespace

cv::Mat diskNormals(const Rectification& r, const DisparityMap& map) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  cv::Mat normals(map.disparity_px.size(), CV_32FC3, cv::Scalar(nan, nan, nan));
  cv::parallel_for_({0, normals.rows}, [&](const cv::Range& rows) {
    for (int y = rows.start; y < rows.end; ++y)
      for (int x = 0; x < normals.cols; ++x) {
        DisparityPlane plane;
        if (std::isnan(map.disparity_px.at<float>(y, x)) || !fitPlane(map.disparity_px, x, y, plane))
          continue;
        // f B / z = d + a (x' - x) + b (y' - y) with x' = f X / z + cx: multiplied by z, a plane in X, Y, z.
        const double along_z =
            plane.d - r.offset_px() - plane.a * (x - r.cx_left_px) - plane.b * (y - r.cy_px);
        Eigen::Vector3d n = -Eigen::Vector3d(plane.a * r.f_px, plane.b * r.f_px, along_z).normalized();
        const Eigen::Vector3d ray((x - r.cx_left_px) / r.f_px, (y - r.cy_px) / r.f_px, 1);
        if (n.dot(ray) > 0) n = -n;
        normals.at<cv::Vec3f>(y, x) = {float(n.x()), float(n.y()), float(n.z())};
      }
  });
  return normals;
}

}  // namespace facenav::stereo
