#include "fit_report.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>

#include "cloud/cloud_sampling.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/registration/fit_limits.h"
#include "fit/robust_fit.h"

namespace facenav::registration {
namespace {

constexpr double kLeastCovered = 0.65;  // patches with a lower share lie at the edge of hair or coil

std::vector<SkinPatch> coveredPatches(const ScalpField& scalp, const FieldFitter& fitter,
                                      const Eigen::Isometry3d& pose, double limit_mm) {
  auto patches =
      gatherPatches(fitter.match(pose), {kModelPatch_mm, limit_mm, limit_mm}, pose, scalp.middle_mm());
  patches.erase(std::remove_if(patches.begin(), patches.end(),
                               [](const SkinPatch& p) { return p.covered < kLeastCovered; }),
                patches.end());
  if (patches.size() < 20)
    throw NotEnoughFace("not aligned: too little of the face was measured", {},
                        "show the whole face to both cameras, with the dots on it");
  return patches;
}

/// Converts increments of mri_T_camera about the pivot in Mri to left increments of camera_T_mri in Camera at
/// the image of Mri's origin. The rotation changes sign, and the shift is that of the origin.
Matrix6d intoCamera(const Eigen::Vector3d& pivot_mri_mm, const Eigen::Matrix3d& camera_R_mri) {
  Matrix6d carry = Matrix6d::Zero();
  carry.topLeftCorner<3, 3>() = -camera_R_mri;
  carry.bottomLeftCorner<3, 3>() = -camera_R_mri * skew(pivot_mri_mm);
  carry.bottomRightCorner<3, 3>() = -camera_R_mri;
  return carry;
}

Matrix6d inCamera(const Matrix6d& covariance, const Eigen::Vector3d& pivot_mri_mm,
                  const Eigen::Matrix3d& camera_R_mri) {
  const Matrix6d carry = intoCamera(pivot_mri_mm, camera_R_mri);
  return carry * covariance * carry.transpose();
}

/// The largest predicted error at targets of coils: up to 60 mm from the head's middle.
double worstInBrain_mm(const AlignmentResult& result, const Eigen::Vector3d& middle) {
  constexpr double kBrain_mm = 60.0;
  double worst = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-kBrain_mm, kBrain_mm})
      worst =
          std::max(worst, result.predictedError_mm(Point<Mri>(middle + side * Eigen::Vector3d::Unit(axis))));
  return worst;
}

/// Covariance of the pose due to a size error of scan or calibration. A face whose size differs from the
/// scan's by more than two standard errors shows such an error. The pose fits at the face, so the error in
/// the brain is that share of the distance between face and brain. Modelled as a shift, since only points in
/// the brain matter.
Matrix6d bySize(const PosePosterior& posterior, const Eigen::Vector3d& face_mri_mm,
                const Eigen::Vector3d& middle, const Eigen::Matrix3d& camera_R_mri) {
  const double beyond = std::max(0.0, std::abs(posterior.scale) - 2 * posterior.scale_sigma);
  const Eigen::Vector3d shift_mm = beyond * (camera_R_mri * (middle - face_mri_mm));
  Matrix6d covariance = Matrix6d::Zero();
  covariance.bottomRightCorner<3, 3>() = shift_mm * shift_mm.transpose();
  return covariance;
}

/// Shift of the face by a camera that turned sideways, as a share of its distance, relative to the measured
/// size error. Used if the turn is not estimated: the matches stay on their epipolar lines, and only the
/// face's size shows the turn. Above 1, since the robust fit underestimates the size. Larger widens the
/// bound.
constexpr double kDistancePerSize = 1.3;

Vector6d headByTurn(const PosePosterior& posterior, const RigidTransform<Camera, Mri>& camera_T_mri,
                    const Eigen::Vector3d& pivot_mri_mm, const Eigen::Vector3d& face_camera_mm) {
  Vector6d motion = Vector6d::Zero();
  if (!posterior.turn) {
    motion.tail<3>() = kDistancePerSize * posterior.scale * face_camera_mm;
    return motion;
  }
  // The pose is corrected by -error, first at the image of Mri's origin, then about Camera's.
  motion = -std::hypot(posterior.turn->rad, posterior.turn->sigma_rad) *
           (intoCamera(pivot_mri_mm, camera_T_mri.rotation()) * posterior.error_by_turn);
  motion.tail<3>() -= motion.head<3>().cross(camera_T_mri.translation_mm());
  return motion;
}

