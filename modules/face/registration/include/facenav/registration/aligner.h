#pragma once
// Aligner: fits the MRI's skin to the face cloud (paper, section 3, equation 1) and says how far to trust the
// fit. Data flow: ScalpField (of the ScalpSurface) + FaceCloud -> AlignmentResult (camera_T_mri at the time
// of capture).

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/core/task_monitor.h"
#include "facenav/geometry/rigid_transform.h"
#include "facenav/geometry/rotation.h"
#include "facenav/registration/pose_uncertainty.h"
#include "facenav/registration/scalp_field.h"

namespace facenav::registration {

/// Error of the cloud along the line of sight that neighbouring points share: what their pictures' texture
/// lets the matcher see there. Correlated over `reach_mm` (Matern 3/2), so that part of it looks like another
/// pose and shows in no residual.
struct SightError {
  double sigma_mm = 0.0, reach_mm = 40.0;
};

/// The camera that may have turned sideways since the calibration. Such a turn leaves every match on its
/// epipolar line: the face only seems nearer and smaller, or farther and larger.
struct TurnableCamera {
  Point<Camera> centre;    // the right camera's optical centre
  Direction<Camera> axis;  // unit, across the baseline and the view

  /// By how much (mm per rad) the measured point `p` lies off if the camera turned about the axis: along the
  /// left camera's ray.
  Eigen::Vector3d displacement(const Eigen::Vector3d& p_camera_mm) const;
  /// Standard error of the turn by what the cloud's points may be off alike: it changes the face's size, as a
  /// turn does.
  double sigma_rad = 0.0;
};

/// Turn of the right camera about TurnableCamera::axis since the calibration, rad.
struct CameraTurn {
  double rad = 0.0, sigma_rad = 0.0;
};

/// How a rigid body that holds these points (Camera, mm) seems to move where the right camera turned: left
/// increment in Camera (rotation, mm about Camera's origin), per rad.
Vector6d motionByTurn(const TurnableCamera& right, const std::vector<Eigen::Vector3d>& points_mm);

/// What is known before the fit. All of it is optional: nothing is clicked. Directions and points in Camera.
struct AlignmentStart {
  std::optional<Direction<Camera>> patient_right;     // e.g. from left-eye to right-eye landmarks
  std::optional<Direction<Camera>> patient_superior;  // e.g. from chin or mouth to brow
  std::optional<Point<Camera>> nose_tip;
  std::optional<RigidTransform<Camera, Mri>> guess;  // a previous alignment
  /// Standard error that all depths of the cloud share (calibration, matching). No residual shows it; the
  /// error bound includes it.
  double shared_depth_sigma_mm = 0.0;
  SightError sight;                     // the bound holds it too
  std::optional<TurnableCamera> right;  // empty: how far the right camera turned is not estimated
  /// The turn as measured without the face (a marker or a board of known size). The fit's own is fused with
  /// it. Where both contradict each other, the one counts that says more surely that the camera turned.
  std::optional<CameraTurn> known_turn;
};

/// Size of the live face divided by that of the scan, with its standard error. The standard error says how
/// well the face fixes it; errors of scanner and calibration are not included. The pose is not corrected by
/// it.
struct FaceScale {
  double value = 1.0, sigma = 0.0;
};

struct AlignmentResult {
  RigidTransform<Camera, Mri> camera_T_mri;
  double rms_mm = 0.0, max_mm = 0.0;       // residuals |point - skin| of the inliers
  double inlier_fraction = 0.0;            // of the face points offered
  int points = 0;                          // inliers
  std::vector<bool> is_inlier;             // one per cloud point
  std::vector<double> residual_mm;         // signed along the skin's outward normal, one per cloud point
  Matrix6d covariance = Matrix6d::Zero();  // of (rotation rad, translation mm): left increment in Camera at
                                           // the image of Mri's origin
  double freedom = 30.0;   // degrees of freedom of the t distribution that the pose's error has
  double misfit_mm = 0.0;  // size of the smooth misfit of live skin and MRI, estimated from the residuals
  std::optional<FaceScale> face_scale;  // empty: not estimated
  /// At which the face fits the MRI best, fused with what is known otherwise. Its standard error includes
  /// errors of the scan's scale and of the skin's shape. Empty: not estimated.
  std::optional<CameraTurn> right_turn;
  std::optional<TurnableCamera> right;  // as given
  /// How the head seems to move by one standard error of that turn: left increment in Camera (rotation rad
  /// about Camera's origin, mm). It is not part of `covariance`.
  Vector6d head_by_turn = Vector6d::Zero();
  std::vector<std::string> cautions;  // plain words: what a clinician must check before trusting the fit

  /// Of cameras that stand as they were calibrated.
  PoseUncertainty uncertainty() const { return {covariance, freedom}; }
  /// Predicted standard error at a point of the patient (pose covariance carried there), mm, of cameras that
  /// stand as they were calibrated.
  double predictedError_mm(const Point<Mri>& target) const;
  /// The error there lies within this with `probability` (0.95: 95 of 100 alignments), mm, also where a
  /// camera turned sideways. It is that of the place in Camera.
  double errorBound_mm(const Point<Mri>& target, double probability = 0.95) const;
  /// The same of a coil that is held at the target and measured with the same cameras: how far it lies from
  /// where it is shown against the head. A camera that turned before moves head and coil alike; what counts
  /// is the difference between face and `marker` (the corners of the coil's square, Mri).
  double coilErrorBound_mm(const Point<Mri>& target, const std::vector<Point<Mri>>& marker,
                           double probability = 0.95) const;
  /// Shift (mm, Camera) of that coil against the head at the target, by one standard error of the turn.
  Eigen::Vector3d coilByTurn_mm(const Point<Mri>& target, const std::vector<Point<Mri>>& marker) const;
};

class Aligner {
 public:
  virtual ~Aligner() = default;
  /// Throws Error("not aligned: ...") when the fit cannot be trusted: no face in the scan, too few points,
  /// mirrored or wrong head, too large a residual, an ambiguous pose.
  virtual AlignmentResult align(const ScalpField& scalp, const PointCloud<Camera>& face,
                                const AlignmentStart& start, TaskMonitor& monitor) const = 0;
};

/// The paper's method: point-to-point ICP (equation 1). Selectable as "icp". As the paper writes it
/// (untrimmed, from a nearby start) it fails by 12-27 degrees on scans that end above the chin. Therefore the
/// farthest 30 % of the pairs and the pairs at the scan's cut edge are dropped, and it starts from the
/// search's rough poses.
std::unique_ptr<Aligner> makeIcpAligner();
/// The default, "surface": robust point-to-plane on the scalp's distance field, many starts, coarse to fine.
std::unique_ptr<Aligner> makeSurfaceAligner();

}  // namespace facenav::registration
