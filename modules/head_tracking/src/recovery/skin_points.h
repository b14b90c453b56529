#pragma once
// SkinPoints: the reference's skin as some hundred points with their place in both reference pictures, and
// where each lies in a later pair. A window round each point is warped as the point's plane is seen at a
// predicted pose, and searched by normalised cross-correlation in the picture of the same camera. Unlike the
// patches that track (patch_model.h) the windows are wide (some 8 mm of skin) and are searched, not
// linearised: compression, other light and another expression leave most of them their place.
// In: the reference pair with its surface. Out: displacements (px) with covariance, for recovery's pose.

#include <Eigen/Geometry>
#include <array>
#include <opencv2/core.hpp>
#include <vector>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/geometry/rotation.h"
#include "head/face_region.h"
#include "head/face_surface.h"
#include "skin_mobility.h"

namespace facenav::head_tracking {

/// Both pictures of a pair at full, half and quarter size, slightly smoothed; 32-bit float.
struct RecoveryPictures {
  static constexpr int kLevels = 3;
  std::array<std::array<cv::Mat1f, 2>, kLevels> level;  // [level][camera]

  RecoveryPictures() = default;
  explicit RecoveryPictures(const cameras::StereoFrame& frame);
};

struct SkinPoint {
  Eigen::Vector3d mm, normal;  // Head; the normal is unit and points towards the cameras
  double mobility_mm = 1.0;    // standard deviation of the skin's motion over the bone
  int region = 0;              // cell of the face's box, of SkinPoints::regionCount()
  int part = 0;                // SkinPart's number
};

/// One point found in one camera.
struct SkinMatch {
  int point = 0, camera = 0;
  Eigen::Vector2d px = Eigen::Vector2d::Zero();              // where it was found, full resolution
  Eigen::Vector2d offset_px = Eigen::Vector2d::Zero();       // of that from where the pose puts it
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();  // of that, px^2
  Eigen::Matrix<double, 2, 6> jacobian;  // d(px) / d(xi), xi = (w, v) about the points' centre, Head
  double correlation = 0.0;              // of the window at the best place
};

/// Covariance of a match's offset, px^2: of its window, and of skin that moves over the bone by
/// `mobility_mm`.
Eigen::Matrix2d errorOf(const SkinMatch& match, double mobility_mm);

struct SkinSearch {
  int level = 0;
  int reach_px = 4;  // of the level, to each side
  int every = 1;     // of the points
};

/// The face as one pair of pictures showed it, with the pose it had there.
struct SkinView {
  cameras::StereoRig rig;
  RecoveryPictures pictures;
  Eigen::Isometry3d camera_T_head = Eigen::Isometry3d::Identity();
  Matrix6d covariance = Matrix6d::Zero();        // of that pose, HeadPose's; zero for the reference
  Matrix6d between_sessions = Matrix6d::Zero();  // FaceKeyFrame's
};

class SkinPoints {
 public:
  SkinPoints() = default;
  /// `region`: where the reference's face is face; `surface`: its depth; `mobility`: of its parts.
  SkinPoints(const cameras::StereoRig& rig, const cameras::StereoFrame& reference, const FaceRegion& region,
             const FaceSurface& surface, const SkinMobility& mobility);

  std::size_t size() const { return points_.size(); }
  const SkinPoint& operator[](std::size_t i) const { return points_[i]; }
  const Eigen::Vector3d& centre_mm() const { return centre_mm_; }
  int regionCount() const;
  /// Half the side of a window at full resolution, px.
  int halfWindow_px() const { return half_window_px_; }
  /// The reference's pictures.
  const SkinView& reference() const { return reference_; }

  /// Every point that both `then` and a camera at `camera_T_head` see, searched round its predicted place.
  /// Points whose best place lies at the edge of the search, or looks like anything, are not found.
  std::vector<SkinMatch> find(const SkinView& then, const cameras::StereoRig& rig,
                              const RecoveryPictures& now, const Eigen::Isometry3d& camera_T_head,
                              const SkinSearch& search) const;
  /// Whether point `i` shows in camera `c` of `then` and of the rig at `camera_T_head`.
  bool isSeen(std::size_t i, int c, const SkinView& then, const cameras::StereoRig& rig,
              const Eigen::Isometry3d& camera_T_head) const;
  /// The pair with all but the face, seen at `camera_T_head`, black.
  cameras::StereoFrame faceOnly(const cameras::StereoFrame& frame, const cameras::StereoRig& rig,
                                const Eigen::Isometry3d& camera_T_head) const;

 private:
  SkinView reference_;
  std::vector<SkinPoint> points_;
  Eigen::Vector3d centre_mm_ = Eigen::Vector3d::Zero();
  int half_window_px_ = 10;  // at full resolution
};

}  // namespace facenav::head_tracking
