#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "facenav/core/error.h"
#include "facenav/geometry/pose_error.h"
#include "facenav/geometry/rigid_fit.h"
#include "facenav/geometry/rotation.h"
#include "facenav/peers/icp_aligner.h"
#include "support/model_head.h"

namespace facenav::registration {
namespace {

using facenav::testing::CameraView;
using facenav::testing::facing;
using facenav::testing::measure;
using facenav::testing::ModelHead;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const Point<Mri> kTarget(-40, -10, 60);  // cortex under the coil

const ScalpField& patientsField() {
  static const ScalpField field(ModelHead().skin());
  return field;
}

AlignmentResult align(const ScalpField& scalp, const PointCloud<Camera>& face,
                      const AlignmentStart& start = {}) {
  TaskMonitor monitor;
  return makeSurfaceAligner()->align(scalp, face, start, monitor);
}
AlignmentResult align(const SkinModel& skin, const PointCloud<Camera>& face,
                      const AlignmentStart& start = {}) {
  return align(ScalpField(skin), face, start);
}

void expectClose(const AlignmentResult& result, const RigidTransform<Camera, Mri>& truth, double most_mm,
                 double most_deg) {
  const PoseError error = poseError(result.camera_T_mri, truth, kTarget);
  EXPECT_LT(error.at_point_mm, most_mm);
  EXPECT_LT(error.rotation_rad / kRadPerDeg, most_deg);
  EXPECT_LT(error.at_point_mm, result.errorBound_mm(kTarget));
}

TEST(SurfaceAligner, NeedsNoStartAndNoUprightCamera) {
  int seed = 0;
  for (const auto& truth :
       {facing(25, -12, 5, {50, -40, 60}), facing(-28, 14, -95), facing(10, 5, 170, {-60, 30, -80})})
    expectClose(align(patientsField(), measure(ModelHead(), truth, {.seed = std::uint32_t(++seed)})), truth,
                0.3, 0.15);
}

TEST(SurfaceAligner, FindsTheHeadFromThirtyDegreesAndSixtyMillimetresOff) {
  const auto truth = facing(5, -8, 3);
  const auto cloud = measure(ModelHead(), truth, {});
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (int start_number = 0; start_number < 6; ++start_number) {
    const Eigen::Vector3d axis = Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized(),
                          shift =
                              Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
    Eigen::Isometry3d guess = Eigen::Translation3d(60 * shift) * truth.isometry();
    guess.rotate(Eigen::AngleAxisd(30 * kRadPerDeg, axis));
    AlignmentStart start;
    start.guess = RigidTransform<Camera, Mri>::fromIsometry(guess);
    expectClose(align(patientsField(), cloud, start), truth, 0.3, 0.15);
  }
}

TEST(SurfaceAligner, UsesHintsAndSurvivesWrongOnes) {
  const auto truth = facing(12, -8, 40);
  const auto cloud = measure(ModelHead(), truth, {});
  AlignmentStart start;
  start.patient_right = truth * Direction<Mri>(Eigen::Vector3d(1, 0.25, 0));
  start.patient_superior = truth * Direction<Mri>(Eigen::Vector3d(0, 0.25, 1));
  expectClose(align(patientsField(), cloud, start), truth, 0.3, 0.15);
  start.patient_right = truth * Direction<Mri>(Eigen::Vector3d(0, 0, 1));  // rolled by 90 degrees
  start.patient_superior = truth * Direction<Mri>(Eigen::Vector3d(-1, 0, 0));
  start.nose_tip = Point<Camera>(200, 200, 500);
  start.guess = facing(0, 0, 0);
  expectClose(align(patientsField(), cloud, start), truth, 0.3, 0.15);
}

TEST(SurfaceAligner, DropsPointsBeyondTheScansEndAndOnHair) {
  const ModelHead head;
  const auto truth = facing(-15, 6, 8);
  const auto cloud = measure(head, truth, {});
  const auto result = align(head.skin(-25), cloud);  // the scan ends at mid-nose
  expectClose(result, truth, 0.6, 0.3);
  for (std::size_t p = 0; p < cloud.size(); ++p) {
    const Eigen::Vector3d at = (truth.inverse() * Point<Camera>(cloud.points_mm[p])).mm;
    if (at.z() < -27) {
      EXPECT_FALSE(result.is_inlier[p]) << at.transpose();
    }
  }
}

TEST(SurfaceAligner, RefusesAnotherPersonsScan) {
  const auto cloud = measure(ModelHead(1), facing(8, 4, 0), {});
  EXPECT_THAT([&] { align(ModelHead(2).skin(), cloud); },
              ThrowsMessage<NotThisPerson>(HasSubstr("not aligned: the face does not fit this MRI")));
}

SkinModel mirrored(SkinModel skin) {
  for (auto& p : skin.points.points_mm) p.x() *= -1;
  for (auto& n : skin.points.normals) n.x() *= -1;
  for (auto& t : skin.triangles) std::swap(t[1], t[2]);
  for (auto& [point, normal] : skin.field_of_view) point.mm.x() *= -1, normal.v.x() *= -1;
  return skin;
}

TEST(SurfaceAligner, RefusesAMirroredScanAndNotTheRightOne) {
  for (const std::uint32_t person : {61u}) {
    const ModelHead head(person);
    const auto truth = facing(8, 4, 0);
    const auto cloud = measure(head, truth, {.seed = person});
    EXPECT_THAT([&] { align(mirrored(head.skin()), cloud); }, ThrowsMessage<Error>(HasSubstr("mirror")))
        << person;
    expectClose(align(head.skin(), cloud), truth, 0.3, 0.15);
  }
}

/// Scales space about the left camera, as cameras with a calibration off by `scale` measure it.
PointCloud<Camera> resized(PointCloud<Camera> cloud, double scale) {
  for (auto& p : cloud.points_mm) p *= scale;
  return cloud;
}

TEST(SurfaceAligner, TellsTheFacesSizeFromTheScans) {
  const auto truth = facing(8, 4, 0);
  const auto cloud = measure(ModelHead(), truth, {.seed = 9});
  const auto right = align(patientsField(), cloud);
  ASSERT_TRUE(right.face_scale);
  EXPECT_NEAR(right.face_scale->value, 1.0, 3 * right.face_scale->sigma + 0.002);
  EXPECT_GT(right.face_scale->sigma, 0.0);
  EXPECT_TRUE(right.cautions.empty()) << right.cautions.front();
  // The pose stays rigid; the size is reported. If it is far off, the face does not fit any more.
  const auto small = align(patientsField(), resized(cloud, 0.988));
  ASSERT_TRUE(small.face_scale);
  EXPECT_NEAR(small.face_scale->value, 0.988, 0.005);
  ASSERT_FALSE(small.cautions.empty());
  EXPECT_THAT(small.cautions.front(), HasSubstr("of the MRI's size"));
  const Eigen::Vector3d target_mm = 0.988 * (truth * kTarget).mm;  // in such cameras' space
  EXPECT_LT(((small.camera_T_mri * kTarget).mm - target_mm).norm(), small.errorBound_mm(kTarget));
  EXPECT_THAT([&] { align(patientsField(), resized(cloud, 1.06)); },
              ThrowsMessage<Error>(HasSubstr("not aligned")));
}

TEST(SurfaceAligner, TheBoundHoldsTheDistanceThatATurnedCameraMistakes) {
  // The right camera turned sideways by about 0.1 deg: the face is measured too near and too small.
  const auto truth = facing(8, 4, 0);
  const auto cloud = measure(ModelHead(), truth, {.seed = 9});
  const auto off_mm = [&](const AlignmentResult& result) {
    return ((result.camera_T_mri * kTarget).mm - (truth * kTarget).mm).norm();
  };
  const auto right = align(patientsField(), cloud), near = align(patientsField(), resized(cloud, 0.993));
  EXPECT_LT(off_mm(right), right.errorBound_mm(kTarget));
  EXPECT_GT(off_mm(near), 3.0) << "the trial is too easy";
  EXPECT_LT(off_mm(near), near.errorBound_mm(kTarget));
  EXPECT_GT(near.errorBound_mm(kTarget), 2.0 * right.errorBound_mm(kTarget));
  ASSERT_FALSE(near.cautions.empty());
  EXPECT_THAT(near.cautions.back(), HasSubstr("turned sideways"));
}

/// Right camera 120 mm beside the left one; the face at some 600 mm.
const TurnableCamera kRight{Point<Camera>(120, 0, 0), Direction<Camera>(Eigen::Vector3d::UnitY())};

/// Measures with a right camera that turned by `deg` since the calibration: exact, along the left rays.
PointCloud<Camera> turned(PointCloud<Camera> cloud, double deg) {
  for (auto& p : cloud.points_mm) {
    const Eigen::Vector3d ray = p.normalized(),
                          seen = expRotation(deg * kRadPerDeg * kRight.axis.v) * (p - kRight.centre.mm);
    p = ray * kRight.centre.mm.cross(seen).dot(kRight.axis.v) / ray.cross(seen).dot(kRight.axis.v);
  }
  return cloud;
}

TEST(SurfaceAligner, TheDisplacementByATurnIsThatOfTheRays) {
  PointCloud<Camera> cloud;
  cloud.points_mm = {{30, -40, 580}, {-50, 60, 620}};
  const auto moved = turned(cloud, 0.01);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_LT((moved.points_mm[i] - cloud.points_mm[i] -
               0.01 * kRadPerDeg * kRight.displacement(cloud.points_mm[i]))
                  .norm(),
              1e-3);  // the second order of half a millimetre at 600
}

bool mentions(const std::vector<std::string>& cautions, const std::string& words) {
  return std::any_of(cautions.begin(), cautions.end(),
                     [&](const std::string& c) { return c.find(words) != std::string::npos; });
}

/// Expects an alignment that states a turn of `deg`: with a caution, and a bound that holds its error.
void expectTurnStated(const AlignmentResult& result, const RigidTransform<Camera, Mri>& truth, double deg) {
  ASSERT_TRUE(result.right_turn);
  EXPECT_NEAR(kDegPerRad * result.right_turn->rad, deg, 3 * kDegPerRad * result.right_turn->sigma_rad);
  EXPECT_TRUE(mentions(result.cautions, "turned sideways")) << deg;
  EXPECT_LT(((result.camera_T_mri * kTarget).mm - (truth * kTarget).mm).norm(), result.errorBound_mm(kTarget))
      << deg;
}

TEST(SurfaceAligner, StatesHowFarTheRightCameraTurnedAndRefusesMoreThanAScanCanExplain) {
  AlignmentStart start;
  start.right = kRight;
  for (const std::uint32_t seed : {1u, 2u}) {
    const auto truth = facing(8, 4, 0);
    const auto cloud = measure(ModelHead(), truth, {.seed = seed});
    const auto stands = align(patientsField(), cloud, start);
    ASSERT_TRUE(stands.right_turn);
    EXPECT_LT(std::abs(stands.right_turn->rad), 3.0 * stands.right_turn->sigma_rad);
    EXPECT_LT(((stands.camera_T_mri * kTarget).mm - (truth * kTarget).mm).norm(),
              stands.errorBound_mm(kTarget));
    // A scan that is 2 % too large or too small looks like a turn of 0.2 deg.
    for (const double deg : {-0.2, 0.2})
      expectTurnStated(align(patientsField(), turned(cloud, deg), start), truth, deg);
    for (const double deg : {-0.6, -0.5, 0.5, 0.6})
      EXPECT_THROW(align(patientsField(), turned(cloud, deg), start), Error) << deg;
  }
}

/// Error of the target under the coil: the marker of a coil on kTarget, measured with a right camera that
/// turned by `deg`, against the head as shown.
double coilOff_mm(const AlignmentResult& shown, const RigidTransform<Camera, Mri>& truth,
                  const std::vector<Point<Mri>>& marker, double deg) {
  PointCloud<Camera> corners;
  std::vector<Eigen::Vector3d> print_mm;
  for (const auto& corner : marker)
    print_mm.push_back(corner.mm), corners.points_mm.push_back((truth * corner).mm);
  const Eigen::Isometry3d seen = fitRigidPoints(print_mm, turned(corners, deg).points_mm).to_T_from;
  return (shown.camera_T_mri.isometry().inverse() * seen * kTarget.mm - kTarget.mm).norm();
}

TEST(SurfaceAligner, ACameraThatTurnedBeforeMovesHeadAndCoilAlike) {
  AlignmentStart start;
  start.right = kRight;
  const auto truth = facing(8, 4, 0);
  const std::vector<Point<Mri>> marker{{-80, 30, 110}, {-80, 30, 170}, {-20, 30, 170}, {-20, 30, 110}};
  const auto cloud = measure(ModelHead(), truth, {.seed = 1});
  const double sigma_deg = kDegPerRad * align(patientsField(), cloud, start).right_turn->sigma_rad;
  for (const double deg : {-1.5 * sigma_deg, 0.0, 1.5 * sigma_deg}) {
    const auto shown = align(patientsField(), turned(cloud, deg), start);
    const double coil_mm = coilOff_mm(shown, truth, marker, deg),
                 bound_mm = shown.coilErrorBound_mm(kTarget, marker);
    EXPECT_LT(coil_mm, bound_mm) << deg;
    EXPECT_LT(bound_mm, 0.5 * shown.errorBound_mm(kTarget)) << "no use if it says too much";
    if (deg == 0.0) continue;
    const double place_mm = ((shown.camera_T_mri * kTarget).mm - (truth * kTarget).mm).norm();
    EXPECT_LT(coil_mm, 0.4 * place_mm) << deg;
    EXPECT_LT(place_mm, shown.errorBound_mm(kTarget)) << deg;
  }
}

TEST(SurfaceAligner, ATurnKnownOtherwiseNarrowsTheBoundOrContradictsTheFace) {
  AlignmentStart start;
  start.right = kRight;
  const auto truth = facing(8, 4, 0);
  const auto cloud = measure(ModelHead(), truth, {.seed = 1});
  const auto alone = align(patientsField(), cloud, start);
  start.known_turn = CameraTurn{0.0, 0.3 * alone.right_turn->sigma_rad};
  const auto both = align(patientsField(), cloud, start);
  EXPECT_LT(both.right_turn->sigma_rad, start.known_turn->sigma_rad);
  EXPECT_LT(both.errorBound_mm(kTarget), 0.5 * alone.errorBound_mm(kTarget));
  EXPECT_LT(((both.camera_T_mri * kTarget).mm - (truth * kTarget).mm).norm(), both.errorBound_mm(kTarget));
  start.known_turn->rad = 0.2 * kRadPerDeg;
  EXPECT_THAT([&] { align(patientsField(), cloud, start); },
              ThrowsMessage<Error>(HasSubstr("turned sideways")));
}

TEST(SurfaceAligner, AMarkerThatSeesNoTurnDoesNotHideTheTurnThatTheFaceSees) {
  AlignmentStart start;
  start.right = kRight;
  const auto truth = facing(8, 4, 0);
  const auto cloud = measure(ModelHead(), truth, {.seed = 1});
  const double sigma_rad = align(patientsField(), cloud, start).right_turn->sigma_rad;
  start.known_turn = CameraTurn{0.0, 0.3 * sigma_rad};  // as measured on a print of another size
  const double deg = 4.5 * kDegPerRad * sigma_rad;
  expectTurnStated(align(patientsField(), turned(cloud, deg), start), truth, deg);
  EXPECT_THROW(align(patientsField(), turned(cloud, 0.5), start), Error);
}

TEST(SurfaceAligner, DepthThatAllPointsShareWidensTheBoundAlongTheView) {
  const auto truth = facing(8, 4, 0);
  const auto cloud = measure(ModelHead(), truth, {});
  AlignmentStart start;
  const double without_mm = align(patientsField(), cloud, start).predictedError_mm(kTarget);
  start.shared_depth_sigma_mm = 0.4;
  const double with_mm = align(patientsField(), cloud, start).predictedError_mm(kTarget);
  EXPECT_NEAR(with_mm, std::hypot(without_mm, 0.4), 1e-6);
}

TEST(SurfaceAligner, RefusesWhatLacksAFaceOrShowsTooLittleOfIt) {
  const auto truth = facing(8, 4, 0);
  const auto cloud = measure(ModelHead(), truth, {});
  SkinModel defaced = ModelHead().skin();
  defaced.has_face = false;
  EXPECT_THAT([&] { align(defaced, cloud); }, ThrowsMessage<Error>(HasSubstr("no face to align to")));
  EXPECT_THAT([&] { align(SkinModel(), cloud); }, ThrowsMessage<Error>(HasSubstr("not aligned")));
  PointCloud<Camera> few = cloud;
  few.points_mm.resize(300);
  EXPECT_THAT([&] { align(patientsField(), few); },
              ThrowsMessage<Error>(HasSubstr("too little of the face")));
  const auto patch = measure(ModelHead(), truth,
                             {.has_hair = false, .has_clothes = false, .least_z_mm = 25, .most_z_mm = 50});
  EXPECT_THAT([&] { align(patientsField(), patch); },
              ThrowsMessage<Error>(HasSubstr("too little of the face")));
}

TEST(IcpAligner, FindsTheHeadAsThePaperDoes) {
  const auto truth = facing(10, -5, 3);
  TaskMonitor monitor;
  AlignmentStart start;
  start.patient_superior = truth * Direction<Mri>(Eigen::Vector3d(0, 0, 1));
  const auto result =
      peers::makeIcpAligner()->align(patientsField(), measure(ModelHead(), truth, {}), start, monitor);
  expectClose(result, truth, 1.0, 0.6);
}

TEST(SurfaceAligner, StopsWhenCancelled) {
  TaskMonitor monitor;
  monitor.cancel();
  const auto cloud = measure(ModelHead(), facing(0, 0, 0), {});
  EXPECT_THROW(makeSurfaceAligner()->align(patientsField(), cloud, {}, monitor), Cancelled);
}

}  // namespace
}  // namespace facenav::registration
