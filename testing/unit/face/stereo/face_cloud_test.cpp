#include "facenav/stereo/face_cloud.h"

#include <gmock/gmock.h>

#include "facenav/core/error.h"
#include "support/stereo_scene.h"

using namespace facenav;
using namespace facenav::stereo;
using ::testing::HasSubstr;
namespace support = facenav::testing;

namespace {

struct CloudAccuracy {
  double rms_mm = 0, bias_mm = 0, normalised = 0, worst_normal_deg = 0, mean_normal_deg = 0;
  int points = 0, outliers = 0;  // outliers: more than 2 mm off along the ray
};

// Compares along the ray of each left pixel; points on the surface at more than `farthest_mm` are not
// counted.
CloudAccuracy compare(const FaceCloud& face, const support::Scene& scene, const cameras::StereoRig& rig,
                      const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& normal_at,
                      double farthest_mm = 1e9) {
  CloudAccuracy a;
  for (std::size_t i = 0; i < face.cloud.size(); ++i) {
    const double truth_mm = scene.distance_mm(rig, face.left_px[i].cast<double>());
    if (std::isnan(truth_mm) || truth_mm > farthest_mm) continue;
    const double error_mm = face.cloud.points_mm[i].norm() - truth_mm;
    ++a.points;
    if (std::abs(error_mm) > 2) {
      ++a.outliers;
      continue;
    }
    a.rms_mm += error_mm * error_mm;
    a.bias_mm += error_mm;
    a.normalised += std::pow(error_mm / face.sigma_mm[i], 2);
    const double cosine = face.cloud.normals[i].dot(normal_at(face.cloud.points_mm[i]));
    a.mean_normal_deg += std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / M_PI;
  }
  const double n = std::max(1, a.points - a.outliers);
  a.rms_mm = std::sqrt(a.rms_mm / n);
  a.bias_mm /= n;
  a.normalised = std::sqrt(a.normalised / n);
  a.mean_normal_deg /= n;
  return a;
}

FaceCloud measure(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                  const FaceCloudOptions& options = {}) {
  TaskMonitor monitor;
  return measureFace(rig, frame, options, monitor);
}

const Eigen::Vector3d kPlaneNormal = Eigen::Vector3d(0.2, 0.1, -1).normalized();

std::string messageOf(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                      const FaceCloudOptions& options = {}) {
  try {
    measure(rig, frame, options);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST(FaceCloud, DottedPlaneIsMeasuredToAFifthOfAMillimetre) {
  const cameras::StereoRig rig = support::cropped(support::convergingRig());
  support::SceneOptions options;
  options.right_gain = 0.85;  // cameras never see skin equally bright
  options.right_offset_grey = 6;
  const support::Scene scene(support::plane({0, 0, 600}, kPlaneNormal), options);
  const FaceCloud face = measure(rig, scene.render(rig));
  const CloudAccuracy a = compare(face, scene, rig, [](const auto&) { return kPlaneNormal; });
  EXPECT_GT(a.points, 0.8 * 320 * 240);
  EXPECT_LT(a.rms_mm, 0.22);  // 0.06 px
  EXPECT_LT(std::abs(a.bias_mm), 0.02);
  EXPECT_LT(a.outliers, a.points / 500);
  EXPECT_LT(a.mean_normal_deg, 2.5);
  EXPECT_GT(a.normalised, 0.5);  // the given sigma is about true
  EXPECT_LT(a.normalised, 2.0);
  EXPECT_LT(face.epipolar_median_px.value(), 0.1);
}

TEST(FaceCloud, VerticalAndRolledRigsMeasureAsWell) {
  for (const cameras::StereoRig& whole : {support::verticalRig(), support::rolledRig()}) {
    const cameras::StereoRig rig = support::cropped(whole);
    const support::Scene scene(support::plane({0, 0, 600}, kPlaneNormal), {});
    const CloudAccuracy a =
        compare(measure(rig, scene.render(rig)), scene, rig, [](const auto&) { return kPlaneNormal; });
    EXPECT_GT(a.points, 0.6 * 320 * 240);
    EXPECT_LT(a.rms_mm, 0.22);
    EXPECT_LT(std::abs(a.bias_mm), 0.02);
  }
}

TEST(FaceCloud, SphereIsNeitherFlattenedNorSwollen) {
  const cameras::StereoRig rig = support::cropped(support::convergingRig());
  const Eigen::Vector3d centre(0, 0, 660);
  const support::Scene scene(
      support::both(support::sphere(centre, 60), support::plane({0, 0, 900}, {0, 0, -1})), {});
  const auto outward = [&](const Eigen::Vector3d& p) -> Eigen::Vector3d { return (p - centre).normalized(); };
  const CloudAccuracy a = compare(measure(rig, scene.render(rig)), scene, rig, outward, 700);
  EXPECT_GT(a.points, 8000);
  EXPECT_LT(a.rms_mm, 0.3);
  EXPECT_LT(std::abs(a.bias_mm), 0.05);
  EXPECT_LT(a.mean_normal_deg, 4.0);
}

TEST(FaceCloud, AKnownSurfaceIsMeasuredWithoutASearch) {
  const cameras::StereoRig rig = support::cropped(support::convergingRig());
  const support::Scene scene(support::plane({0, 0, 600}, kPlaneNormal), {});
  const cameras::StereoFrame frame = scene.render(rig);
  FaceCloudOptions options;
  const FaceCloud searched = measure(rig, frame, options);
  auto known = std::make_shared<PointCloud<Camera>>();
  for (int y = 0; y < rig.height_px; y += 3)
    for (int x = 0; x < rig.width_px; x += 3) {
      const Eigen::Vector2d pixel(x, y);
      const Eigen::Vector3d ray = undistort(rig.left, pixel).homogeneous().normalized();
      known->points_mm.push_back(ray * (scene.distance_mm(rig, pixel) + 1.5));  // 0.4 px beside the truth
    }
  options.expected = known;
  options.match = quickSkinOptions();
  const FaceCloud checked = measure(rig, frame, options);
  const auto normal = [](const auto&) { return kPlaneNormal; };
  EXPECT_GT(checked.cloud.size(), 0.95 * searched.cloud.size());
  EXPECT_LT(compare(checked, scene, rig, normal).rms_mm, 0.22);
  EXPECT_LT(std::abs(compare(checked, scene, rig, normal).bias_mm), 0.03);
}

TEST(FaceCloud, EachMatcherSeesTheSamePlane) {
  const cameras::StereoRig rig = support::cropped(support::convergingRig());
  const support::Scene scene(support::plane({0, 0, 600}, kPlaneNormal), {});
  const auto normal = [](const auto&) { return kPlaneNormal; };
  for (const auto& [name, limit_mm] :
       {std::pair("field", 0.3), std::pair("ssd", 0.3), std::pair("sgm", 0.9)}) {
    const CloudAccuracy a =
        compare(measure(rig, scene.render(rig), dottedFaceOptions(name)), scene, rig, normal);
    EXPECT_GT(a.points, 0.6 * 320 * 240) << name;
    EXPECT_LT(a.rms_mm, limit_mm) << name;
  }
}

TEST(FaceCloud, AnUnknownMatcherIsRefusedWithTheNamesKnown) {
  const cameras::StereoRig rig = support::cropped(support::convergingRig());
  const support::Scene scene(support::plane({0, 0, 600}, kPlaneNormal), {});
  EXPECT_THAT(messageOf(rig, scene.render(rig), dottedFaceOptions("guess")), HasSubstr("field, ssd, sgm"));
}

TEST(FaceCloud, AMatcherThatOnlySearchesIsRefusedOnPlainSkin) {
  const cameras::StereoRig rig = support::cropped(support::convergingRig());
  const support::Scene scene(support::plane({0, 0, 600}, kPlaneNormal), {});
  FaceCloudOptions options = plainFaceOptions();
  options.matcher = "ssd";
  EXPECT_THAT(messageOf(rig, scene.render(rig), options), HasSubstr("'ssd' needs projected dots"));
}

TEST(FaceCloud, RegionOfInterestHoldsAllPoints) {
  const cameras::StereoRig rig = support::cropped(support::convergingRig());
  const support::Scene scene(support::plane({0, 0, 600}, kPlaneNormal), {});
  FaceCloudOptions options;
  options.left_roi = cv::Rect(100, 80, 120, 90);
  const FaceCloud face = measure(rig, scene.render(rig), options);
  EXPECT_GT(face.cloud.size(), 5000u);
  for (const auto& pixel : face.left_px) {
    ASSERT_TRUE(pixel.x() >= 100 && pixel.x() <= 219 && pixel.y() >= 80 && pixel.y() <= 169);
  }
}

TEST(FaceCloud, CamerasThatHaveMovedShowInTheEpipolarError) {
  const cameras::StereoRig rig = support::cropped(support::convergingRig());
  const support::Scene scene(support::plane({0, 0, 600}, kPlaneNormal), {});
  const cameras::StereoFrame frame = scene.render(rig);
  const auto tilted = [&](double by_px) {  // since the calibration
    cameras::StereoRig moved = rig;
    const Eigen::Isometry3d tilt = expRigid((Vector6d() << by_px / 800, 0, 0, 0, 0, 0).finished());
    moved.right_T_left =
        RigidTransform<RightCamera, Camera>::fromIsometry(tilt * rig.right_T_left.isometry());
    return moved;
  };
  EXPECT_LT(measure(rig, frame).epipolar_median_px.value(), 0.05);
  EXPECT_NEAR(measure(tilted(0.3), frame).epipolar_median_px.value(), 0.3, 0.1);
  EXPECT_THAT(messageOf(tilted(4.0), frame), HasSubstr("by 4.0 px across the rows"));
}

TEST(FaceCloud, RefusesWhatCannotBeMeasured) {
  const cameras::StereoRig rig = support::cropped(support::convergingRig());
  cameras::StereoFrame frame;
  EXPECT_THAT(messageOf(rig, frame), HasSubstr("no left image"));
  frame.left = cv::Mat(240, 320, CV_8U, cv::Scalar(0));
  frame.right = frame.left.clone();
  EXPECT_THAT(messageOf(rig, frame), HasSubstr("black"));
  frame.left.setTo(120);
  frame.right.setTo(120);
  EXPECT_THAT(messageOf(rig, frame), HasSubstr("no dots found"));
  frame.right = cv::Mat(200, 320, CV_8U, cv::Scalar(120));
  EXPECT_THAT(messageOf(rig, frame), HasSubstr("320 x 200"));
  cv::RNG random{std::uint64_t(1)};
  frame.right = frame.left.clone();
  random.fill(frame.left, cv::RNG::UNIFORM, 0, 255);
  random.fill(frame.right, cv::RNG::UNIFORM, 0, 255);
  EXPECT_THAT(messageOf(rig, frame), HasSubstr("no dots found"));
}

TEST(FaceCloud, SwappedImagesAreRecognised) {
  const cameras::StereoRig rig = support::cropped(support::convergingRig());
  const support::Scene scene(support::plane({0, 0, 600}, kPlaneNormal), {});
  cameras::StereoFrame frame = scene.render(rig);
  std::swap(frame.left, frame.right);
  EXPECT_THAT(messageOf(rig, frame), HasSubstr("swapped"));
}

TEST(FaceCloud, CancelStopsIt) {
  const cameras::StereoRig rig = support::cropped(support::convergingRig());
  const support::Scene scene(support::plane({0, 0, 600}, kPlaneNormal), {});
  TaskMonitor monitor;
  monitor.cancel();
  EXPECT_THROW(measureFace(rig, scene.render(rig), {}, monitor), Cancelled);
}
