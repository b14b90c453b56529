// Coils with several markers, and ARToolKit patterns.
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "facenav/core/whole_file.h"
#include "support/matchers.h"
#include "support/test_data.h"
#include "tracked_once.h"

namespace facenav::coil_tracking {
namespace {
using namespace testing;
using facenav::testing::PoseNear;

CoilModel twoMarkers() {
  CoilModel coil = defaultCoil();
  coil.markers[0].coil_T_marker = {Eigen::Quaterniond::Identity(), {-40, 0, 0}};
  coil.markers.push_back(
      {"5x5_100",
       31,
       {},
       45.0,
       0.1,
       {Eigen::Quaterniond(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitY())), {40, 0, 10}}});
  return coil;
}

TEST(CoilTracker, AnyOfSeveralMarkersGivesTheFirstOnesPose) {
  const auto rig = roomRig();
  const CoilModel coil = twoMarkers();
  const auto camera_T_coil =
      markerPose(600, 15, 70, 10).reframe<Camera, Coil>();  // the pose that the scene uses
  const auto first = camera_T_coil * coil.markers[0].coil_T_marker,
             second = camera_T_coil * coil.markers[1].coil_T_marker;
  const PlacedPrint print_a{id7(), 60, first}, print_b{arucoPrint(cv::aruco::DICT_5X5_100, 31), 45, second};
  for (const auto& prints : std::vector<std::vector<PlacedPrint>>{{print_a}, {print_b}, {print_a, print_b}}) {
    const auto pose = trackOnce(rig, renderMarkers(rig, prints), coil);
    ASSERT_TRUE(pose);
    EXPECT_THAT(pose->camera_T_marker, PoseNear(first, 0.35, 0.5));
  }
}

/// A 16 x 16 picture without symmetry, as a .patt file and as a print (border a quarter of the side).
struct Picture {
  Print print;
  std::string patt;
};

Picture picture(unsigned seed) {
  cv::RNG random(seed);
  cv::Mat_<float> small(4, 4), inner;
  random.fill(small, cv::RNG::UNIFORM, 0.0, 1.0);
  cv::resize(small, inner, {16, 16}, 0, 0, cv::INTER_CUBIC);
  inner = cv::max(cv::min(inner, 1.0), 0.0);
  Picture made;
  made.print = Print::zeros(32, 32);
  inner.copyTo(made.print(cv::Rect(8, 8, 16, 16)));
  for (int turn = 0; turn < 4; ++turn) {
    for (int plane = 0; plane < 3; ++plane)
      for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 16; ++x) made.patt += std::to_string(int(std::lround(255 * inner(y, x)))) + " ";
        made.patt += "\n";
      }
    made.patt += "\n";
    cv::rotate(inner, inner, cv::ROTATE_90_COUNTERCLOCKWISE);
  }
  return made;
}

TEST(CoilTracker, RecognisesArToolKitPatterns) {
  const facenav::testing::TemporaryFolder folder;
  const Picture mine = picture(5), other = picture(9);
  writeWholeFile(folder.path() / "coil.patt", mine.patt);
  CoilModel coil = defaultCoil();
  coil.markers[0].pattern = folder.path() / "coil.patt";
  const auto rig = roomRig();
  for (const double turn_deg : {0.0, 95.0, 180.0, 260.0}) {
    const auto truth = markerPose(600, 25, 70, turn_deg);
    const auto pose = trackOnce(rig, renderMarkers(rig, {{mine.print, 60, truth, 4.0}}), coil);
    ASSERT_TRUE(pose) << turn_deg;
    EXPECT_THAT(pose->camera_T_marker, PoseNear(truth, 0.3, 0.3));
    EXPECT_FALSE(trackOnce(rig, renderMarkers(rig, {{other.print, 60, truth, 4.0}}), coil).isTracked());
    EXPECT_FALSE(
        trackOnce(rig, renderMarkers(rig, {{mirrored(mine.print), 60, truth, 4.0}}), coil).isTracked());
  }
}

}  // namespace
}  // namespace facenav::coil_tracking
