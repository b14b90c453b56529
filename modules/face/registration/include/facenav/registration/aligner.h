#pragma once
// Aligner: fits the MRI's skin to the face cloud (paper, section 3, equation 1) and predicts the error of the
// fit. Data flow: ScalpField (of the ScalpSurface) + FaceCloud -> AlignmentResult (camera_T_mri at the time
// of capture).

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/core/error.h"
#include "facenav/core/task_monitor.h"
#include "facenav/geometry/rigid_transform.h"
#include "facenav/geometry/rotation.h"
#include "facenav/registration/pose_uncertainty.h"
#include "facenav/registration/scalp_field.h"

namespace facenav::registration {

/// Error of the cloud along the line of sight that neighbouring points share, caused by the texture available
/// to the matcher. Correlated over `reach_mm` (Matern 3/2). Part of it looks like another pose and is absent
/// from the residuals.
struct SightError {
  double sigma_mm = 0.0, reach_mm = 40.0;
};

/// The camera that may have turned sideways since the calibration. Such a turn leaves every match on its
/// epipolar line: the face only appears nearer and smaller, or farther and larger.
struct TurnableCamera {
  Point<Camera> centre;    // the right camera's optical centre
  Direction<Camera> axis;  // unit, across the baseline and the view

  /// Displacement (mm per rad of turn) of the measured point `p`, along the left camera's ray.
  Eigen::Vector3d displacement(const Eigen::Vector3d& p_camera_mm) const;
  /// Standard error of the turn due to the cloud's shared error, which changes the face's size as a turn
  /// does.
  double sigma_rad = 0.0;
};

/// Turn of the right camera about TurnableCamera::axis since the calibration, rad.
struct CameraTurn {
  double rad = 0.0, sigma_rad = 0.0;
};

/// Apparent motion, per rad of the right camera's turn, of a rigid body that contains these points (Camera,
/// mm): left increment in Camera (rotation, mm about Camera's origin).
Vector6d motionByTurn(const TurnableCamera& right, const std::vector<Eigen::Vector3d>& points_mm);

/// Prior knowledge for the fit. All of it is optional: nothing is clicked. Directions and points in Camera.
struct AlignmentStart {
  std::optional<Direction<Camera>> patient_right;     // for example from left-eye to right-eye landmarks
  std::optional<Direction<Camera>> patient_superior;  // for example from chin or mouth to brow
  std::optional<Point<Camera>> nose_tip;
  std::optional<RigidTransform<Camera, Mri>> guess;  // a previous alignment
  /// Standard error that all depths of the cloud share (calibration, matching). The residuals do not show it;
  /// the error bound includes it.
  double shared_depth_sigma_mm = 0.0;
  /// Standard deviation of single points along the line of sight, as the measurement states it. The skin is
  /// recognised under so much noise.
  double noise_mm = 0.0;
  SightError sight;                     // included in the bound
  std::optional<TurnableCamera> right;  // empty: the right camera's turn is not estimated
  /// The turn as measured without the face (a marker or a board of known size), fused with the fit's own. If
  /// they contradict each other, the one that is more standard errors from zero is used.
  std::optional<CameraTurn> known_turn;
  /// A person confirmed that the scan is of the patient in view. This counts where a coarsely measured face
  /// fits the scan, but other heads would fit as well. It does not help a face that speaks against the scan.
  bool is_patient_confirmed = false;
};

/// Size of the live face divided by that of the scan, with the standard error of the fit. Errors of scanner
/// and calibration are not included. The pose is not corrected by it.
struct FaceScale {
  double value = 1.0, sigma = 0.0;
};

struct AlignmentResult {
  RigidTransform<Camera, Mri> camera_T_mri;
  double rms_mm = 0.0, max_mm = 0.0;       // residuals |point - skin| of the inliers
  double inlier_fraction = 0.0;            // share of the face points offered
  int points = 0;                          // number of inliers
  std::vector<bool> is_inlier;             // one per cloud point
  std::vector<double> residual_mm;         // signed along the skin's outward normal, one per cloud point
  Matrix6d covariance = Matrix6d::Zero();  // of (rotation rad, translation mm): left increment in Camera at
                                           // the image of Mri's origin
  double freedom = 30.0;                   // degrees of freedom of the pose error's t distribution
  double misfit_mm = 0.0;  // size of the smooth misfit of live skin and MRI, estimated from the residuals
  std::optional<FaceScale> face_scale;  // empty: not estimated
  /// The turn at which the face fits the MRI best, fused with other measurements. Its standard error includes
  /// errors of the scan's scale and of the skin's shape. Empty: not estimated.
  std::optional<CameraTurn> right_turn;
  std::optional<TurnableCamera> right;  // as in AlignmentStart
  /// Apparent motion of the head by one standard error of that turn: left increment in Camera (rotation rad
  /// about Camera's origin, mm). It is not part of `covariance`.
  Vector6d head_by_turn = Vector6d::Zero();
  double own_log_odds = 0.0;           // log likelihood ratio of this person's scan to another's
  bool rests_on_confirmation = false;  // without AlignmentStart::is_patient_confirmed it would be refused
  std::vector<std::string> cautions;   // for users: what a clinician must check before trusting the fit

