#include "facenav/session/face_memory.h"

namespace facenav::session {
namespace {

// Standard error per axis of one alignment, at the face. Larger is safer: key frames of earlier sessions then
// weigh less. Evidence: resources/doc/evidence.md.
constexpr double kAlignment_mm = 0.3, kAlignment_rad = 0.003;

}  // namespace

std::vector<head_tracking::FaceKeyFrame> asTracked(const std::vector<casefile::StoredKeyFrame>& key_frames,
                                                   const RigidTransform<Head, Mri>& head_T_mri) {
  Vector6d sigma;
  sigma << Eigen::Vector3d::Constant(kAlignment_rad), Eigen::Vector3d::Constant(kAlignment_mm);
  const Matrix6d of_two_alignments = 2.0 * Matrix6d(sigma.cwiseAbs2().asDiagonal());
  std::vector<head_tracking::FaceKeyFrame> tracked;
  for (const auto& look : key_frames) {
    head_tracking::FaceKeyFrame t;
    t.rig = look.rig;
    t.frame = look.frame;
    t.camera_T_head = (look.camera_T_mri * head_T_mri.inverse()).isometry();
    t.covariance = look.covariance, t.between_sessions = of_two_alignments;
    tracked.push_back(std::move(t));
  }
  return tracked;
}

std::vector<casefile::StoredKeyFrame> asKept(const std::vector<head_tracking::FaceKeyFrame>& key_frames,
                                             const RigidTransform<Head, Mri>& head_T_mri) {
  std::vector<casefile::StoredKeyFrame> kept;
  for (const auto& look : key_frames) {
    casefile::StoredKeyFrame k;
    k.rig = look.rig;
    k.frame = look.frame;
    k.camera_T_mri = RigidTransform<Camera, Head>::fromIsometry(look.camera_T_head) * head_T_mri;
    k.covariance = look.covariance;
    kept.push_back(std::move(k));
  }
  return kept;
}

}  // namespace facenav::session
