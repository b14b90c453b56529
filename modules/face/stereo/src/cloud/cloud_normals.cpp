#include "cloud_normals.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/core/utility.hpp>

#include "facenav/core/parallel_for.h"

namespace facenav::stereo {
namespace {

constexpr int kRadius_px = 5;
constexpr int kHalfWidth_px[kRadius_px + 1] = {5, 4, 4, 4, 3, 0};  // half widths of the disk's rows
constexpr int kFewest = 20;                                        // disparities in the disk
constexpr float kSameSurface_px = 1.0f;                            // plus the slope's share of the difference

struct DisparityPlane {
  double d, a, b;  // disparity at the pixel, slopes along x and y
};

// Least squares over the disk from sums: n, u, v, uu, uv, vv on the left, those with the disparity on the
// right.
bool fitPlane(const cv::Mat& disparity, int x0, int y0, DisparityPlane& plane) {
  float n = 0, su = 0, sv = 0, suu = 0, suv = 0, svv = 0, sd = 0, sud = 0, svd = 0;
  const float centre = disparity.at<float>(y0, x0);
  for (int v = std::max(-kRadius_px, -y0); v <= std::min(kRadius_px, disparity.rows - 1 - y0); ++v) {
    const float* row = disparity.ptr<float>(y0 + v) + x0;
    const int reach = kHalfWidth_px[std::abs(v)];
    float m = 0, mu = 0, muu = 0, md = 0, mud = 0;  // sums of this row
    for (int u = std::max(-reach, -x0); u <= std::min(reach, disparity.cols - 1 - x0); ++u) {
      const float difference = row[u] - centre;
      const bool is_same = std::abs(difference) < kSameSurface_px + 0.5f * float(std::abs(u) + std::abs(v));
      const float w = is_same ? 1.0f : 0.0f, d = is_same ? difference : 0.0f;
      m += w;
      mu += w * float(u);
      muu += w * float(u * u);
      md += d;
      mud += d * float(u);
    }
    n += m;
    su += mu;
    suu += muu;
    sv += float(v) * m;
    suv += float(v) * mu;
    svv += float(v * v) * m;
    sd += md;
    sud += mud;
    svd += float(v) * md;
  }
  if (n < kFewest) return false;
  Eigen::Matrix3f normal;
  normal << n, su, sv, su, suu, suv, sv, suv, svv;
  const Eigen::Vector3f solution = normal.inverse() * Eigen::Vector3f(sd, sud, svd);
  plane = {centre + solution[0], solution[1], solution[2]};
  return solution.allFinite();
}

}  // namespace

cv::Mat diskNormals(const Rectification& r, const DisparityMap& map) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  cv::Mat normals(map.disparity_px.size(), CV_32FC3, cv::Scalar(nan, nan, nan));
  parallelRanges(0, normals.rows, [&](int begin, int end) {
    for (int y = begin; y < end; ++y)
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
