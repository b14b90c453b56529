#pragma once
// SkinPoints: the reference's skin as some hundred points with their place in both reference images, and
// their search in a later pair. A window around each point is warped by the point's plane to a predicted
// pose, and searched by normalised cross-correlation in the image of the same camera. The tracking patches
// (patch_model.h) are narrow and linearised. These windows are wide (some 8 mm of skin) and searched, so most
// of them keep their place under compression, other light and another expression. In: the reference pair with
// its surface. Out: displacements (px) with covariance, for recovery's pose.

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

/// Both images of a pair at full, half and quarter size, slightly smoothed; 32-bit float.
struct RecoveryPictures {
  static constexpr int kLevels = 3;
  std::array<std::array<cv::Mat1f, 2>, kLevels> level;  // [level][camera]

  RecoveryPictures() = default;
  explicit RecoveryPictures(const cameras::StereoFrame& frame);
};

struct SkinPoint {
  Eigen::Vector3d mm, normal;  // Head; the normal is unit and points towards the cameras
  double mobility_mm = 1.0;    // standard deviation of the skin's motion over the bone
  int region = 0;              // cell of the face's box, below SkinPoints::regionCount()
  int part = 0;                // SkinPart::number
};

/// One point found in one camera.
struct SkinMatch {
  int point = 0, camera = 0;
  Eigen::Vector2d px = Eigen::Vector2d::Zero();              // place in the image, full resolution
  Eigen::Vector2d offset_px = Eigen::Vector2d::Zero();       // from the place that the pose predicts
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();  // of offset_px, px^2
  Eigen::Matrix<double, 2, 6> jacobian;  // d(px) / d(xi), xi = (w, v) about the points' centre, Head
  double correlation = 0.0;              // at the best place
};

/// Covariance of a match's offset, px^2: error of the window, and motion of the skin over the bone with
/// standard deviation `mobility_mm`.
Eigen::Matrix2d errorOf(const SkinMatch& match, double mobility_mm);

struct SkinSearch {
  int level = 0;
  int reach_px = 4;  // pixels of the level, to each side
  int every = 1;     // uses every n-th point
};

/// The face in one stereo pair, with its pose there.
struct SkinView {
  cameras::StereoRig rig;
  RecoveryPictures pictures;
  Eigen::Isometry3d camera_T_head = Eigen::Isometry3d::Identity();
  Matrix6d covariance = Matrix6d::Zero();        // of that pose, as in HeadPose; zero for the reference
  Matrix6d between_sessions = Matrix6d::Zero();  // as in FaceKeyFrame
};

class SkinPoints {
 public:
  SkinPoints() = default;
  /// `region`: the face in the reference; `surface`: its depth; `mobility`: of its parts.
  SkinPoints(const cameras::StereoRig& rig, const cameras::StereoFrame& reference, const FaceRegion& region,
             const FaceSurface& surface, const SkinMobility& mobility);

  std::size_t size() const { return points_.size(); }
  const SkinPoint& operator[](std::size_t i) const { return points_[i]; }
  const Eigen::Vector3d& centre_mm() const { return centre_mm_; }
  int regionCount() const;
  /// Half the side of a window at full resolution, px.
  int halfWindow_px() const { return half_window_px_; }
  /// Share of the windows whose values are independent: neighbours overlap, and both cameras see one skin.
  double independentShare() const { return independent_share_; }
  /// The reference pair.
  const SkinView& reference() const { return reference_; }

  /// Searches every point that is visible both in `then` and at `camera_T_head`, around its predicted place.
  /// Omits points with the best place at the edge of the search, and ambiguous ones.
  std::vector<SkinMatch> find(const SkinView& then, const cameras::StereoRig& rig,
                              const RecoveryPictures& now, const Eigen::Isometry3d& camera_T_head,
                              const SkinSearch& search) const;
  /// True if point `i` is visible in camera `c` of `then`, and of the rig at `camera_T_head`.
  bool isSeen(std::size_t i, int c, const SkinView& then, const cameras::StereoRig& rig,
              const Eigen::Isometry3d& camera_T_head) const;
  /// The pair with everything black except the face seen at `camera_T_head`.
  cameras::StereoFrame faceOnly(const cameras::StereoFrame& frame, const cameras::StereoRig& rig,
                                const Eigen::Isometry3d& camera_T_head) const;

 private:
  SkinView reference_;
  std::vector<SkinPoint> points_;
  Eigen::Vector3d centre_mm_ = Eigen::Vector3d::Zero();
  int half_window_px_ = 10;  // at full resolution
  double independent_share_ = 0.25;
};

}  // namespace facenav::head_tracking