/// Turn of the right camera that changes the size of a face there as a usual scale error of scan and
/// calibration does.
double scannerTurn_rad(const TurnableCamera& right, const Point<Camera>& face) {
  return settingsOf<FitLimits>().scanner_scale * face.mm.norm() / right.displacement(face.mm).norm();
}

/// Widens the turn's error where the face leaves the pose loose: a pose that gives way hides a size error of
/// that share of the distance between face and brain, and with it a turn.
CameraTurn widened(CameraTurn turn, double predicted_error_mm, double scanner_rad) {
  constexpr double kFaceToBrain_mm = 100.0;
  const FitLimits& limits = settingsOf<FitLimits>();
  if (!(predicted_error_mm > limits.large_error_mm)) return turn;
  turn.sigma_rad =
      std::hypot(turn.sigma_rad, scanner_rad / limits.scanner_scale * predicted_error_mm / kFaceToBrain_mm);
  return turn;
}

/// Caution about a turned camera. Returns nothing if chance explains the turn, or if its effect is small.
std::optional<std::string> turnedCameraCaution(const PosePosterior& posterior, const Vector6d& head_by_turn,
                                               const Eigen::Vector3d& face_camera_mm) {
  constexpr double kSaid_mm = 2.0;
  const double up_to_mm =
      2.0 * (head_by_turn.head<3>().cross(face_camera_mm) + head_by_turn.tail<3>()).norm();
  const bool is_chance = posterior.turn ? std::abs(posterior.turn->rad) < 2.0 * posterior.turn->sigma_rad
                                        : std::abs(posterior.scale) < 2.0 * posterior.scale_sigma;
  if (is_chance || up_to_mm < kSaid_mm) return std::nullopt;
  return "a camera may have turned sideways since the calibration (the cameras measure the face at " +
         fixed(100.0 * (1.0 + posterior.scale), 1) + " % of the MRI's size): then head and coil lie up to " +
         fixed(up_to_mm, 0) +
         " mm nearer or farther than shown; check the cameras with the board or the coil's marker "
         "('facenav rig check')";
}

}  // namespace

Eigen::Isometry3d leastSquares(const ScalpField& scalp, const FieldFitter& points,
                               const Eigen::Isometry3d& pose, double limit_mm) {
  const auto patches = coveredPatches(scalp, points, pose, limit_mm);
  const Eigen::Vector3d middle = scalp.middle_mm();
  return increment(-poseError(patches, anatomy::FaceRegions(scalp.noseTip_mm()), middle), middle, pose);
}

FinalFit correct(const ScalpField& scalp, const PointCloud<Camera>& face, const std::vector<int>& points,
                 const Eigen::Isometry3d& pose, double limit_mm, const AlignmentStart& start) {
  const FieldFitter fitter(scalp, face, points);
  const anatomy::FaceRegions regions(scalp.noseTip_mm());
  const Eigen::Vector3d middle = scalp.middle_mm();
  FinalFit fit{leastSquares(scalp, fitter, pose, limit_mm), limit_mm, {}};
  SeenFrom seen{fit.mri_T_camera.translation(), start.sight};
  if (start.right)
    seen.turn_mm = [right = *start.right, mri_T_camera = fit.mri_T_camera](const Eigen::Vector3d& p_mri_mm) {
      return Eigen::Vector3d(mri_T_camera.linear() * right.displacement(mri_T_camera.inverse() * p_mri_mm));
    };
  fit.posterior = posteriorOf(coveredPatches(scalp, fitter, fit.mri_T_camera, limit_mm), regions, middle,
                              settingsOf<MisfitPrior>(), seen);
  fit.mri_T_camera = increment(-fit.posterior.error, middle, fit.mri_T_camera);
  return fit;
}

FinalFit judge(const ScalpField& scalp, const PointCloud<Camera>& face, const std::vector<int>& points,
               const Eigen::Isometry3d& pose, double limit_mm) {
  const auto patches = coveredPatches(scalp, FieldFitter(scalp, face, points), pose, limit_mm);
  FinalFit fit{pose, limit_mm,
               posteriorOf(patches, anatomy::FaceRegions(scalp.noseTip_mm()), scalp.middle_mm(),
                           settingsOf<MisfitPrior>())};
  fit.posterior.covariance += fit.posterior.error * fit.posterior.error.transpose();
  return fit;
}

