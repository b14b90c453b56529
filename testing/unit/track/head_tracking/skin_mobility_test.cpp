#include "recovery/skin_mobility.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <set>

namespace facenav::head_tracking {
namespace {

using Eigen::Vector2d;

/// Landmarks of a face at (300, 200): a nose 80 px long below the brows, eyes 100 px apart, turned by `roll`.
face::FaceLandmarks landmarks(double roll_deg = 0, double size = 1) {
  const Eigen::Rotation2Dd turn(roll_deg * M_PI / 180);
  const auto place = [&](double right, double down) {
    return Vector2d(Vector2d(300, 200) + size * (turn * Vector2d(right, down)));
  };
  face::FaceLandmarks face;
  face.points68.assign(68, place(0, 40));
  face.points68[21] = place(-12, 0), face.points68[22] = place(12, 0);
  face.points68[33] = place(0, 80);
  for (std::size_t i = 36; i <= 41; ++i) face.points68[i] = place(-50, 20);
  for (std::size_t i = 42; i <= 47; ++i) face.points68[i] = place(50, 20);
  return face;
}

Vector2d at(double right, double down, double roll_deg = 0, double size = 1) {
  return Vector2d(300, 200) + size * (Eigen::Rotation2Dd(roll_deg * M_PI / 180) * Vector2d(right, down));
}

TEST(SkinMobility, BoneHoldsBridgeAndForeheadLipsMove) {
  const SkinMobility mobility(landmarks());
  const double bridge = mobility.at(at(0, 40)).sigma_mm, forehead = mobility.at(at(20, -40)).sigma_mm,
               cheek = mobility.at(at(55, 65)).sigma_mm, mouth = mobility.at(at(0, 110)).sigma_mm,
               hair = mobility.at(at(0, -90)).sigma_mm;
  EXPECT_LT(bridge, forehead);
  EXPECT_LT(forehead, cheek);
  EXPECT_LT(cheek, mouth);
  EXPECT_GT(hair, cheek);
  EXPECT_LT(mobility.at(at(95, 20)).sigma_mm, cheek) << "temples";
}

TEST(SkinMobility, BothSidesMoveAlikeButAreTwoParts) {
  const SkinMobility mobility(landmarks());
  for (double down = -80; down < 130; down += 7)
    for (double right = 3; right < 130; right += 9) {
      const SkinPart a = mobility.at(at(right, down)), b = mobility.at(at(-right, down));
      EXPECT_EQ(a.sigma_mm, b.sigma_mm) << right << " " << down;
      if (a.number >= 4)
        EXPECT_EQ(std::abs(a.number - b.number), 1) << right << " " << down;
      else
        EXPECT_EQ(a.number, b.number);
      EXPECT_GE(std::min(a.number, b.number), 0);
      EXPECT_LT(std::max(a.number, b.number), 14);
    }
}

TEST(SkinMobility, GoesWithTheFacesRollAndSize) {
  const SkinMobility upright(landmarks());
  for (const auto& [roll_deg, size] : {std::pair{35.0, 1.0}, {180.0, 1.0}, {-90.0, 0.4}, {10.0, 2.5}}) {
    const SkinMobility turned(landmarks(roll_deg, size));
    for (double down = -70; down < 120; down += 11)
      for (double right = -112; right < 120; right += 13) {
        const SkinPart a = upright.at(at(right, down)), b = turned.at(at(right, down, roll_deg, size));
        EXPECT_EQ(a.number, b.number) << right << " " << down << " rolled by " << roll_deg;
        EXPECT_EQ(a.sigma_mm, b.sigma_mm);
      }
  }
}

TEST(SkinMobility, WithoutLandmarksAllSkinIsOnePart) {
  face::FaceLandmarks few = landmarks(), tiny = landmarks(0, 0.02);
  few.points68.resize(5);
  for (const SkinMobility& mobility : {SkinMobility(), SkinMobility(few), SkinMobility(tiny)}) {
    std::set<std::pair<int, double>> parts;
    for (double down = -80; down < 130; down += 20)
      parts.insert({mobility.at(at(30, down)).number, mobility.at(at(30, down)).sigma_mm});
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_EQ(parts.begin()->first, 0);
    EXPECT_GT(parts.begin()->second, 0);
  }
}

}  // namespace
}  // namespace facenav::head_tracking
