#pragma once
// FaceRecovery: a face that was lost is found anew, and known for the patient's or another's. Slower than the
// tracker's own search (some 0.1 s a frame) and surer on real skin: it searches wide windows of skin in
// place of linearised patches, from the last pose, from landmarks and from the face's shape alone, and
// decides on identity by likelihood. It works beside the frames (core/later_answer.h). In: a pair, and where
// the head was last. Out: pose with covariance and identity; the looks of the moment.

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

/// Whether both pictures show the face at one pose.
enum class SidesVerdict {
  agree,
  out_of_step,  // each shows it, at poses that differ: the pictures are of two moments, or a camera has moved
  one_camera,   // one does not show it
};

struct RecoveredFace {
  RecoveryPose pose;
  SidesVerdict sides = SidesVerdict::agree;  // by each camera's own pose
  EpipolarOffset lines;                      // of the skin in both pictures
  Identity identity;
  std::shared_ptr<const RecoveryPictures> pictures;  // of the pair that was asked about
  bool is_face_seen = false;                         // by the face detector, there
  std::shared_ptr<const SkinView> then;              // what the pose was fitted to
};

class FaceRecovery {
 public:
  /// `face`: as found in the reference, where it was.
  FaceRecovery(const cameras::StereoRig& rig, const cameras::StereoFrame& reference, const FaceRegion& region,
               const FaceSurface& surface, const std::optional<face::StereoFace>& face,
               std::shared_ptr<const face::FaceDetector> detector);

  /// The likeliest pose of the patient's face in the pair; nothing where no start led to one. Its identity
  /// says whether it may be used. `last`: where the head was seen last; `is_thorough`: faces are looked for
  /// at any roll, in place of the reference's.
  std::optional<RecoveredFace> find(const cameras::StereoFrame& frame,
                                    const std::optional<Eigen::Isometry3d>& last, bool is_thorough) const;
  /// One of the pose's covariances, of increments about another point (Head, mm).
  Matrix6d carried(const RecoveryPose& pose, const Matrix6d& covariance,
                   const Eigen::Vector3d& centre_mm) const;
  /// The face as it looks where it was found: searched for, too, from now on. Not while find() runs.
  void remember(const RecoveredFace& found, const cameras::StereoFrame& frame);
  /// A look that is known from elsewhere. Not while find() runs.
  void add(const FaceKeyFrame& look);
  /// What was remembered and rests on the reference alone, not on another look.
  std::vector<FaceKeyFrame> learnt() const;
  /// What was remembered since the reference is in doubt.
  void forgetRemembered();

 private:
  struct Remembered {
    std::shared_ptr<const SkinView> view;
    std::optional<FaceKeyFrame> learnt;  // here, against the reference
    bool is_from_elsewhere = false;
  };
  void add(Remembered look);
  SidesVerdict sidesOf(const RecoveredFace& found) const;
  RecoveredFace tryFrom(const cameras::StereoFrame& frame, const std::shared_ptr<const RecoveryPictures>& now,
                        const Eigen::Isometry3d& start) const;

  cameras::StereoRig rig_;
  SkinPoints points_;
  FaceShape shape_;
  std::shared_ptr<const SkinView> reference_;
  std::vector<Remembered> remembered_;
  std::vector<Eigen::Vector3d> landmarks_mm_;  // of the reference, Head; may be empty
  double roll_rad_ = 0.0;                      // at which its face was found
  std::shared_ptr<const face::FaceDetector> detector_;
};

}  // namespace facenav::head_tracking
