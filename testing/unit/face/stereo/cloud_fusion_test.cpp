// Clouds of a known plane and sphere with known errors, carried by known motions.

#include "facenav/stereo/cloud_fusion.h"

#include <gtest/gtest.h>

#include <random>

#include "support/stereo_scene.h"

using namespace facenav;
using namespace facenav::stereo;
namespace support = facenav::testing;

namespace {

const Eigen::Vector3d kMiddle(0, 0, 660);
constexpr double kRadius_mm = 60, kSigma_mm = 0.4;

Eigen::Isometry3d motionOf(int frame) {
  if (frame == 0) return Eigen::Isometry3d::Identity();
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.translate(Eigen::Vector3d(0.7 * frame, -0.3 * frame, 0.5 * frame) + kMiddle);
  motion.rotate(Eigen::AngleAxisd(0.01 * frame, Eigen::Vector3d::UnitY()));
  motion.translate(-kMiddle);
  return motion;
}

/// Sphere as one frame measures it: its middle moved by `motion`, each point displaced along its ray.
FaceCloud seenAt(const cameras::StereoRig& rig, const Eigen::Isometry3d& motion, unsigned seed,
                 double wrong_share = 0) {
  const auto surface = support::sphere(motion * kMiddle, kRadius_mm);
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, kSigma_mm);
  std::uniform_real_distribution<double> share(0, 1);
  FaceCloud cloud;
  for (int y = 0; y < rig.height_px; ++y)
    for (int x = 0; x < rig.width_px; ++x) {
      const Eigen::Vector3d ray = undistort(rig.left, {double(x), double(y)}).homogeneous().normalized();
      const double t = surface(Eigen::Vector3d::Zero(), ray);
      if (std::isnan(t)) continue;
      const Eigen::Vector3d normal = (t * ray - motion * kMiddle) / kRadius_mm;
      if (-normal.dot(ray) < 0.4) continue;
      const double wrong_mm = share(random) < wrong_share ? 8 : 0;
      cloud.cloud.points_mm.push_back((t + noise(random) + wrong_mm) * ray);
      cloud.cloud.normals.push_back(normal);
      cloud.left_px.emplace_back(float(x), float(y));
      cloud.sigma_mm.push_back(float(kSigma_mm));
    }
  return cloud;
}

FusedCloud fusedOf(const cameras::StereoRig& rig, int frames, double wrong_share = 0) {
  CloudFusion fusion(rig, 0);
  for (int i = 0; i < frames; ++i)
    fusion.add(seenAt(rig, motionOf(i), 10 + unsigned(i), wrong_share), motionOf(i).inverse());
  return fusion.fused();
}

struct Errors {
  double rms_mm = 0, within = 0;  // share within the given deviation
};

Errors errorsOf(const FusedCloud& fused, int least_frames) {
  Errors errors;
  int count = 0;
  for (std::size_t i = 0; i < fused.face.cloud.size(); ++i) {
    const Eigen::Vector3d& p = fused.face.cloud.points_mm[i];
    if (fused.frames[i] < least_frames) continue;
    const auto truth = support::sphere(kMiddle, kRadius_mm)(Eigen::Vector3d::Zero(), p.normalized());
    if (std::isnan(truth)) continue;
    const double off_mm = p.norm() - truth;
    errors.rms_mm += off_mm * off_mm;
    errors.within += std::abs(off_mm) <= fused.face.sigma_mm[i];
    ++count;
  }
  errors.rms_mm = std::sqrt(errors.rms_mm / std::max(1, count));
  errors.within /= std::max(1, count);
  return errors;
}

class Fusion : public ::testing::Test {
 protected:
  const cameras::StereoRig rig = support::cropped(support::convergingRig());
};

}  // namespace

TEST_F(Fusion, OneCloudStaysAsItWasMeasured) {
  const FaceCloud cloud = seenAt(rig, motionOf(0), 1);
  CloudFusion fusion(rig, 0);
  fusion.add(cloud, Eigen::Isometry3d::Identity());
  const FusedCloud fused = fusion.fused();
  ASSERT_EQ(fused.face.cloud.size(), cloud.cloud.size());
  for (std::size_t i = 0; i < cloud.cloud.size(); ++i) {
    ASSERT_LT((fused.face.cloud.points_mm[i] - cloud.cloud.points_mm[i]).norm(), 0.02);
    ASSERT_EQ(fused.face.sigma_mm[i], cloud.sigma_mm[i]);
    ASSERT_EQ(fused.frames[i], 1);
  }
}

TEST_F(Fusion, NineFramesOfAMovingFaceAreAThirdAsNoisyAsOne) {
  const Errors one = errorsOf(fusedOf(rig, 1), 1), nine = errorsOf(fusedOf(rig, 9), 7);
  EXPECT_NEAR(one.rms_mm, kSigma_mm, 0.02);
  EXPECT_LT(nine.rms_mm, 0.4 * kSigma_mm);
  EXPECT_GT(nine.within, 0.65);
}

TEST_F(Fusion, GrossErrorsOfSomeFramesAreLeftOut) {
  const Errors errors = errorsOf(fusedOf(rig, 9, 0.05), 5);
  EXPECT_LT(errors.rms_mm, 0.5 * kSigma_mm);
}

TEST_F(Fusion, NormalsAreUnitAndTowardsTheCamera) {
  const FusedCloud fused = fusedOf(rig, 4);
  for (std::size_t i = 0; i < fused.face.cloud.size(); ++i) {
    const Eigen::Vector3d &p = fused.face.cloud.points_mm[i], &n = fused.face.cloud.normals[i];
    ASSERT_NEAR(n.norm(), 1, 1e-6);
    ASSERT_LT(n.dot(p), 0);
    if (fused.frames[i] >= 3) {
      ASSERT_GT(n.dot((p - kMiddle).normalized()), std::cos(5 * M_PI / 180));
    }
  }
}
