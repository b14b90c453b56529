#pragma once
// CameraDrift: a camera that moves on its mount during a session. The tracked face determines the right
// camera's pose relative to the left one in all six axes, compared with the reference (RightPoseObservation).
// The frames are fused by a Kalman filter of a random walk. Errors that last over the frames (light,
// expression, the error of a key frame) do not become smaller by it and are added.
//
// A motion within its error changes nothing. A motion beyond three standard errors is corrected: the session
// tracks with `right_T_left()` from then on. If it is not known well enough for that, or is too large to
// trust, `fault()` reports it and no pose may be shown.
//
// A key frame made after the camera moved shows the moved camera as if nothing had happened. So each key
// frame is stored with the motion that was known, but not yet corrected, when it was made, and with its
// error.

#include <map>
#include <optional>
#include <string>

#include "facenav/cameras/stereo_rig.h"
#include "facenav/core/timestamp.h"
#include "facenav/health/observation.h"
#include "facenav/health/rig_state.h"

namespace facenav::health {

/// A motion of the right camera that is known and corrected.
struct CorrectedMotion {
  double turn_deg = 0.0;
};
/// One line, with advice: "a camera has moved on its mount since the alignment (0.12 deg): corrected ..".
std::string inWords(const CorrectedMotion& motion);

class CameraDrift {
 public:
  explicit CameraDrift(const cameras::StereoRig& rig) : calibrated_(rig.right_T_left) {}

  /// Adds one tracked frame, which was tracked with right_T_left() as of the frame before.
  void add(const RigObservation& seen);
  /// Adds a frame without the face: a camera that has moved may move on unseen.
  void addWithoutFace(Timestamp captured);

  /// Pose of the right camera: as calibrated, or as corrected.
  RigidTransform<RightCamera, Camera> right_T_left() const;
  /// Standard error of the direction of right_T_left() while a motion is followed, plus the lag of the
  /// correction; 0 while nothing has moved.
  double turnSigma_rad() const;
  /// Reason why no pose can be trusted; nullopt: the cameras have not moved, or their motion is known and
  /// corrected.
  std::optional<RigVerdict> fault() const;
  /// The motion that is corrected; nullopt if none is.
  std::optional<CorrectedMotion> correction() const;

  /// Estimated motion of the right camera since the reference: (rad, mm), in its own frame.
  const Vector6d& moved() const { return moved_; }
  const Matrix6d& covariance() const { return certainty_; }
  /// Squared distance from zero of the motion that is not corrected, in its own standard errors (6 degrees of
  /// freedom).
  double statistic() const { return statistic_; }

 private:
  struct KeyFrame {
    Vector6d left_over = Vector6d::Zero();  // motion that was known and not corrected when it was made
    Matrix6d covariance = Matrix6d::Zero();
  };
  void predict(double since_s);
  void update(const Vector6d& seen, const Matrix6d& frame, const Matrix6d& key);
  void judge(const RightPoseObservation& seen, const Point<Camera>& face_centre, double since_s);

  RigidTransform<RightCamera, Camera> calibrated_;
  Vector6d moved_ = Vector6d::Zero(), corrected_ = Vector6d::Zero();
  Matrix6d covariance_ = Matrix6d::Zero();  // of the filter
  Matrix6d certainty_ = Matrix6d::Zero();   // plus the errors common to all frames, and of the key frame
  int contradicted_ = 0;                    // contradicting frames in a row
  bool is_followed_ = false, is_unseen_ = false;
  std::map<int, KeyFrame> keys_;
  std::optional<Timestamp> last_;
  bool has_moved_ = false;
  double statistic_ = 0.0, effect_mm_ = 0.0, effect_sigma_mm_ = 0.0;  // of the pose at the cortex
};

}  // namespace facenav::health
