#include "head/face_surface.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "facenav/core/robust_statistics.h"
#include "facenav/geometry/normal_equations.h"
#include "passive_surface.h"

namespace facenav::head_tracking {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr std::size_t kMostPoints = 1200;  // points under one quadric; more do not improve its six numbers
constexpr double kRoughest_mm =
    2.0;  // rms of the points about the quadric; more: hair, an edge, two surfaces

Vector6 basis(const Eigen::Vector2d& d) {
  Vector6 b;
  b << 1, d.x(), d.y(), d.x() * d.x(), d.x() * d.y(), d.y() * d.y();
  return b;
}

}  // namespace

double LocalSurface::inverseDepth(const Eigen::Vector2d& px) const { return c.dot(basis(px - centre_px)); }

FaceSurface::FaceSurface(const std::vector<Eigen::Vector2f>& left_px, const std::vector<float>& depth_mm,
                         cv::Size size, double least_radius_px)
    : columns_(size.width / kCell_px + 1),
      rows_(size.height / kCell_px + 1),
      least_radius_px_(least_radius_px),
      cells_(columns_ * rows_) {
  for (std::size_t i = 0; i < left_px.size(); ++i) {
    const int x = int(left_px[i].x()) / kCell_px, y = int(left_px[i].y()) / kCell_px;
    if (left_px[i].x() < 0 || left_px[i].y() < 0 || x >= columns_ || y >= rows_ || !(depth_mm[i] > 0))
      continue;
    cells_[y * columns_ + x].push_back(int(px_.size()));
    px_.push_back(left_px[i]);
    inverse_depth_.push_back(1.f / depth_mm[i]);
  }
}

std::vector<int> FaceSurface::near(const Eigen::Vector2d& px, double radius_px) const {
  std::vector<int> found;
  const int x0 = std::max(0, int((px.x() - radius_px) / kCell_px)),
            x1 = std::min(columns_ - 1, int((px.x() + radius_px) / kCell_px));
  const int y0 = std::max(0, int((px.y() - radius_px) / kCell_px)),
            y1 = std::min(rows_ - 1, int((px.y() + radius_px) / kCell_px));
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x)
      for (int i : cells_[y * columns_ + x])
        if ((px_[i].cast<double>() - px).squaredNorm() <= radius_px * radius_px) found.push_back(i);
  const std::size_t every = found.size() / kMostPoints + 1;
  for (std::size_t i = 0; i * every < found.size(); ++i) found[i] = found[i * every];
  found.resize((found.size() + every - 1) / every);
  return found;
}

std::optional<LocalSurface> FaceSurface::around(const Eigen::Vector2d& px, double wanted_radius_px) const {
  const double radius_px = std::max(wanted_radius_px, least_radius_px_);
  const auto points = near(px, radius_px);
  if (points.size() < 12) return std::nullopt;
  LocalSurface surface;
  surface.centre_px = px;
  std::vector<double> weights(points.size(), 1.0), depths;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (int i : points) {
    mean += (px_[i].cast<double>() - px) / double(points.size());
    depths.push_back(inverse_depth_[i]);
  }
  if (mean.norm() > 0.45 * radius_px) return std::nullopt;
  surface.c(0) = upperMedian(depths);
  const double mm = 1.0 / (surface.c(0) * surface.c(0));  // d(depth) / d(inverse depth)
  double limit = 15.0 / mm;                               // first limit: 15 mm about the median
  for (int round = 0; round < 4; ++round) {
    Eigen::Matrix<double, 6, 6> h = Eigen::Matrix<double, 6, 6>::Zero();
    Vector6 g = Vector6::Zero();
    std::vector<double> errors;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Eigen::Vector2d d = (px_[points[k]].cast<double>() - px) / radius_px;
      const double error = inverse_depth_[points[k]] - surface.inverseDepth(px + d * radius_px);
      errors.push_back(std::abs(error));
      if (std::abs(error) >= limit) continue;
      const double inlying = 1 - error * error / (limit * limit);
      const Vector6 b = basis(d), weighted = inlying * inlying * b;
      h.noalias() += weighted * b.transpose();
      g += double(inverse_depth_[points[k]]) * weighted;
    }
    if (round == 3) {
      surface.rms_mm = kSigmaPerMad * upperMedian(errors) * mm;
      double squares = 0;
      for (double error : errors) squares += std::pow(std::min(error * mm, kRoughest_mm), 2);
      surface.roughness_mm = std::sqrt(squares / double(errors.size()));
      break;
    }
    Vector6 damping;
    damping << 0, 1e-3, 1e-3, 0.03, 0.03, 0.03;
    h.diagonal() += damping;
    Vector6 c = solveSymmetric(h, g);
    const double s = 1 / radius_px;
    surface.c << c(0), c(1) * s, c(2) * s, c(3) * s * s, c(4) * s * s, c(5) * s * s;
    limit = std::max(4.0 * kSigmaPerMad * upperMedian(errors), 0.3 / mm);
  }
  if (surface.rms_mm > kRoughest_mm || !(surface.c(0) > 0)) return std::nullopt;
  return surface;
}

FaceSurface measureSurface(const cameras::StereoRig& rig, const HeadReference& reference,
                           const FaceRegion& region, double start_depth_mm) {
  const cv::Size size(rig.width_px, rig.height_px);
  if (reference.surface.empty()) return passiveSurface(rig, reference.frame, region, start_depth_mm);
  std::vector<float> depth_mm;
  for (const auto& p : reference.surface.points_mm) depth_mm.push_back(float(p.z()));
  return FaceSurface(reference.surface_left_px, depth_mm, size);
}

}  // namespace facenav::head_tracking
