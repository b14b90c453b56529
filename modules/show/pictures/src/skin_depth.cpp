#include "skin_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace facenav::pictures {
namespace {

constexpr double kNearest_mm = 10.0, kFarthest_px = 20000.0;

double cross2(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace

SkinDepth::SkinDepth(const surface::TriangleMesh& mesh, const Eigen::Isometry3d& view_T_mri,
                     const cameras::CameraModel& lens, const cv::Size& size_px, int step)
    : step_(step),
      inverse_depth_(cv::Mat::zeros(size_px.height / step + 1, size_px.width / step + 1, CV_32F)) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& vertex_mm : mesh.vertices_mm) {
    points_mm_.push_back(view_T_mri * vertex_mm);
    Eigen::Vector2d px(nan, nan);
    if (points_mm_.back().z() > kNearest_mm) px = cameras::project(lens, points_mm_.back());
    if (!(px.cwiseAbs().maxCoeff() < kFarthest_px)) px.setConstant(nan);
    pixels_.push_back(px);
  }
  for (const auto& triangle : mesh.triangles) draw(triangle);
}

/// Draws a triangle; 1 / depth is linear over its picture.
void SkinDepth::draw(const Eigen::Vector3i& triangle) {
  Eigen::Vector2d at[3];
  double inverse[3];
  for (int i = 0; i < 3; ++i) {
    at[i] = pixels_[std::size_t(triangle[i])] / step_;
    inverse[i] = 1.0 / points_mm_[std::size_t(triangle[i])].z();
    if (!at[i].allFinite()) return;
  }
  const double area = cross2(at[1] - at[0], at[2] - at[0]);
  if (area == 0) return;
  const int left = std::max(0, int(std::ceil(std::min({at[0].x(), at[1].x(), at[2].x()})))),
            right = std::min(inverse_depth_.cols - 1, int(std::max({at[0].x(), at[1].x(), at[2].x()}))),
            top = std::max(0, int(std::ceil(std::min({at[0].y(), at[1].y(), at[2].y()})))),
            bottom = std::min(inverse_depth_.rows - 1, int(std::max({at[0].y(), at[1].y(), at[2].y()})));
  for (int v = top; v <= bottom; ++v) {
    float* row = inverse_depth_.ptr<float>(v);
    for (int u = left; u <= right; ++u) {
      const Eigen::Vector2d p(u, v);
      const double b = cross2(p - at[0], at[2] - at[0]) / area, c = cross2(at[1] - at[0], p - at[0]) / area;
      if (b < 0 || c < 0 || b + c > 1) continue;
      row[u] = std::max(row[u], float((1 - b - c) * inverse[0] + b * inverse[1] + c * inverse[2]));
    }
  }
}

bool SkinDepth::isOpen(const Eigen::Vector2d& pixel, double depth_mm, double slack_mm) const {
  const int u = int(std::lround(pixel.x() / step_)), v = int(std::lround(pixel.y() / step_));
  if (u < 0 || v < 0 || u >= inverse_depth_.cols || v >= inverse_depth_.rows) return true;
  const float inverse = inverse_depth_.at<float>(v, u);
  return inverse <= 0 || 1.0 / inverse > depth_mm - slack_mm;
}

}  // namespace facenav::pictures
