#pragma once
// CameraDrift: a camera that moves on its mount during a session. The face that is tracked shows how the
// right camera stands to the left one in all six axes, against the moment of the reference
// (RightPoseObservation). The frames are fused by a Kalman filter of a random walk. What lasts over the
// frames (light, expression, the error of a key frame) does not become smaller by it and is added.
//
// Nothing changes while the motion is within its error. Motion that is beyond three standard errors is
// corrected: the session tracks with `right_T_left()` from then on. Where it is not known well enough for
// that, and where it is too large to trust, `fault()` says so and no pose may be shown.
//
// A key frame made after the camera moved shows the moved camera as if nothing had happened. So each key
// frame counts with the motion that was known, and not yet corrected, when it was made, and with its error.

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

  /// One tracked frame. It was tracked with right_T_left() as of the frame before.
  void add(const RigObservation& seen);
  /// A frame without the face: a camera that has moved may move on unseen.
  void addWithoutFace(Timestamp captured);

  /// How the cameras stand: as calibrated, or as corrected.
  RigidTransform<RightCamera, Camera> right_T_left() const;
  /// Standard error of the direction of right_T_left() while a motion is followed, and what the correction
  /// lags behind; 0 while nothing has moved.
  double turnSigma_rad() const;
  /// Why no pose can be trusted; empty: the cameras stand still, or their motion is known and corrected.
  std::optional<RigVerdict> fault() const;
  /// The motion that is corrected; empty: none is.
  std::optional<CorrectedMotion> correction() const;

  /// As estimated since the reference: (rad, mm) of the right camera, in its own frame.
  const Vector6d& moved() const { return moved_; }
  const Matrix6d& covariance() const { return certainty_; }
  /// Squared distance of the motion that is not corrected from zero, in its own standard errors (6 degrees of
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
  Matrix6d certainty_ = Matrix6d::Zero();   // and what all frames, and the key frame, have in common
  int contradicted_ = 0;                    // frames in a row
  bool is_followed_ = false, is_unseen_ = false;
  std::map<int, KeyFrame> keys_;
  std::optional<Timestamp> last_;
  bool has_moved_ = false;
  double statistic_ = 0.0, effect_mm_ = 0.0, effect_sigma_mm_ = 0.0;  // of the pose at the cortex
};

}  // namespace facenav::health
