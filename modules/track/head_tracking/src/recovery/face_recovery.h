#pragma once
// FaceRecovery: finds a lost face again and decides by likelihood whether it is the patient's. It is slower
// than the tracker's own search (some 0.1 s a frame) and more reliable on real skin: it searches wide windows
// of skin instead of linearised patches. It starts from the last pose, from landmarks, and from the face's
// shape alone. It runs in parallel with the frames (core/later_answer.h). In: a stereo pair and the head's
// last pose. Out: pose with covariance and identity, and the images it was found in.

#include <memory>
#include <optional>
#include <vector>

#include "face_shape.h"
#include "facenav/face/stereo_face.h"
#include "facenav/head_tracking/face_key_frame.h"
#include "identity.h"
#include "recovery_pose.h"
#include "sides.h"
#include "skin_points.h"

namespace facenav::head_tracking {

/// Comparison of the face's poses in both images.
enum class SidesVerdict {
  agree,
  out_of_step,  // the poses in the two images differ: two moments, or a moved camera
  one_camera,   // one image does not show the face
};

struct RecoveredFace {
  RecoveryPose pose;  // covariance: that of the fit, divided by the share of windows in place
  SidesVerdict sides = SidesVerdict::agree;  // from the pose in each camera alone
  EpipolarOffset lines;                      // of the skin found in both images
  Identity identity;
  std::shared_ptr<const RecoveryPictures> pictures;  // the searched pair
  bool is_face_seen = false;                         // the face detector found a face there
  std::shared_ptr<const SkinView> then;              // the key frame that the pose was fitted to
};

class FaceRecovery {
 public:
  /// `face`: the landmarks found in the reference, if any.
  FaceRecovery(const cameras::StereoRig& rig, const cameras::StereoFrame& reference, const FaceRegion& region,
               const FaceSurface& surface, const std::optional<face::StereoFace>& face,
               std::shared_ptr<const face::FaceDetector> detector);

  /// The likeliest pose of the patient's face in the pair; empty if no start led to one. Its identity decides
  /// whether it may be used. `last`: the head's last known pose. `is_thorough`: the face detector searches
  /// all roll angles, not only that of the reference.
  std::optional<RecoveredFace> find(const cameras::StereoFrame& frame,
                                    const std::optional<Eigen::Isometry3d>& last, bool is_thorough) const;
  /// Sets the right camera's pose for later frames. Not while find() runs.
  void moveRight(const RigidTransform<RightCamera, Camera>& right_T_left) {
    rig_.right_T_left = right_T_left;
  }
  /// A covariance of the pose, converted to increments about another point (Head, mm).
  Matrix6d carried(const RecoveryPose& pose, const Matrix6d& covariance,
                   const Eigen::Vector3d& centre_mm) const;
  /// Adds the found face as a key frame for later searches. Not while find() runs.
  void remember(const RecoveredFace& found, const cameras::StereoFrame& frame);
  /// Adds a key frame from another source. Not while find() runs.
  void add(const FaceKeyFrame& key);
  /// Key frames found in this session that depend on the reference alone, not on another key frame.
  std::vector<FaceKeyFrame> learnt() const;
  /// Removes all key frames but the reference, those of earlier sessions too, because they are in doubt.
  void forgetRemembered();

 private:
  struct Remembered {
    std::shared_ptr<const SkinView> view;
    std::optional<FaceKeyFrame> learnt;  // a key frame that was matched to the reference
  };
  void add(Remembered key);
  SidesVerdict sidesOf(const RecoveredFace& found) const;
  RecoveredFace tryFrom(const std::shared_ptr<const RecoveryPictures>& now,
                        const Eigen::Isometry3d& start) const;

  cameras::StereoRig rig_;
  SkinPoints points_;
  FaceShape shape_;
  std::shared_ptr<const SkinView> reference_;
  std::vector<Remembered> remembered_;
  std::vector<Eigen::Vector3d> landmarks_mm_;  // landmarks of the reference, Head; may be empty
  double roll_rad_ = 0.0;                      // roll of the face in the reference
  std::shared_ptr<const face::FaceDetector> detector_;
};

}  // namespace facenav::head_tracking