  /// Uncertainty for cameras positioned as calibrated.
  PoseUncertainty uncertainty() const { return {covariance, freedom}; }
  /// Predicted standard error at a point of the patient (pose covariance propagated to it), mm, for cameras
  /// positioned as calibrated.
  double predictedError_mm(const Point<Mri>& target) const;
  /// Bound of the position error in Camera at this point with `probability` (0.95: 95 of 100 alignments), mm,
  /// also if a camera turned sideways.
  double errorBound_mm(const Point<Mri>& target, double probability = 0.95) const;
  /// Error bound of a coil held at the target, relative to the head, measured with the same cameras. An
  /// earlier turn of a camera moves head and coil alike; what remains is the difference between face and
  /// `marker` (the corners of the coil's square, Mri).
  double coilErrorBound_mm(const Point<Mri>& target, const std::vector<Point<Mri>>& marker,
                           double probability = 0.95) const;
  /// Shift (mm, Camera) of that coil relative to the head at the target, by one standard error of the turn.
  Eigen::Vector3d coilByTurn_mm(const Point<Mri>& target, const std::vector<Point<Mri>>& marker) const;
};

/// Thrown where too little of the face is measured for a pose, or for one pose only. Other pictures may show
/// more.
class NotEnoughFace : public Error {
 public:
  using Error::Error;
};

/// Thrown where the face is not told from its mirror image. Other pictures may tell it, but one whose face
/// fits the mirror image better speaks against all of them: left and right of the scan may be exchanged.
class MayBeMirrored : public NotEnoughFace {
 public:
  MayBeMirrored(const std::string& what, const std::string& remedy, double log_odds)
      : NotEnoughFace(what, {}, remedy), mirror_log_odds(log_odds) {}
  double mirror_log_odds;  // of the face as it is against its mirror image
};

/// Thrown where the face fits the mirror image, and not the scan as it is.
class Mirrored : public Error {
 public:
  using Error::Error;
};

/// Thrown where shape and size of the face do not show that the scan is this person's. Other pictures may
/// show it: they are other evidence about the same head.
class NotThisPerson : public Error {
 public:
  NotThisPerson(const std::string& what, const std::string& remedy, double log_odds)
      : Error(what, {}, remedy), own_log_odds(log_odds) {}
  double own_log_odds;  // of this person's scan against another's
};

/// Thrown where the face fits the scan, at one pose, but was measured too coarsely to tell this person from
/// others. Other pictures may show it, or a person confirms it (AlignmentStart::is_patient_confirmed).
class PersonUnclear : public Error {
 public:
  explicit PersonUnclear(const std::string& what, const std::string& remedy = {}, double log_odds = 0.0)
      : Error(what, {}, remedy), own_log_odds(log_odds) {}
  double own_log_odds;  // of this person's scan against another's
};

class Aligner {
 public:
  virtual ~Aligner() = default;
  /// Throws Error("not aligned: ...") if the fit cannot be trusted: no face in the scan, too few points,
  /// mirrored or wrong head, too large a residual, an ambiguous pose.
  virtual AlignmentResult align(const ScalpField& scalp, const PointCloud<Camera>& face,
                                const AlignmentStart& start, TaskMonitor& monitor) const = 0;
};

/// Makes "surface", the default: robust point-to-plane on the scalp's distance field, many starts, coarse to
/// fine.
std::unique_ptr<Aligner> makeSurfaceAligner();

}  // namespace facenav::registration
