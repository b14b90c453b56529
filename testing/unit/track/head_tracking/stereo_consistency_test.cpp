#include "head/stereo_consistency.h"

#include <gtest/gtest.h>

#include <random>

namespace facenav::head_tracking {
namespace {

/// Patches on a face of 120 mm at 600 mm, in two cameras of 800 px, 120 mm apart; 5 x 6 parts of the face.
class FaceOfTwo {
 public:
  explicit FaceOfTwo(unsigned seed) : random_(seed) {}

  SidesFit fit(const Vector6d& xi, const Vector6d& zeta, double noise_px = 0.1) {
    StereoConsistency evidence(30);
    std::normal_distribution<double> normal(0.0, noise_px);
    for (int i = 0; i < 240; ++i) {
      const Eigen::Vector3d p_mm(uniform(-60, 60), uniform(-70, 70), uniform(-30, 30));
      const int part = int((p_mm.x() + 60) / 24.001) + 5 * int((p_mm.y() + 70) / 23.334);
      for (int c = 0; c < 2; ++c) {
        const Eigen::Matrix<double, 2, 6> j = jacobian(c, p_mm);
        const Eigen::Vector2d off = j * xi + (c == 1 ? Eigen::Vector2d(j * zeta) : Eigen::Vector2d(0, 0)) +
                                    Eigen::Vector2d(normal(random_), normal(random_));
        const Eigen::Matrix<float, 2, 6> none = Eigen::Matrix<float, 2, 6>::Zero();
        evidence.add(part, j.cast<float>(), c == 1 ? Eigen::Matrix<float, 2, 6>(j.cast<float>()) : none,
                     off.cast<float>(), Eigen::Matrix2f::Identity() / float(noise_px * noise_px));
      }
    }
    return evidence.solve().value();
  }

 private:
  static Eigen::Matrix<double, 2, 6> jacobian(int c, const Eigen::Vector3d& p_mm) {
    const Eigen::Vector3d at_mm = p_mm + Eigen::Vector3d(c == 0 ? 0.0 : -120.0, 0.0, 600.0);
    Eigen::Matrix<double, 2, 3> d_p;
    d_p << 800 / at_mm.z(), 0, -800 * at_mm.x() / (at_mm.z() * at_mm.z()), 0, 800 / at_mm.z(),
        -800 * at_mm.y() / (at_mm.z() * at_mm.z());
    Eigen::Matrix<double, 2, 6> j;
    j << d_p * -skew(p_mm), d_p;
    return j;
  }
  double uniform(double low, double high) { return low + (high - low) * double(random_() >> 11) * 0x1p-53; }
  std::mt19937_64 random_;
};

/// Apparent motion by a rotation of the right camera about its vertical axis: (rad, mm) about the face's
/// centre.
Vector6d byYaw(double deg) {
  const double rad = deg * kRadPerDeg;
  Vector6d zeta = Vector6d::Zero();
  zeta[1] = rad, zeta[3] = 600.0 * rad, zeta[5] = 120.0 * rad;
  return zeta;
}

TEST(StereoConsistency, SeesEachAxisOfTheRightCamera) {
  FaceOfTwo face(3);
  for (int axis = 0; axis < 6; ++axis) {
    Vector6d zeta = Vector6d::Zero(), xi;
    zeta[axis] = axis < 3 ? 0.3 * kRadPerDeg : 1.0;
    xi << 1e-3, -5e-4, 2e-4, 0.1, -0.2, 0.15;
    const SidesFit fit = face.fit(xi, zeta, 0.02);
    for (int i = 0; i < 6; ++i)
      EXPECT_NEAR(fit.zeta[i], zeta[i], 4 * std::sqrt(fit.covariance(i, i))) << axis << " " << i;
  }
}

TEST(StereoConsistency, AYawOfATwentiethOfADegreeIsBeyondItsError) {
  FaceOfTwo face(5);
  const SidesFit turned = face.fit(Vector6d::Zero(), byYaw(0.05));
  EXPECT_GT(turned.zeta.dot(turned.covariance.inverse() * turned.zeta), 20.1);
}

TEST(StereoConsistency, StatesItsErrorHonestly) {
  FaceOfTwo face(11);
  double squares = 0;
  constexpr int kTrials = 60;
  for (int i = 0; i < kTrials; ++i) {
    const SidesFit fit = face.fit(Vector6d::Zero(), Vector6d::Zero());
    squares += fit.zeta.dot(fit.covariance.inverse() * fit.zeta) / 6.0 / kTrials;
  }
  EXPECT_LT(squares, 1.2);
  EXPECT_GT(squares, 0.2);
}

TEST(StereoConsistency, SaysNothingOfAFewPartsOfAFace) {
  StereoConsistency evidence(30);
  for (int part = 0; part < 10; ++part)
    evidence.add(part, Eigen::Matrix<float, 2, 6>::Ones(), Eigen::Matrix<float, 2, 6>::Ones(),
                 Eigen::Vector2f(1, 1), Eigen::Matrix2f::Identity());
  EXPECT_FALSE(evidence.solve().has_value());
}

}  // namespace
}  // namespace facenav::head_tracking
