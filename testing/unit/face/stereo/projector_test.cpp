// Gray code with phase shift on a rendered scene, and the calibration of a projector with known truth.

#include <gmock/gmock.h>

#include <opencv2/imgproc.hpp>

#include "facenav/core/error.h"
#include "facenav/geometry/rotation.h"
#include "facenav/stereo/projector_calibration.h"
#include "support/stereo_rigs.h"

namespace facenav::stereo {
namespace {

using ::testing::HasSubstr;

const ProjectorCode kCode{1024, 768, 16};

cameras::ProjectorModel trueProjector() {
  cameras::ProjectorModel projector;
  projector.width_px = kCode.width_px;
  projector.height_px = kCode.height_px;
  projector.lens.k = cv::Matx33d(1500, 0, 520, 0, 1495, 700, 0, 0, 1);
  projector.lens.distortion = (cv::Mat_<double>(1, 5) << -0.05, 0, 0, 0, 0);
  projector.projector_T_camera =
      RigidTransform<Projector, Camera>(Eigen::Quaterniond(expRotation({0.16, -0.05, 0.02})), {-40, 160, 30});
  return projector;
}

cameras::StereoRig cameraPair() {
  cameras::StereoRig rig;
  rig.width_px = 640;
  rig.height_px = 480;
  rig.left.k = cv::Matx33d(800, 0, 322, 0, 802, 238, 0, 0, 1);
  rig.right.k = cv::Matx33d(805, 0, 318, 0, 804, 243, 0, 0, 1);
  rig.left.distortion = rig.right.distortion = (cv::Mat_<double>(1, 4) << -0.1, 0.05, 0, 0);
  rig.right_T_left =
      RigidTransform<RightCamera, Camera>(Eigen::Quaterniond(expRotation({0, 0.1, 0.01})), {-120, 1, 8});
  return rig;
}

/// A plane of the scene: n p = d in Camera, mm.
struct ScenePlane {
  Eigen::Vector3d n;
  double d;
};

/// Projector pixel that lights each pixel of a camera. Of two planes the nearer one is seen.
cv::Mat lightMap(const cameras::StereoRig& rig, bool is_left, const std::vector<ScenePlane>& planes) {
  const auto projector = trueProjector();
  const Eigen::Isometry3d camera_T_eye =
      is_left ? Eigen::Isometry3d::Identity() : rig.right_T_left.inverse().isometry();
  cv::Mat map(rig.height_px, rig.width_px, CV_32FC2);
  for (int y = 0; y < map.rows; ++y)
    for (int x = 0; x < map.cols; ++x) {
      const Eigen::Vector2d ray = cameras::undistort(is_left ? rig.left : rig.right, {double(x), double(y)});
      const Eigen::Vector3d origin = camera_T_eye.translation(),
                            direction = camera_T_eye.linear() * ray.homogeneous();
      double nearest = 1e9;
      for (const auto& plane : planes) {
        const double t = (plane.d - plane.n.dot(origin)) / plane.n.dot(direction);
        if (t > 0) nearest = std::min(nearest, t);
      }
      const Eigen::Vector3d point = origin + nearest * direction;
      const Eigen::Vector2d pixel =
          cameras::project(projector.lens, projector.projector_T_camera.isometry() * point);
      map.at<cv::Vec2f>(y, x) = {float(pixel.x()), float(pixel.y())};
    }
  return map;
}

struct Light {
  double gain = 0.6, ambient_grey = 25, blur_px = 0.6, noise_grey = 1.5;
};

std::vector<cv::Mat> photographs(const cv::Mat& map, const Light& light, int seed) {
  cv::RNG random(std::uint64_t(seed) + 1);
  std::vector<cv::Mat> all;
  for (const auto& picture : codePictures(kCode)) {
    cv::Mat soft, seen, noise(map.size(), CV_32F), grey;
    cv::GaussianBlur(picture, soft, {}, light.blur_px);
    cv::remap(soft, seen, map, {}, cv::INTER_LINEAR, cv::BORDER_CONSTANT, 0);
    seen.convertTo(seen, CV_32F, light.gain, light.ambient_grey);
    random.fill(noise, cv::RNG::NORMAL, 0, light.noise_grey);
    seen += noise;
    seen.convertTo(grey, CV_8U);
    all.push_back(grey);
  }
  return all;
}

/// A wedge of two planes, like an open book.
const std::vector<ScenePlane> kWedge = {{Eigen::Vector3d(0.5, 0.1, 0.86).normalized(), 520},
                                        {Eigen::Vector3d(-0.45, 0.15, 0.88).normalized(), 540}};

std::vector<LitPlace> litPlaces(const std::vector<ScenePlane>& planes, const Light& light = {}) {
  const auto rig = cameraPair();
  return matchCodes(rig, decode(photographs(lightMap(rig, true, planes), light, 1), kCode),
                    decode(photographs(lightMap(rig, false, planes), light, 2), kCode), 3);
}

TEST(ProjectorCode, EveryPlaceTellsItsProjectorPixel) {
  const auto map = lightMap(cameraPair(), true, kWedge);
  const auto decoded = decode(photographs(map, {}, 1), kCode);
  EXPECT_TRUE(decoded.advice().empty()) << decoded.advice().front();
  int lit = 0, seen = 0, wrong = 0;
  double squares = 0;
  for (int y = 0; y < map.rows; ++y)
    for (int x = 0; x < map.cols; ++x) {
      const cv::Vec2f place = decoded.place.at<cv::Vec2f>(y, x), truth = map.at<cv::Vec2f>(y, x);
      lit += truth[0] > 4 && truth[1] > 4 && truth[0] < 1019 && truth[1] < 763;
      if (std::isnan(place[0])) continue;
      ++seen;
      const double error = cv::norm(place - truth);
      wrong += error > 2;
      if (error <= 2) squares += error * error;
    }
  EXPECT_GT(seen, 0.97 * lit);
  EXPECT_LT(wrong, seen / 2000);
  std::printf("%d places, %d wrong, %.3f px\n", seen, wrong, std::sqrt(squares / seen));
  EXPECT_LT(std::sqrt(squares / seen), 0.12);  // px, with noise of 1.5 grey levels
}

TEST(ProjectorCode, SaysWhatIsWrongWithTheLight) {
  const auto map = lightMap(cameraPair(), true, kWedge);
  const auto wordsOf = [&](const Light& light) {
    const auto advice = decode(photographs(map, light, 1), kCode).advice();
    return advice.empty() ? std::string() : advice.front();
  };
  EXPECT_THAT(wordsOf({0.0, 40, 0.6, 1.5}), HasSubstr("not seen"));
  EXPECT_THAT(wordsOf({0.09, 40, 0.6, 1.5}), HasSubstr("too dim"));
  EXPECT_THAT(wordsOf({1.2, 60, 0.6, 1.5}), HasSubstr("too bright"));
  EXPECT_THAT(wordsOf({0.6, 25, 5.0, 1.5}), HasSubstr("out of focus"));
}

TEST(ProjectorCode, PicturesThatAreMissingAreRefused) {
  auto pictures = codePictures(kCode);
  EXPECT_EQ(pictures.size(), 24u);
  pictures.pop_back();
  EXPECT_THROW(decode(pictures, kCode), Error);
}

TEST(ProjectorCalibration, FindsTheKnownProjector) {
  const auto result = calibrateProjector(litPlaces(kWedge), kCode);
  const auto truth = trueProjector();
  EXPECT_GT(result.places, 2000);
  EXPECT_LT(result.rms_px, 0.4);
  EXPECT_LT(result.held_out_px, 0.4);
  // Checks the light at the middle of the head, and 60 mm around.
  for (const Eigen::Vector3d& at :
       {Eigen::Vector3d(0, 0, 560), {50, 20, 540}, {-40, -40, 520}, {0, 30, 600}}) {
    const auto wanted = cameras::project(truth.lens, truth.projector_T_camera.isometry() * at),
               found = cameras::project(result.projector.lens,
                                        result.projector.projector_T_camera.isometry() * at);
    EXPECT_LT((wanted - found).norm(), 0.5) << at.transpose();
  }
}

TEST(ProjectorCalibration, OnePlaneIsNotEnough) {
  try {
    calibrateProjector(litPlaces({{Eigen::Vector3d(0.1, 0.1, 1).normalized(), 560}}), kCode);
    FAIL() << "a plane does not determine a projector";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("one plane"));
  }
  EXPECT_THROW(calibrateProjector({}, kCode), Error);
}

TEST(ProjectorCalibration, TwoDistancesOfAPlaneAreEnough) {
  auto places = litPlaces({{Eigen::Vector3d(0.1, 0.1, 1).normalized(), 520}});
  const auto farther = litPlaces({{Eigen::Vector3d(-0.15, 0.05, 1).normalized(), 620}});
  places.insert(places.end(), farther.begin(), farther.end());
  EXPECT_LT(calibrateProjector(places, kCode).rms_px, 0.4);
}

}  // namespace
}  // namespace facenav::stereo
