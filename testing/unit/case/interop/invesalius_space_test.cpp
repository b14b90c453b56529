#include "facenav/interop/invesalius_space.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interop_fixtures.h"

namespace facenav::interop::testing {
namespace {

/// Rotation about one axis, written out.
Eigen::Matrix3d about(int axis, double angle_deg) {
  const double c = std::cos(angle_deg * kRadPerDeg), s = std::sin(angle_deg * kRadPerDeg);
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn(a, a) = turn(b, b) = c;
  turn(a, b) = -s, turn(b, a) = s;
  return turn;
}

Eigen::Isometry3d placed(const Eigen::Matrix3d& turn, const Eigen::Vector3d& place) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = turn;
  pose.translation() = place;
  return pose;
}

void expectNear(const InvesaliusNumbers& found, const InvesaliusNumbers& truth, double tolerance) {
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(found[i], truth[i], tolerance) << i;
}

/// Numbers of a marker in the made file, as they stand there.
InvesaliusNumbers numbersInFile(const std::string& label) {
  std::istringstream text(readWholeFile(made("invesalius_v5.mkss")));
  for (std::string line; std::getline(text, line);) {
    if (line.find('"' + label + '"') == std::string::npos) continue;
    std::istringstream row(line);
    InvesaliusNumbers numbers{};
    std::string id;
    std::getline(row, id, '\t');
    for (double& number : numbers) {
      std::string cell;
      std::getline(row, cell, '\t');
      number = std::stod(cell);
    }
    return numbers;
  }
  throw Error("no marker " + label);
}

TEST(InvesaliusSpace, MarkersAreThoseOfAFileWithOnlyPositionsMirrored) {
  const InvesaliusSpace space(madeHead().t1.grid);
  for (const auto& [name, pose] : truth())
    expectNear(space.markerOf(pose.isometry()), numbersInFile(name), 3e-5);
}

TEST(InvesaliusSpace, ATrackersAnglesTurnAboutZThenYThenX) {
  const auto pose = placed(about(2, 30) * about(1, -20) * about(0, 50), {10, -20, 600});
  expectNear(trackerNumbers(pose), {10, -20, 600, 30, -20, 50}, 1e-9);
  expectNear(trackerNumbers(placed(about(2, 90), {1, 2, 3})), {1, 2, 3, 90, 0, 0}, 1e-9);
}

TEST(InvesaliusSpace, ADisplacementIsInItsOwnAxesOfTheCoil) {
  // Ours: 2 mm along x, 5 away from the handle, 7 into the head. Theirs: x is our y, y our x, z out of it.
  const auto moved = placed(Eigen::Matrix3d::Identity(), {2, 5, 7});
  expectNear(displacementNumbers(moved), {5, 2, -7, 0, 0, 0}, 1e-12);
  const auto tilted = placed(about(1, 10), {0, 0, 0});  // about our y, their x
  expectNear(displacementNumbers(tilted), {0, 0, 0, 10, 0, 0}, 1e-9);
  const auto twisted = placed(about(2, 10), {0, 0, 0});  // about our z, into the head
  expectNear(displacementNumbers(twisted), {0, 0, 0, 0, 0, -10}, 1e-9);
}

}  // namespace
}  // namespace facenav::interop::testing
