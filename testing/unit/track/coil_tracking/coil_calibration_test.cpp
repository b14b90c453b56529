#include "facenav/coil_tracking/coil_calibration.h"

#include <gtest/gtest.h>

#include <random>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/geometry/rotation.h"
#include "support/matchers.h"
#include "support/test_data.h"

namespace facenav::coil_tracking {
namespace {
using facenav::testing::PoseNear;

RigidTransform<Marker, Coil> mount() {
  return {Eigen::Quaterniond(expRotation({0.3, -0.2, 0.5})), {12, -35, 60}};
}

class Hand {
 public:
  explicit Hand(unsigned seed) : random_(seed) {}
  Eigen::Vector3d noise(double sigma) {
    std::normal_distribution<double> normal(0, sigma);
    return {normal(random_), normal(random_), normal(random_)};
  }
  /// Adds an error of 0.1 mm and 0.1 degrees to a pose.
  template <class To, class From>
  RigidTransform<To, From> measured(const RigidTransform<To, From>& truth) {
    Eigen::Isometry3d pose = truth.isometry();
    pose.linear() = pose.linear() * expRotation(noise(1.7e-3 / std::sqrt(3.0)));
    pose.translation() += noise(0.1 / std::sqrt(3.0));
    return RigidTransform<To, From>::fromIsometry(pose);
  }
  RigidTransform<Camera, Coil> somewhere() {
    return {Eigen::Quaterniond(expRotation(noise(0.4))), Eigen::Vector3d(0, 0, 600) + noise(40)};
  }
  /// Poses of a coil whose point (Coil, mm) stays on the tip (Camera) while it is turned by some 25 degrees.
  std::vector<RigidTransform<Camera, Marker>> pivoting(const Eigen::Vector3d& point_mm, int frames,
                                                       double turn_rad) {
    const Eigen::Vector3d tip_mm(20, 30, 580);
    std::vector<RigidTransform<Camera, Marker>> poses;
    for (int i = 0; i < frames; ++i) {
      const Eigen::Matrix3d r = expRotation(noise(turn_rad));
      const RigidTransform<Camera, Coil> coil{Eigen::Quaterniond(r), tip_mm - r * point_mm};
      poses.push_back(measured(coil * mount().inverse()));
    }
    return poses;
  }

 private:
  std::mt19937 random_;
};

TEST(CoilCalibration, AJigGivesTheMount) {
  const RigidTransform<Coil, Marker> coil_T_jig{Eigen::Quaterniond(expRotation({0, 0.1, 1.2})), {70, 5, 10}};
  Hand hand(1);
  std::vector<JigObservation> observations;
  for (int i = 0; i < 80; ++i) {
    const auto camera_T_coil = hand.somewhere();
    observations.push_back(
        {hand.measured(camera_T_coil * mount().inverse()), hand.measured(camera_T_coil * coil_T_jig)});
  }
  observations[7].camera_T_jig = hand.somewhere() * coil_T_jig;  // one frame with a gross error
  const auto result = calibrateWithJig(observations, coil_T_jig);
  EXPECT_EQ(result.used, 79);
  EXPECT_THAT(result.marker_T_coil, PoseNear(mount(), 0.06, 0.12));
  const PoseError error = poseError(result.marker_T_coil, mount());
  EXPECT_LT(error.translation_mm, 3 * result.sigma_mm);
  EXPECT_LT(error.rotation_rad * 180 / M_PI, 3 * result.sigma_deg);
  EXPECT_GT(result.rms_mm, 0.1);
  EXPECT_THROW(calibrateWithJig({observations.begin(), observations.begin() + 3}, coil_T_jig), Error);
}

TEST(CoilCalibration, PivotingGivesCentreAndAxes) {
  Hand hand(2);
  const auto centre = fitPivot(hand.pivoting({0, 0, 0}, 150, 0.35)),
             handle = fitPivot(hand.pivoting({0, -90, 0}, 150, 0.35)),
             right = fitPivot(hand.pivoting({60, 15, 0}, 150, 0.35));
  const auto result = calibrateWithPivots(centre, handle, right);
  EXPECT_THAT(result.marker_T_coil, PoseNear(mount(), 0.1, 0.1));
  EXPECT_LT(poseError(result.marker_T_coil, mount()).translation_mm, 3 * result.sigma_mm);
  EXPECT_LT(result.rms_mm, 0.4);
}

TEST(CoilCalibration, RefusesAPivotThatWasHardlyTurned) {
  Hand hand(3);
  EXPECT_THROW(fitPivot(hand.pivoting({0, 0, 0}, 150, 0.03)), Error);
  EXPECT_THROW(fitPivot(hand.pivoting({0, 0, 0}, 5, 0.35)), Error);
  const auto centre = fitPivot(hand.pivoting({0, 0, 0}, 60, 0.35));
  EXPECT_THROW(calibrateWithPivots(centre, fitPivot(hand.pivoting({0, -90, 0}, 60, 0.35)),
                                   fitPivot(hand.pivoting({0, 80, 0}, 60, 0.35))),
               Error)
      << "in one line";
}

TEST(CoilCalibration, IsKeptInCoilJson) {
  const facenav::testing::TemporaryFolder folder;
  CoilCalibration calibration;
  calibration.marker_T_coil = mount();
  calibration.method = "jig";
  calibration.sigma_mm = 0.03;
  writeCalibratedCoil(defaultCoil(), calibration, folder.path() / "coil.json");
  EXPECT_THAT(readCoil(folder.path() / "coil.json").marker_T_coil(), PoseNear(mount(), 1e-6, 1e-6));
  EXPECT_NE(readWholeFile(folder.path() / "coil.json").find("\"sigma_mm\": 0.03"), std::string::npos);
}

}  // namespace
}  // namespace facenav::coil_tracking
