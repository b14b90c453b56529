#include <gtest/gtest.h>

#include <opencv2/aruco.hpp>

#include "egg_patient.h"
#include "facenav/room/scenario.h"
#include "facenav/room/synthetic_source.h"

namespace facenav::room {
namespace {

/// Coil tangent to the egg where a ray from its centre leaves it, handle to posterior and outward.
RigidTransform<Mri, frames::Target> targetAlong(const Eigen::Vector3d& out, double handle_to_side) {
  const Eigen::Vector3d middle(2.0, 5.0, -10.0), radii(75.0, 95.0, 110.0);
  const Eigen::Vector3d from_middle = out / out.cwiseQuotient(radii).norm();
  const Eigen::Vector3d z = -from_middle.cwiseQuotient(radii.cwiseProduct(radii)).normalized();
  const Eigen::Vector3d away(handle_to_side, 1.0, 0.0);
  const Eigen::Vector3d y = (away - away.dot(z) * z).normalized();
  Eigen::Matrix3d axes;
  axes << y.cross(z), y, z;
  return {Eigen::Quaterniond(axes), middle + from_middle - 5.0 * z};
}

std::vector<int> markersIn(const cv::Mat& image) {
  std::vector<std::vector<cv::Point2f>> corners;
  std::vector<int> ids;
  cv::aruco::detectMarkers(image, cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_50), corners, ids);
  return ids;
}

struct Place {
  const char* name;
  Eigen::Vector3d out;
  double handle_to_side;
};

class CoilMount : public ::testing::TestWithParam<Place> {};

TEST_P(CoilMount, BothCamerasSeeTheMarkerWhileTheCoilIsOnItsTarget) {
  ScenarioOptions options;
  options.name = "treatment";
  options.frames = 2;  // the second frame is on target
  SyntheticSource source(options, testing::eggPatient(),
                         targetAlong(GetParam().out, GetParam().handle_to_side));
  source.next();
  const auto frame = source.next();
  EXPECT_EQ(markersIn(frame->left), std::vector<int>{7});
  EXPECT_EQ(markersIn(frame->right), std::vector<int>{7});
  EXPECT_GT(source.truth().face_visible_fraction, 0.75) << "the plate stands before the face";
}

INSTANTIATE_TEST_SUITE_P(Targets, CoilMount,
                         ::testing::Values(Place{"hand_area_left", {-0.58, -0.08, 0.81}, 1.0},
                                           Place{"hand_area_left_further_back", {-0.50, -0.35, 0.80}, 1.0},
                                           Place{"hand_area_right", {0.58, -0.08, 0.81}, -1.0},
                                           Place{"foot_area", {-0.05, -0.15, 0.98}, 1.0},
                                           // Regression: here the coil's own wing covered the white border at
                                           // one place.
                                           Place{"behind_the_crown", {0.03, -0.23, 0.97}, 1.0},
                                           Place{"dorsolateral_prefrontal_left", {-0.55, 0.55, 0.63}, 1.0},
                                           Place{"face_area_left", {-0.85, 0.05, 0.52}, 1.0}),
                         [](const auto& place) { return place.param.name; });

}  // namespace
}  // namespace facenav::room