AlignmentResult report(const ScalpField& scalp, const PointCloud<Camera>& face, FinalFit fit,
                       const Eigen::Isometry3d& closest, const Covers& covers, FitEvidence evidence,
                       const AlignmentStart& start) {
  AlignmentResult result;
  result.camera_T_mri = RigidTransform<Camera, Mri>::fromIsometry(fit.mri_T_camera.inverse());
  result.covariance = inCamera(fit.posterior.covariance, scalp.middle_mm(), result.camera_T_mri.rotation());
  result.freedom = fit.posterior.freedom;
  result.misfit_mm = fit.posterior.field_mm;
  evidence.predicted_error_mm = worstInBrain_mm(result, scalp.middle_mm());
  evidence.misfit_mm = result.misfit_mm;
  // A marker measures the turn without the scan.
  const bool is_by_marker =
      start.known_turn && fit.posterior.turn && fit.posterior.turn->sigma_rad <= start.known_turn->sigma_rad;
  if (start.right && !is_by_marker)
    evidence.scanner_rad =
        scannerTurn_rad(*start.right, result.camera_T_mri * Point<Mri>(scalp.noseTip_mm()));
  evidence.turn = fit.posterior.turn;  // refused by the fit's own error, stated with the wider one
  if (evidence.scanner_rad > 0 && fit.posterior.turn)
    fit.posterior.turn = widened(*fit.posterior.turn, evidence.predicted_error_mm, evidence.scanner_rad);
  result.right_turn = fit.posterior.turn;
  evidence.scale = 1.0 + fit.posterior.scale;
  evidence.scale_sigma = fit.posterior.scale_sigma;
  if (evidence.scale_sigma > 0) result.face_scale = FaceScale{evidence.scale, evidence.scale_sigma};
  requireTrust(evidence);
  result.own_log_odds = evidence.own_log_odds;
  result.rests_on_confirmation = restsOnConfirmation(evidence);
  result.cautions = cautionsOf(evidence);

  std::vector<int> all(face.size());
  std::iota(all.begin(), all.end(), 0);
  const FieldFitter fitter(scalp, face, all);
  const auto matches = fitter.match(fit.mri_T_camera), nearest = fitter.match(closest);
  const std::vector<float> weights =
      patchWeights(nearest, std::max(4.0, double(kNoiseReach) * start.noise_mm), start.noise_mm);
  double squares = 0;
  std::size_t offered = 0;
  Eigen::Vector3d face_mri_mm = Eigen::Vector3d::Zero();
  // On a bare face one or two patches that look covered still fit the skin and are used.
  const bool is_partly_covered = isPartlyCovered(evidence);
  for (std::size_t p = 0; p < matches.size(); ++p) {
    const double residual = double(matches[p].residual_mm);
    const bool is_inlier = weights[p] > 0 && matches[p].is_valid &&
                           std::abs(nearest[p].residual_mm) < fit.limit_mm &&
                           !(is_partly_covered && covers.hold(face.points_mm[p]));
    offered += nearest[p].is_valid && std::abs(nearest[p].residual_mm) < 15;
    result.is_inlier.push_back(is_inlier);
    result.residual_mm.push_back(residual);
    if (!is_inlier) continue;
    ++result.points;
    squares += residual * residual;
    face_mri_mm += matches[p].at_mri_mm.cast<double>();
    result.max_mm = std::max(result.max_mm, std::abs(residual));
  }
  face_mri_mm /= std::max(1, result.points);
  result.covariance += bySize(fit.posterior, face_mri_mm, scalp.middle_mm(), result.camera_T_mri.rotation());
  const Eigen::Vector3d face_camera_mm = (result.camera_T_mri * Point<Mri>(face_mri_mm)).mm;
  result.right = start.right;
  result.head_by_turn = headByTurn(fit.posterior, result.camera_T_mri, scalp.middle_mm(), face_camera_mm);
  if (const auto words = turnedCameraCaution(fit.posterior, result.head_by_turn, face_camera_mm))
    result.cautions.push_back(*words);
  result.rms_mm = result.points ? std::sqrt(squares / result.points) : 0.0;
  result.inlier_fraction = offered ? double(result.points) / double(offered) : 0.0;
  return result;
}

void requireMaterial(const ScalpField& scalp, const PointCloud<Camera>& face) {
  if (!scalp.skin().has_face)
    throw Error("not aligned: the MRI shows no face to align to", {},
                "use a scan with the face in it (not defaced)");
  const std::size_t finite = finitePoints(face).size();
  if (finite < 500)
    throw NotEnoughFace(
        "not aligned: too little of the face was measured (" + std::to_string(finite) + " points)", {},
        "show the whole face to both cameras, with the dots on it");
}

}  // namespace facenav::registration
