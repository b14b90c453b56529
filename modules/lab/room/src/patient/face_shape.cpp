#include "face_shape.h"

#include <algorithm>
#include <cmath>

#include "smooth_step.h"

namespace facenav::room {
namespace {

/// Shift of a skin point per mm of jaw: full at the chin, none above the mouth line or beyond the cheeks; the
/// mouth corners move in slightly.
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

bool FaceShape::set(double jaw_mm, double lids, const Expression& expression, const HairPose& hair) {
  lids_ = lids;
  const bool was_deformed = isDeformed(), has_face = !per_jaw_mm_.empty();
  const HairPose before = hair_;
  hair_ = hair;
  const bool is_hair_new = !(hair.isAtRest() && before.isAtRest()) && !(hair == before);
  if (!is_hair_new && ((jaw_mm == jaw_mm_ && expression == expression_) || !has_face)) return false;
  if (has_face) jaw_mm_ = jaw_mm, expression_ = expression;
  if (was_deformed || isDeformed()) {
    deform();
    return true;
  }
  for (const int i : moving_vertices_)
    vertices_mm_[std::size_t(i)] =
        patient_.visible.vertices_mm[std::size_t(i)] + jaw_mm * per_jaw_mm_[std::size_t(i)];
  renewNormals(touched_vertices_, moving_triangles_,
               [&](int vertex) { return per_jaw_mm_[std::size_t(vertex)].norm() > 1e-3; });
  return true;
}

void FaceShape::renewNormals(const std::vector<int>& vertices, const std::vector<int>& triangles,
                             const std::function<bool(int)>& moves) {
  for (const int i : vertices) normals_[std::size_t(i)].setZero();
  for (const int t : triangles) {
    const auto& c = patient_.visible.triangles[std::size_t(t)];
    const Eigen::Vector3d& a = vertices_mm_[std::size_t(c[0])];
    const Eigen::Vector3d facet =
        (vertices_mm_[std::size_t(c[1])] - a).cross(vertices_mm_[std::size_t(c[2])] - a);
    for (int corner = 0; corner < 3; ++corner)
      if (moves(c[corner])) normals_[std::size_t(c[corner])] += facet;
  }
  for (const int i : vertices) normals_[std::size_t(i)].normalize();
}

FaceShape::Region FaceShape::movingRegion() const {
  // Limits of the head's front that contains all grimaces, the jaw and all hair.
  constexpr double kReach_mm = 130.0, kBehind_mm = 90.0;
  const Eigen::Vector3d& middle = patient_.face_middle.mm;
  const bool has_face = !per_jaw_mm_.empty();
  Region region;
  std::vector<bool> is_inside(vertices_mm_.size());
  for (std::size_t i = 0; i < vertices_mm_.size(); ++i) {
    const Eigen::Vector3d& p = patient_.skin.vertices_mm[i];
    is_inside[i] = hair_weight_[i] > 0.0 || (has_face && per_jaw_mm_[i].norm() > 1e-3) ||
                   (has_face && (p - middle).norm() < kReach_mm && p.y() > middle.y() - kBehind_mm);
    if (is_inside[i]) region.vertices.push_back(int(i));
  }
  for (std::size_t t = 0; t < patient_.visible.triangles.size(); ++t) {
    const auto& c = patient_.visible.triangles[t];
    if (is_inside[std::size_t(c[0])] || is_inside[std::size_t(c[1])] || is_inside[std::size_t(c[2])])
      region.triangles.push_back(int(t));
  }
  return region;
}

void FaceShape::prepareRegion() {
  constexpr double kFull_mm = 3.0;  // hair at this height above the skin moves freely
  hair_weight_.assign(vertices_mm_.size(), 0.0);
  for (std::size_t i = 0; i < vertices_mm_.size(); ++i)
    hair_weight_[i] =
        smoothStep((patient_.visible.vertices_mm[i] - patient_.skin.vertices_mm[i]).norm() / kFull_mm);
  region_ = movingRegion();
  shift_mm_.assign(vertices_mm_.size(), Eigen::Vector3d::Zero());
  is_in_region_.assign(vertices_mm_.size(), false);
  for (const int i : region_.vertices) is_in_region_[std::size_t(i)] = true;
}

void FaceShape::deform() {
  if (region_.vertices.empty()) prepareRegion();
  const double jaw_mm = jaw_mm_ + jawOf_mm(expression_);
  const bool has_face = !per_jaw_mm_.empty();
  for (const int vertex : region_.vertices) {
    const auto i = std::size_t(vertex);
    const Eigen::Vector3d &p_mm = patient_.skin.vertices_mm[i], &normal = patient_.skin.normals[i];
    shift_mm_[i].setZero();
    if (has_face)
      shift_mm_[i] =
          jaw_mm * per_jaw_mm_[i] + expressionShift_mm(expression_, p_mm, normal, patient_.landmarks68_mm);
    if (hair_weight_[i] > 0.0) shift_mm_[i] += hair_weight_[i] * hairShift_mm(hair_, p_mm, normal);
    vertices_mm_[i] = patient_.visible.vertices_mm[i] + shift_mm_[i];
  }
  renewNormals(region_.vertices, region_.triangles,
               [this](int vertex) { return bool(is_in_region_[std::size_t(vertex)]); });
}

Eigen::Vector3d FaceShape::shift_mm(int triangle, float u, float v) const {
  const auto& c = patient_.visible.triangles[std::size_t(triangle)];
  const auto mixed = [&](const std::vector<Eigen::Vector3d>& of) -> Eigen::Vector3d {
    return (1.0 - u - v) * of[std::size_t(c[0])] + double(u) * of[std::size_t(c[1])] +
           double(v) * of[std::size_t(c[2])];
  };
  return isDeformed() ? mixed(shift_mm_) : Eigen::Vector3d(jaw_mm_ * mixed(per_jaw_mm_));
}

}  // namespace facenav::room
