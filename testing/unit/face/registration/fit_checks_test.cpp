#include "confidence/fit_checks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "confidence/fit_report.h"
#include "facenav/core/error.h"
#include "facenav/registration/fit_limits.h"
#include "model_field.h"
#include "support/changed_settings.h"

namespace facenav::registration {
namespace {

using facenav::testing::ChangedSettings;
using facenav::testing::facing;
using facenav::testing::ModelHead;
using ::testing::HasSubstr;
using testing::modelFace;
using testing::modelField;
using testing::modelHead;

/// Evidence of a fit to the right head.
FitEvidence rightHead() {
  FitEvidence evidence;
  evidence.closeness = {3000, 0.95, 0.15, 110.0};
  evidence.predicted_error_mm = 0.5, evidence.misfit_mm = 0.2, evidence.mirror_log_odds = 60;
  evidence.scale = 1.001, evidence.scale_sigma = 0.002;
  evidence.own_log_odds = 30;
  return evidence;
}

/// Reason of the refusal; empty if it is accepted.
std::string refusal(const FitEvidence& evidence) {
  try {
    requireTrust(evidence);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// Evidence beyond one limit, its message, and a limit that accepts it.
struct Verdict {
  const char* limit;
  void (*spoil)(FitEvidence&);
  const char* reason;
  void (*widen)(FitLimits&);
};

const Verdict kVerdicts[] = {
    {"least_own", [](FitEvidence& e) { e.own_log_odds = 2; }, "too coarsely to tell this person from others",
     [](FitLimits& l) { l.least_own = 1; }},
    {"least_extent_mm", [](FitEvidence& e) { e.closeness.extent_mm = 40; }, "too little of the face",
     [](FitLimits& l) { l.least_extent_mm = 35; }},
    {"least_unmirrored", [](FitEvidence& e) { e.mirror_log_odds = 15; },
     "too coarsely to tell this person from others", [](FitLimits& l) { l.least_unmirrored = 10; }},
    {"chosen_parts", [](FitEvidence& e) { e.closeness.bare_share = 0.3; },
     "too coarsely to tell this person from others", [](FitLimits& l) { l.chosen_parts = 60; }},
    {"rival", [](FitEvidence& e) { e.rival_log_odds = 2; }, "fits in two places",
     [](FitLimits& l) { l.rival = 1.5; }},
    {"refused_scale_z", [](FitEvidence& e) { e.fitting_scale = 1.06; }, "106.0 % of its size",
     [](FitLimits& l) { l.refused_scale_z = 7; }},
    {"refused_scale_z", [](FitEvidence& e) { e.scale = 0.95; }, "95.0 % of its size",
     [](FitLimits& l) { l.refused_scale_z = 6; }},
    {"scanner_scale", [](FitEvidence& e) { e.scale = 0.95; }, "95.0 % of its size",
     [](FitLimits& l) { l.scanner_scale = 0.02; }},
    {"refused_turn_z",
     [](FitEvidence& e) {
       e.turn = CameraTurn{0.005, 0.001}, e.scanner_rad = 0.001;
     },
     "turned sideways", [](FitLimits& l) { l.refused_turn_z = 4; }},
};

TEST(FitChecks, ARightHeadPassesWithoutACaution) {
  EXPECT_EQ(refusal(rightHead()), "");
  EXPECT_TRUE(cautionsOf(rightHead()).empty());
  EXPECT_FALSE(isPartlyCovered(rightHead()));
}

TEST(FitChecks, EachLimitRefusesWithItsReasonAndAWiderOneLetsPass) {
  for (const Verdict& verdict : kVerdicts) {
    FitEvidence evidence = rightHead();
    verdict.spoil(evidence);
    EXPECT_THAT(refusal(evidence), HasSubstr("not aligned: ")) << verdict.limit;
    EXPECT_THAT(refusal(evidence), HasSubstr(verdict.reason)) << verdict.limit;
    ChangedSettings<FitLimits> limits;
    verdict.widen(*limits.operator->());
    EXPECT_EQ(refusal(evidence), "") << verdict.limit;
  }
}

TEST(FitChecks, ASizeThatScanAndCalibrationCanHaveIsNoReasonToRefuse) {
  FitEvidence evidence = rightHead();
  for (const double scale : {0.98, 1.02}) {
    evidence.scale = evidence.fitting_scale = scale;
    EXPECT_EQ(refusal(evidence), "") << scale;
    EXPECT_THAT(cautionsOf(evidence), ::testing::ElementsAre(HasSubstr("of the MRI's size")));
  }
  evidence = rightHead();
  evidence.turn = CameraTurn{0.004, 0.0009}, evidence.scanner_rad = 0.002;  // 2 % at five baselines
  EXPECT_EQ(refusal(evidence), "");
}

TEST(FitChecks, TooFewPointsAreTooLittleOfAFace) {
  FitEvidence evidence = rightHead();
  evidence.closeness.face_points = 299;
  EXPECT_THAT(refusal(evidence), HasSubstr("too little of the face"));
  evidence.closeness.face_points = 300;
  EXPECT_EQ(refusal(evidence), "");
}

TEST(FitChecks, AMirroredScanIsNamedOnlyWhereTheMirrorImageFits) {
  FitEvidence evidence = rightHead();
  evidence.mirror_log_odds = -8, evidence.does_mirror_fit = true, evidence.own_log_odds = 0;
  EXPECT_THAT(refusal(evidence), HasSubstr("left and right are swapped"));
  evidence.does_mirror_fit = false;
  EXPECT_THAT(refusal(evidence), HasSubstr("does not fit this MRI"));
  evidence.does_mirror_fit = true;
  ChangedSettings<FitLimits> limits;
  limits->mirrored = -10;
  EXPECT_THAT(refusal(evidence), HasSubstr("does not fit this MRI"));
}

TEST(FitChecks, ASymmetricFaceThatFitsBothWaysIsRefusedWithoutANameForIt) {
  FitEvidence evidence = rightHead();
  evidence.mirror_log_odds = -8;
  for (const bool does_mirror_fit : {true, false}) {
    evidence.does_mirror_fit = does_mirror_fit;
    EXPECT_THAT(refusal(evidence), HasSubstr("cannot be distinguished from its mirror image"));
  }
}

TEST(FitChecks, AConfirmationTellsThePersonWhereTheFaceIsTooCoarse) {
  void (*const coarse[])(FitEvidence&) = {[](FitEvidence& e) { e.own_log_odds = 2; },
                                          [](FitEvidence& e) { e.mirror_log_odds = 15; },
                                          [](FitEvidence& e) { e.closeness.bare_share = 0.3; }};
  for (const auto spoil : coarse) {
    FitEvidence evidence = rightHead();
    spoil(evidence);
    EXPECT_THROW(requireTrust(evidence), PersonUnclear);
    EXPECT_FALSE(restsOnConfirmation(evidence));
    evidence.is_patient_confirmed = true;
    EXPECT_EQ(refusal(evidence), "");
    EXPECT_TRUE(restsOnConfirmation(evidence));
    EXPECT_THAT(cautionsOf(evidence), ::testing::Contains(HasSubstr("a person confirmed")));
  }
}

TEST(FitChecks, AConfirmationHelpsNoFaceThatSpeaksAgainstTheScan) {
  void (*const wrong[])(FitEvidence&) = {
      [](FitEvidence& e) { e.own_log_odds = -0.1; },  // another person
      [](FitEvidence& e) { e.own_log_odds = -9, e.mirror_log_odds = -8, e.does_mirror_fit = true; },
      [](FitEvidence& e) { e.mirror_log_odds = 5; },  // may be mirrored
      [](FitEvidence& e) { e.rival_log_odds = 2; },   // may be elsewhere
      [](FitEvidence& e) { e.fitting_scale = 1.06; },
      [](FitEvidence& e) { e.closeness.extent_mm = 40; },
      [](FitEvidence& e) { e.predicted_error_mm = std::numeric_limits<double>::infinity(); }};
  for (const auto spoil : wrong) {
    FitEvidence evidence = rightHead();
    spoil(evidence);
    const std::string before = refusal(evidence);
    EXPECT_NE(before, "");
    evidence.is_patient_confirmed = true;
    EXPECT_EQ(refusal(evidence), before);
  }
}

TEST(FitChecks, AConfirmationThatIsNotNeededLeavesNoTrace) {
  FitEvidence evidence = rightHead();
  evidence.is_patient_confirmed = true;
  EXPECT_FALSE(restsOnConfirmation(evidence));
  EXPECT_TRUE(cautionsOf(evidence).empty());
}

TEST(FitChecks, AnErrorThatIsNoNumberIsNoSmallOne) {
  FitEvidence evidence = rightHead();
  evidence.predicted_error_mm = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal(evidence), HasSubstr("too little of the face"));
  EXPECT_NO_THROW(requireLikeness(evidence)) << "likeness is asked before the error is known";
}

TEST(FitChecks, AFaceOfAnotherSizeIsNoMirroredOne) {
  FitEvidence evidence = rightHead();
  evidence.mirror_log_odds = -8, evidence.does_mirror_fit = true;
  evidence.fitting_scale = 0.94;
  EXPECT_THAT(refusal(evidence), HasSubstr("94.0 % of its size"));
  evidence.fitting_scale = 0.985;
  EXPECT_THAT(refusal(evidence), HasSubstr("swapped"));
}

TEST(FitChecks, CautionsNameSizeLooseSkinAndCovers) {
  const auto cautionOf = [](void (*spoil)(FitEvidence&)) {
    FitEvidence evidence = rightHead();
    spoil(evidence);
    EXPECT_EQ(refusal(evidence), "") << "a caution is no refusal";
    const auto cautions = cautionsOf(evidence);
    return cautions.size() == 1 ? cautions.front() : std::to_string(cautions.size()) + " cautions";
  };
  const auto larger = [](FitEvidence& e) { e.scale = 1.015, e.scale_sigma = 0.001; };
  const auto wide = [](FitEvidence& e) { e.predicted_error_mm = 2.4; };
  const auto loose = [](FitEvidence& e) { e.closeness.bare_mm = 0.7; };
  const auto misfit = [](FitEvidence& e) { e.misfit_mm = 0.7; };
  const auto covered = [](FitEvidence& e) { e.closeness.bare_share = 0.6; };
  EXPECT_THAT(cautionOf(larger), HasSubstr("101.5 % of the MRI's size (+/- 0.1)"));
  EXPECT_THAT(cautionOf(wide), HasSubstr("to 2.4 mm only"));
  EXPECT_THAT(cautionOf(loose), HasSubstr("fits loosely (by 0.7 mm)"));
  EXPECT_THAT(cautionOf(misfit), HasSubstr("fits loosely (by 0.7 mm)"));
  EXPECT_THAT(cautionOf(covered), HasSubstr("40 % of the face is covered"));
  ChangedSettings<FitLimits> limits;
  limits->caution_scale_z = 6, limits->loose_mm = 0.8, limits->mostly_bare = 0.5,
  limits->large_error_mm = 2.5;
  for (const auto spoil : {+larger, +wide, +loose, +misfit, +covered})
    EXPECT_EQ(cautionOf(spoil), "0 cautions");
}

TEST(FitChecks, ALoosePoseIsStatedAndNotRefused) {
  FitEvidence evidence = rightHead();
  evidence.predicted_error_mm = 6.0;
  EXPECT_EQ(refusal(evidence), "");
  EXPECT_THAT(cautionsOf(evidence), ::testing::ElementsAre(HasSubstr("to 6.0 mm only")));
}

FitEvidence evidenceOf(const PointCloud<Camera>& face, const RigidTransform<Camera, Mri>& camera_T_mri,
                       double noise_mm = 0.0) {
  return gatherEvidence(modelField(), face, camera_T_mri.isometry().inverse(), {}, {}, noise_mm);
}

TEST(FitEvidence, OfTheRightPoseIsCloseAndUnmirrored) {
  const auto truth = facing(8, -5, 3);
  const FitEvidence evidence = evidenceOf(modelFace(truth), truth);
  EXPECT_GT(evidence.closeness.bare_share, 0.98);
  EXPECT_LT(evidence.closeness.bare_mm, 0.15) << "0.1 mm of noise";
  EXPECT_GT(evidence.own_log_odds, 20.0);
  EXPECT_GT(evidence.mirror_log_odds, 1.0);
  EXPECT_EQ(evidence.fitting_scale, 1.0) << "other sizes are not tried on a face that fits";
  EXPECT_NO_THROW(requireLikeness(evidence));
}

TEST(FitEvidence, OfAMirroredFaceFavoursTheMirrorImage) {
  const auto truth = facing(8, -5, 3);
  PointCloud<Camera> face = modelFace(truth);
  const Eigen::Isometry3d mri_T_camera = truth.isometry().inverse();
  for (auto& p : face.points_mm) {
    Eigen::Vector3d at = mri_T_camera * p;
    at.x() = -at.x();
    p = truth.isometry() * at;
  }
  const FitEvidence evidence = evidenceOf(face, truth);
  EXPECT_LT(evidence.mirror_log_odds, -5.0);
  EXPECT_TRUE(evidence.does_mirror_fit);
}

TEST(FitEvidence, OfAResizedFaceNamesItsSize) {
  const auto truth = facing(8, -5, 3);
  for (const double scale : {0.94, 1.06}) {
    PointCloud<Camera> face = modelFace(truth);
    // Turned about the head's middle, so that the pose stays the right one.
    const Eigen::Vector3d middle = truth.isometry() * modelField().middle_mm();
    for (auto& p : face.points_mm) p = middle + scale * (p - middle);
    const FitEvidence evidence = evidenceOf(face, truth);
    EXPECT_EQ(evidence.fitting_scale, scale);
    EXPECT_GT(evidence.own_log_odds, 10.0);
    EXPECT_THROW(requireLikeness(evidence), Error);
  }
}

TEST(FitEvidence, OfAFaceOfASlightlyOtherSizeIsThisPersons) {
  const auto truth = facing(8, -5, 3);
  for (const double scale : {0.98, 0.99, 1.01, 1.02}) {
    PointCloud<Camera> face = modelFace(truth);
    const Eigen::Vector3d middle = truth.isometry() * modelField().middle_mm();
    for (auto& p : face.points_mm) p = middle + scale * (p - middle);
    const FitEvidence evidence = evidenceOf(face, truth);
    EXPECT_GT(evidence.own_log_odds, 5.0) << scale;
    EXPECT_NO_THROW(requireLikeness(evidence)) << scale;
  }
}

TEST(FitEvidence, OfAnotherHeadIsRefused) {
  const auto truth = facing(8, -5, 3);
  const auto face = facenav::testing::measure(ModelHead(2), truth, {0.1, false, false, -60, 200, 5000, 7});
  EXPECT_THROW(requireLikeness(evidenceOf(face, truth)), Error);
}

TEST(FitEvidence, OfANoisyFaceIsThisPersonsIfTheNoiseIsKnown) {
  const auto truth = facing(8, -5, 3);
  for (const double noise_mm : {1.0, 2.0, 3.0}) {
    const auto own =
        facenav::testing::measure(ModelHead(1), truth, {noise_mm, false, false, -60, 200, 5000, 7});
    const auto other =
        facenav::testing::measure(ModelHead(2), truth, {noise_mm, false, false, -60, 200, 5000, 7});
    EXPECT_NO_THROW(requireLikeness(evidenceOf(own, truth, noise_mm))) << noise_mm;
    EXPECT_THROW(requireLikeness(evidenceOf(other, truth, noise_mm)), Error) << noise_mm;
  }
  const auto coarse = facenav::testing::measure(ModelHead(1), truth, {3.0, false, false, -60, 200, 5000, 7});
  EXPECT_THROW(requireLikeness(evidenceOf(coarse, truth)), Error) << "noise that is not stated is no skin";
}

TEST(FitEvidence, OfANoseAloneHasNoExtent) {
  const auto truth = facing(8, -5, 3);
  const PointCloud<Camera> face = modelFace(truth, 12000);
  PointCloud<Camera> nose;
  for (const auto& p : face.points_mm) {
    const Eigen::Vector3d d = truth.isometry().inverse() * p - modelField().noseTip_mm();
    if (std::abs(d.x()) < 15 && std::abs(d.z()) < 20) nose.points_mm.push_back(p);
  }
  EXPECT_LT(evidenceOf(nose, truth).closeness.extent_mm, 45.0) << "it fits, but it fixes no pose";
  EXPECT_GT(evidenceOf(face, truth).closeness.extent_mm, 80.0);
}

TEST(FitReport, RefusesFewerThanFiveHundredPointsThatAreNumbers) {
  const auto truth = facing(0, 0, 0);
  PointCloud<Camera> face = modelFace(truth, 500);
  EXPECT_NO_THROW(requireMaterial(modelField(), face));
  face.points_mm[3].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(requireMaterial(modelField(), face), Error) << "499 are numbers";
}

TEST(FitReport, TheCovarianceInCameraIsThatOfThePoseInMri) {
  const auto truth = facing(20, -10, 60);
  const auto face = modelFace(truth, 8000);
  const Eigen::Isometry3d pose = truth.isometry().inverse();
  const FinalFit fit = correct(modelField(), face, testing::allOf(face), pose, 1.0, {});
  const AlignmentResult result =
      report(modelField(), face, fit, pose, {}, gatherEvidence(modelField(), face, pose, {}, {}, 0.0));
  EXPECT_TRUE((result.camera_T_mri.isometry() * fit.mri_T_camera).matrix().isIdentity(1e-9));
  EXPECT_LT((result.covariance - result.covariance.transpose()).norm(), 1e-9);
  ASSERT_LT(std::abs(fit.posterior.scale), 2 * fit.posterior.scale_sigma) << "no size error is added";
  for (const Eigen::Vector3d& target : {Eigen::Vector3d(-40, -10, 60), Eigen::Vector3d(0, -60, 20)}) {
    Eigen::Matrix<double, 3, 6> carry;
    carry << -skew(target - modelField().middle_mm()), Eigen::Matrix3d::Identity();
    const double direct_mm = std::sqrt((carry * fit.posterior.covariance * carry.transpose()).trace());
    EXPECT_NEAR(result.predictedError_mm(Point<Mri>(target)), direct_mm, 1e-6);
  }
  EXPECT_GT(result.inlier_fraction, 0.95);
  EXPECT_EQ(result.residual_mm.size(), face.size());
  EXPECT_EQ(result.points, std::count(result.is_inlier.begin(), result.is_inlier.end(), true));
  EXPECT_LT(result.rms_mm, 0.15);
}

TEST(FitReport, LeastSquaresTakesBackASmallError) {
  const auto truth = facing(5, 5, 0);
  const auto face = modelFace(truth, 8000);
  const Eigen::Isometry3d right = truth.isometry().inverse();
  Vector6d off;
  off << 0.003, -0.002, 0.003, 0.2, -0.2, 0.15;
  const Eigen::Isometry3d pose = increment(off, modelField().middle_mm(), right);
  const FieldFitter fitter(modelField(), face, testing::allOf(face));
  const auto error_mm = [&](const Eigen::Isometry3d& p) {
    const Eigen::Vector3d target(-40, -10, 60);
    return (p * right.inverse() * target - target).norm();
  };
  EXPECT_LT(error_mm(leastSquares(modelField(), fitter, pose, 1.5)), 0.3 * error_mm(pose));
}

TEST(PoseUncertainty, ATurnCountsByItsLever) {
  PoseUncertainty turn;
  turn.covariance.topLeftCorner<3, 3>() = 1e-6 * Eigen::Matrix3d::Identity();  // 1 mrad about each axis
  const RigidTransform<Camera, Mri> camera_T_mri = facing(20, 10, 30);
  EXPECT_NEAR(turn.predictedError_mm(camera_T_mri, Point<Mri>(0, 0, 0)), 0.0, 1e-9);
  EXPECT_NEAR(turn.predictedError_mm(camera_T_mri, Point<Mri>(0, 100, 0)), 0.1 * std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(turn.predictedError_mm(camera_T_mri, Point<Mri>(0, 0, 200)), 0.2 * std::sqrt(2.0), 1e-9);
}

TEST(PoseUncertainty, TheBoundGrowsWithTheProbabilityAndIsNothingWithoutError) {
  PoseUncertainty shift;
  shift.covariance.bottomRightCorner<3, 3>() = Eigen::Vector3d(0.09, 0.01, 0.04).asDiagonal();
  const RigidTransform<Camera, Mri> camera_T_mri = facing(0, 0, 0);
  double last = 0;
  for (const double probability : {0.5, 0.8, 0.95, 0.99}) {
    const double here = shift.errorBound_mm(camera_T_mri, {}, probability);
    EXPECT_GT(here, last);
    last = here;
  }
  PoseUncertainty none;
  EXPECT_EQ(none.errorBound_mm(camera_T_mri, Point<Mri>(10, 20, 30)), 0.0);
}

TEST(PoseUncertainty, TheBoundIsAQuantileOfDrawnErrors) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  PoseUncertainty uncertainty;
  uncertainty.freedom = 1e6;
  const Eigen::Vector3d sigma_mm(0.3, 0.1, 0.2);
  uncertainty.covariance.bottomRightCorner<3, 3>() = sigma_mm.cwiseAbs2().asDiagonal();
  const double bound_mm = uncertainty.errorBound_mm(facing(0, 0, 0), {}, 0.95);
  int within = 0;
  constexpr int kDraws = 20000;
  for (int i = 0; i < kDraws; ++i) {
    const Eigen::Vector3d error(normal(random), normal(random), normal(random));
    within += error.cwiseProduct(sigma_mm).norm() < bound_mm;
  }
  EXPECT_NEAR(double(within) / kDraws, 0.95, 0.01) << "Satterthwaite's approximation costs half a percent";
}

}  // namespace
}  // namespace facenav::registration
