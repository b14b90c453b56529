#include "skin_under.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace facenav::pictures {
namespace {

constexpr int kSide = int(2 * SkinUnder::kReach_mm / SkinUnder::kCell_mm) + 1;

double turned(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Draws a triangle's depth, linear over it; keeps the outermost skin.
void layTriangle(const Eigen::Vector3d corners[3], cv::Mat& depth_mm) {
  Eigen::Vector2d at[3];
  for (int i = 0; i < 3; ++i)
    at[i] = (corners[i].head<2>().array() + SkinUnder::kReach_mm) / SkinUnder::kCell_mm;
  const double area = turned(at[1] - at[0], at[2] - at[0]);
  if (area == 0) return;
  const auto low = [&](int axis) {
    return std::max(0, int(std::ceil(std::min({at[0][axis], at[1][axis], at[2][axis]}))));
  };
  const auto high = [&](int axis) {
    return std::min(kSide - 1, int(std::floor(std::max({at[0][axis], at[1][axis], at[2][axis]}))));
  };
  for (int v = low(1); v <= high(1); ++v)
    for (int u = low(0); u <= high(0); ++u) {
      const Eigen::Vector2d p(u, v);
      const double b = turned(p - at[0], at[2] - at[0]) / area, c = turned(at[1] - at[0], p - at[0]) / area;
      if (b < 0 || c < 0 || b + c > 1) continue;
      const float z = float((1 - b - c) * corners[0].z() + b * corners[1].z() + c * corners[2].z());
      float& depth = depth_mm.at<float>(v, u);
      if (!(depth <= z)) depth = z;
    }
}

}  // namespace

SkinUnder::SkinUnder(const surface::TriangleMesh& skin, const Eigen::Isometry3d& plane_T_mri)
    : depth_mm_(kSide, kSide, CV_32F, cv::Scalar(std::numeric_limits<float>::quiet_NaN())) {
  std::vector<Eigen::Vector3d> points_mm;
  for (const auto& vertex_mm : skin.vertices_mm) points_mm.push_back(plane_T_mri * vertex_mm);
  for (const auto& t : skin.triangles) {
    const Eigen::Vector3d corners[3] = {points_mm[std::size_t(t[0])], points_mm[std::size_t(t[1])],
                                        points_mm[std::size_t(t[2])]};
    const bool faces_plane = (corners[1] - corners[0]).cross(corners[2] - corners[0]).z() < 0;
    if (faces_plane) layTriangle(corners, depth_mm_);
  }
}

std::optional<double> SkinUnder::depth_mm(double x_mm, double y_mm) const {
  const double x = (x_mm + kReach_mm) / kCell_mm, y = (y_mm + kReach_mm) / kCell_mm;
  const int u = int(std::floor(x)), v = int(std::floor(y));
  if (u < 0 || v < 0 || u + 1 >= kSide || v + 1 >= kSide) return std::nullopt;
  const double a = x - u, b = y - v;
  const double depth = (1 - b) * ((1 - a) * depth_mm_.at<float>(v, u) + a * depth_mm_.at<float>(v, u + 1)) +
                       b * ((1 - a) * depth_mm_.at<float>(v + 1, u) + a * depth_mm_.at<float>(v + 1, u + 1));
  return std::isfinite(depth) ? std::optional(depth) : std::nullopt;
}

}  // namespace facenav::pictures
