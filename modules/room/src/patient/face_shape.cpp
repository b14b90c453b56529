#include "face_shape.h"

#include <algorithm>
#include <cmath>

namespace facenav::room {
namespace {

double smoothStep(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

/// Shift of a skin point for 1 mm of jaw: full at the chin, none above the mouth line or beyond the cheeks;
/// the mouth corners are drawn in a little.
Eigen::Vector3d shiftPerJaw(const Eigen::Vector3d& p_mm, const std::vector<Eigen::Vector3d>& landmarks_mm) {
  const Eigen::Vector3d mouth_mm = 0.5 * (landmarks_mm[62] + landmarks_mm[66]), &chin_mm = landmarks_mm[8];
  const double below = (mouth_mm.z() - p_mm.z()) / std::max(10.0, mouth_mm.z() - chin_mm.z());
  const double aside = std::abs(p_mm.x() - mouth_mm.x()) / 55.0, behind = (mouth_mm.y() - p_mm.y()) / 75.0;
  const double jaw = smoothStep(3.0 * below) * (1.0 - smoothStep(aside * aside)) * (1.0 - smoothStep(behind));
  Eigen::Vector3d shift = jaw * Eigen::Vector3d(0.0, -0.25, -1.0);
  for (const int corner : {48, 54}) {
    const double near =
        std::exp(-(p_mm - landmarks_mm[std::size_t(corner)]).squaredNorm() / (2.0 * 12.0 * 12.0));
    shift.x() += 0.25 * near * (mouth_mm.x() > landmarks_mm[std::size_t(corner)].x() ? 1.0 : -1.0);
  }
  return shift;
}

}  // namespace

FaceShape::FaceShape(const VirtualPatient& patient)
    : patient_(patient), vertices_mm_(patient.visible.vertices_mm), normals_(patient.visible.normals) {
  if (patient.landmarks68_mm.empty()) return;
  per_jaw_mm_.assign(vertices_mm_.size(), Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < vertices_mm_.size(); ++i) {
    per_jaw_mm_[i] = shiftPerJaw(patient.skin.vertices_mm[i], patient.landmarks68_mm);
    if (per_jaw_mm_[i].norm() > 1e-3) moving_vertices_.push_back(int(i));
  }
  const auto moves = [&](int vertex) { return per_jaw_mm_[std::size_t(vertex)].norm() > 1e-3; };
  for (std::size_t t = 0; t < patient.visible.triangles.size(); ++t) {
    const auto& corners = patient.visible.triangles[t];
    if (!moves(corners[0]) && !moves(corners[1]) && !moves(corners[2])) continue;
    moving_triangles_.push_back(int(t));
    for (int corner = 0; corner < 3; ++corner)
      if (moves(corners[corner])) touched_vertices_.push_back(corners[corner]);
  }
  std::sort(touched_vertices_.begin(), touched_vertices_.end());
  touched_vertices_.erase(std::unique(touched_vertices_.begin(), touched_vertices_.end()),
                          touched_vertices_.end());
}

bool FaceShape::set(double jaw_mm, double lids) {
  lids_ = lids;
  if (jaw_mm == jaw_mm_ || per_jaw_mm_.empty()) return false;
  jaw_mm_ = jaw_mm;
  for (const int i : moving_vertices_)
    vertices_mm_[std::size_t(i)] =
        patient_.visible.vertices_mm[std::size_t(i)] + jaw_mm * per_jaw_mm_[std::size_t(i)];
  for (const int i : touched_vertices_) normals_[std::size_t(i)].setZero();
  for (const int t : moving_triangles_) {
    const auto& c = patient_.visible.triangles[std::size_t(t)];
    const Eigen::Vector3d& a = vertices_mm_[std::size_t(c[0])];
    const Eigen::Vector3d facet =
        (vertices_mm_[std::size_t(c[1])] - a).cross(vertices_mm_[std::size_t(c[2])] - a);
    for (int corner = 0; corner < 3; ++corner)
      if (per_jaw_mm_[std::size_t(c[corner])].norm() > 1e-3) normals_[std::size_t(c[corner])] += facet;
  }
  for (const int i : touched_vertices_) normals_[std::size_t(i)].normalize();
  return true;
}

Eigen::Vector3d FaceShape::shift_mm(int triangle, float u, float v) const {
  const auto& c = patient_.visible.triangles[std::size_t(triangle)];
  return jaw_mm_ * ((1.0 - u - v) * per_jaw_mm_[std::size_t(c[0])] +
                    double(u) * per_jaw_mm_[std::size_t(c[1])] + double(v) * per_jaw_mm_[std::size_t(c[2])]);
}

}  // namespace facenav::room
