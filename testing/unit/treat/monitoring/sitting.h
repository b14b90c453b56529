#pragma once
// A portrait on a head-like surface before two cameras, aligned to itself: Mri = Camera at the reference.

#include <filesystem>
#include <map>

#include "facenav/geometry/rotation.h"
#include "facenav/monitoring/drift_check.h"
#include "support/synthetic_face.h"

namespace facenav::monitoring::sitting {

using facenav::testing::SyntheticFace;
using facenav::testing::SyntheticView;

/// The surface seen by the reference, as a mesh: its points lie on every second pixel.
inline registration::SkinModel skinOf(const head_tracking::HeadReference& reference) {
  registration::SkinModel skin;
  skin.points.points_mm = reference.surface.points_mm;
  skin.points.normals.assign(skin.points.points_mm.size(), -Eigen::Vector3d::UnitZ());
  std::map<std::pair<int, int>, int> at;
  for (std::size_t i = 0; i < reference.surface_left_px.size(); ++i)
    at[{int(reference.surface_left_px[i].x()) / 2, int(reference.surface_left_px[i].y()) / 2}] = int(i);
  for (const auto& [px, a] : at) {
    const auto b = at.find({px.first + 1, px.second}), c = at.find({px.first, px.second + 1}),
               d = at.find({px.first + 1, px.second + 1});
    if (b == at.end() || c == at.end() || d == at.end()) continue;
    skin.triangles.emplace_back(a, c->second, b->second);
    skin.triangles.emplace_back(b->second, c->second, d->second);
    const auto& p = skin.points.points_mm;
    const Eigen::Vector3d outward =
        (p[std::size_t(c->second)] - p[std::size_t(a)]).cross(p[std::size_t(b->second)] - p[std::size_t(a)]);
    skin.points.normals[std::size_t(a)] = outward.normalized();
  }
  return skin;
}

/// A portrait on a head-like surface. Its MRI frame is the camera's frame at the reference.
class Sitting {
 public:
  Sitting() : face_(SyntheticFace::astronaut()), reference_(face_.reference(rig_, true)) {
    scalp_ = std::make_shared<const registration::ScalpField>(skinOf(reference_));
    check_ = std::make_shared<const DriftCheck>(rig_, scalp_, reference_, RigidTransform<Camera, Mri>());
    for (const auto& p : reference_.surface.points_mm)
      centre_mm_ += p / double(reference_.surface.points_mm.size());
  }
  static const Sitting& shared() {
    static const Sitting sitting;
    return sitting;
  }
  cameras::StereoFrame render(SyntheticView view) const { return face_.render(rig_, view); }
  /// A rotation (rotation vector, degrees) about the face's centre, and a shift.
  Eigen::Isometry3d about(const Eigen::Vector3d& turn_deg, const Eigen::Vector3d& shift_mm) const {
    Vector6d xi;
    xi << turn_deg * kRadPerDeg, shift_mm;
    return Eigen::Translation3d(centre_mm_) * expRigid(xi) * Eigen::Translation3d(-centre_mm_);
  }
  DriftFinding measure(const cameras::StereoFrame& frame, const Eigen::Isometry3d& pose) const {
    return check_->measure(frame, RigidTransform<Camera, Mri>::fromIsometry(pose));
  }

  /// Finding for a reference picture that shows the head as in `view`, while its surface was aligned unmoved.
  DriftFinding atReference(const SyntheticView& view) const {
    head_tracking::HeadReference moved = reference_;
    moved.frame = render(view);
    return DriftCheck(rig_, scalp_, moved, RigidTransform<Camera, Mri>()).atReference();
  }

  const cameras::StereoRig& rig() const { return rig_; }
  const std::shared_ptr<const registration::ScalpField>& scalp() const { return scalp_; }
  const Eigen::Vector3d& centre_mm() const { return centre_mm_; }

 private:
  cameras::StereoRig rig_ = facenav::testing::faceRig();
  SyntheticFace face_;
  head_tracking::HeadReference reference_;
  std::shared_ptr<const registration::ScalpField> scalp_;
  std::shared_ptr<const DriftCheck> check_;
  Eigen::Vector3d centre_mm_ = Eigen::Vector3d::Zero();
};

inline bool hasPortrait() { return std::filesystem::exists(SyntheticFace::portraitPath()); }

}  // namespace facenav::monitoring::sitting
