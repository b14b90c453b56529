#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "facenav/core/error.h"
#include "facenav/geometry/pose_error.h"
#include "model_head.h"

namespace facenav::registration {
namespace {

using facenav::testing::CameraView;
using facenav::testing::facing;
using facenav::testing::measure;
using facenav::testing::ModelHead;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double kDeg = M_PI / 180;
const Point<Mri> kTarget(-40, -10, 60);  // cortex under the coil

AlignmentResult align(const SkinModel& skin, const PointCloud<Camera>& face,
                      const AlignmentStart& start = {}) {
  TaskMonitor monitor;
  return makeSurfaceAligner()->align(ScalpField(skin), face, start, monitor);
}

void expectClose(const AlignmentResult& result, const RigidTransform<Camera, Mri>& truth, double most_mm,
                 double most_deg) {
  const PoseError error = poseError(result.camera_T_mri, truth, kTarget);
  EXPECT_LT(error.at_point_mm, most_mm);
  EXPECT_LT(error.rotation_rad / kDeg, most_deg);
  EXPECT_LT(error.at_point_mm, 2 * result.predictedError_mm(kTarget));
}

TEST(SurfaceAligner, NeedsNoStartAndNoUprightCamera) {
  const ModelHead head;
  const SkinModel skin = head.skin();
  int seed = 0;
  for (const auto& truth :
       {facing(25, -12, 5, {50, -40, 60}), facing(-28, 14, -95), facing(10, 5, 170, {-60, 30, -80})})
    expectClose(align(skin, measure(head, truth, {.seed = std::uint32_t(++seed)})), truth, 0.3, 0.15);
}

TEST(SurfaceAligner, UsesHintsAndSurvivesWrongOnes) {
  const ModelHead head;
  const auto truth = facing(12, -8, 40);
  const auto cloud = measure(head, truth, {});
  AlignmentStart start;
  start.patient_right = truth * Direction<Mri>(Eigen::Vector3d(1, 0.25, 0));
  start.patient_superior = truth * Direction<Mri>(Eigen::Vector3d(0, 0.25, 1));
  expectClose(align(head.skin(), cloud, start), truth, 0.3, 0.15);
  start.patient_right = truth * Direction<Mri>(Eigen::Vector3d(0, 0, 1));  // rolled by 90 degrees
  start.patient_superior = truth * Direction<Mri>(Eigen::Vector3d(-1, 0, 0));
  start.nose_tip = Point<Camera>(200, 200, 500);
  start.guess = facing(0, 0, 0);
  expectClose(align(head.skin(), cloud, start), truth, 0.3, 0.15);
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

TEST(SurfaceAligner, RefusesAndSaysWhy) {
  const ModelHead patient(1), other(2);
  const auto truth = facing(8, 4, 0);
  const auto cloud = measure(patient, truth, {});
  EXPECT_THAT([&] { align(other.skin(), cloud); },
              ThrowsMessage<Error>(HasSubstr("not aligned: the face does not fit this MRI")));

  SkinModel mirrored = patient.skin();
  for (auto& p : mirrored.points.points_mm) p.x() *= -1;
  for (auto& n : mirrored.points.normals) n.x() *= -1;
  for (auto& t : mirrored.triangles) std::swap(t[1], t[2]);
  EXPECT_THAT([&] { align(mirrored, cloud); }, ThrowsMessage<Error>(HasSubstr("mirrored")));

  SkinModel defaced = patient.skin();
  defaced.has_face = false;
  EXPECT_THAT([&] { align(defaced, cloud); }, ThrowsMessage<Error>(HasSubstr("no face to align to")));

  PointCloud<Camera> few = cloud;
  few.points_mm.resize(300);
  EXPECT_THAT([&] { align(patient.skin(), few); }, ThrowsMessage<Error>(HasSubstr("too little of the face")));
  EXPECT_THAT([&] { align(SkinModel(), cloud); }, ThrowsMessage<Error>(HasSubstr("not aligned")));

  const auto patch =
      measure(patient, truth, {.has_hair = false, .has_clothes = false, .least_z_mm = 25, .most_z_mm = 50});
  EXPECT_THAT([&] { align(patient.skin(), patch); },
              ThrowsMessage<Error>(HasSubstr("too little of the face")));
}

TEST(SurfaceAligner, PredictsItsErrorOnASkinThatFitsUnevenly) {
  // The live skin differs from the scan's smoothly by about 0.3 mm (person bumps of another seed, scaled
  // down).
  const ModelHead scanned;
  int within = 0, all = 0;
  for (std::uint32_t seed = 10; seed < 14; ++seed) {
    ModelHead live = scanned;
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    for (int b = 0; b < 60; ++b)
      live.bumps.push_back(
          {facenav::testing::towards(50 * normal(random), 35 * normal(random)), 0.25 * normal(random), 0.15});
    const auto truth = facing(15 * std::sin(seed), 8 * std::cos(seed), 0);
    const auto result = align(scanned.skin(), measure(live, truth, {.seed = seed}));
    const double error_mm = poseError(result.camera_T_mri, truth, kTarget).at_point_mm;
    EXPECT_LT(error_mm, 1.0);
    EXPECT_LT(result.predictedError_mm(kTarget), 1.0) << "no use if it says too much";
    within += error_mm < 2 * result.predictedError_mm(kTarget);
    ++all;
  }
  EXPECT_GE(within, all - 1);
}

TEST(IcpAligner, FindsTheHeadAsThePaperDoes) {
  const ModelHead head;
  const auto truth = facing(10, -5, 3);
  TaskMonitor monitor;
  AlignmentStart start;
  start.patient_superior = truth * Direction<Mri>(Eigen::Vector3d(0, 0, 1));
  const auto result =
      makeIcpAligner()->align(ScalpField(head.skin()), measure(head, truth, {}), start, monitor);
  expectClose(result, truth, 1.0, 0.6);
}

TEST(SurfaceAligner, StopsWhenCancelled) {
  const ModelHead head;
  TaskMonitor monitor;
  monitor.cancel();
  EXPECT_THROW(
      makeSurfaceAligner()->align(ScalpField(head.skin()), measure(head, facing(0, 0, 0), {}), {}, monitor),
      Cancelled);
}

}  // namespace
}  // namespace facenav::registration
