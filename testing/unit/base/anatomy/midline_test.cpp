// The midline's landmarks on an outline in closed form: an ellipse with a brow, a nose, lips and a chin.

#include "facenav/anatomy/midline_profile.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>

namespace facenav::anatomy {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kRoot_mm = 22, kTip_mm = -22, kBase_mm = -36, kChin_mm = -92;

double bump(double z, double at, double height, double width) {
  return height * std::exp(-0.5 * std::pow((z - at) / width, 2));
}

/// Height of a nose 22 mm long beyond the face: it rises from the root to the tip and falls off to the base.
double noseAt(double z) {
  if (z > kRoot_mm || z < kBase_mm) return 0;
  return z >= kTip_mm ? 22 * (kRoot_mm - z) / (kRoot_mm - kTip_mm)
                      : 22 * (z - kBase_mm) / (kTip_mm - kBase_mm);
}

/// Forward position of the face at height `z`, mm.
double faceAt(double z, bool has_nose) {
  const double skull = 95 * std::sqrt(std::max(0.0, 1 - z * z / (120.0 * 120.0)));
  if (!has_nose) return skull + bump(z, 36, 5, 9);  // cut away from the brow down
  return skull + bump(z, 36, 5, 9) + bump(z, kRoot_mm - 2, -3, 6) + noseAt(z) + bump(z, -52, 4, 7) +
         bump(z, -70, -4, 6) + bump(z, kChin_mm, 22, 11);
}

struct Mesh {
  std::vector<Vector3d> head_mm;
  std::vector<Eigen::Vector3i> triangles;
};

/// Strip of 20 mm about the plane of symmetry. `end_mm`: the scan ends at this height.
Mesh strip(bool has_nose = true, double end_mm = -112,
           const Eigen::Isometry3d& moved = Eigen::Isometry3d::Identity()) {
  std::vector<Vector2d> line;
  for (double z = end_mm; z < 119.9; z += 0.5) line.emplace_back(faceAt(z, has_nose), z);
  for (double turn = 0; turn < M_PI * 0.9; turn += 0.005) {
    const Vector2d p(-95 * std::sin(turn), 120 * std::cos(turn));
    if (p.y() > end_mm) line.push_back(p);
  }
  Mesh mesh;
  for (const Vector2d& p : line)
    for (const double x : {-10.0, 10.0}) mesh.head_mm.push_back(moved * Vector3d(x, p.x(), p.y()));
  for (int i = 0; i + 1 < int(line.size()); ++i) {
    mesh.triangles.emplace_back(2 * i, 2 * i + 1, 2 * i + 2);
    mesh.triangles.emplace_back(2 * i + 1, 2 * i + 3, 2 * i + 2);
  }
  return mesh;
}

MidlineLandmarks landmarksOf(const Mesh& mesh) {
  return midlineLandmarks(midlineProfile(mesh.head_mm, mesh.triangles));
}

Vector2d onFace(double z) { return {faceAt(z, true), z}; }

TEST(MidlineProfile, RunsFromTheVertexDownTheFaceAndTheBackInEvenSteps) {
  const Mesh mesh = strip();
  const MidlineProfile profile = midlineProfile(mesh.head_mm, mesh.triangles);
  ASSERT_GT(profile.front.size(), 300u);
  EXPECT_NEAR(profile.front.front().y(), 120, 1.0);
  EXPECT_NEAR(profile.back.front().y(), 120, 1.0);
  for (std::size_t i = 1; i < profile.front.size(); ++i) {
    const double step_mm = (profile.front[i] - profile.front[i - 1]).norm();
    EXPECT_GT(step_mm, 0.3);
    EXPECT_LT(step_mm, 0.75);
  }
  for (const Vector2d& p : profile.front)
    if (p.y() > -105 && p.y() < 110) EXPECT_NEAR(p.x(), faceAt(p.y(), true), 2.0) << p.transpose();
  for (const Vector2d& p : profile.back) EXPECT_LT(p.x(), 2);
}

TEST(MidlineLandmarks, LieWhereTheOutlinePutsThem) {
  const MidlineLandmarks found = landmarksOf(strip());
  ASSERT_TRUE(found.pronasale && found.nasion && found.subnasale && found.glabella && found.pogonion &&
              found.opisthocranion);
  EXPECT_LT((*found.pronasale - onFace(kTip_mm)).norm(), 2.5);
  EXPECT_LT((*found.subnasale - onFace(kBase_mm)).norm(), 3.0);
  EXPECT_NEAR(found.nasion->y(), kRoot_mm - 2, 6.0);
  EXPECT_NEAR(found.glabella->y(), 36, 8.0);
  EXPECT_NEAR(found.pogonion->y(), kChin_mm, 6.0);
  EXPECT_LT(found.opisthocranion->x(), -85);
}

TEST(MidlineLandmarks, OfANoddingHeadAreTheSame) {
  const MidlineLandmarks upright = landmarksOf(strip());
  for (const double pitch_deg : {-12.0, 12.0}) {
    const Eigen::Isometry3d nod =
        Eigen::Translation3d(0, 7, -11) *
        Eigen::Isometry3d(Eigen::AngleAxisd(pitch_deg * M_PI / 180, Vector3d::UnitX()));
    const MidlineLandmarks nodded = landmarksOf(strip(true, -112, nod));
    const auto expectSame = [&](const std::optional<Vector2d>& a, const std::optional<Vector2d>& b,
                                double most_mm, const char* name) {
      ASSERT_TRUE(a && b) << name;
      const Vector3d moved = nod * Vector3d(0, a->x(), a->y());
      EXPECT_LT((moved.tail<2>() - *b).norm(), most_mm) << name << " at " << pitch_deg;
    };
    expectSame(upright.pronasale, nodded.pronasale, 1.5, "pronasale");
    expectSame(upright.subnasale, nodded.subnasale, 1.5, "subnasale");
    expectSame(upright.nasion, nodded.nasion, 2.5, "nasion");
    expectSame(upright.pogonion, nodded.pogonion, 3.0, "pogonion");
  }
}

/// Tilted back by 75 degrees the nose lies at the start of the outline. It may be missing then, but a chin
/// must not be taken for it.
TEST(MidlineLandmarks, TheChinOfAHeadTiltedFarBackIsNoNose) {
  for (double pitch_deg = -40; pitch_deg <= 90; pitch_deg += 2.5) {
    const Eigen::Isometry3d nod(Eigen::AngleAxisd(pitch_deg * M_PI / 180, Vector3d::UnitX()));
    const MidlineLandmarks found = landmarksOf(strip(true, -112, nod));
    EXPECT_TRUE(found.pronasale || pitch_deg > 50) << pitch_deg << " degrees";
    if (!found.pronasale) {
      EXPECT_FALSE(found.nasion || found.subnasale || found.pogonion) << pitch_deg << " degrees";
      continue;
    }
    const Vector2d tip = onFace(kTip_mm);
    const Vector3d moved = nod * Vector3d(0, tip.x(), tip.y());
    EXPECT_LT((moved.tail<2>() - *found.pronasale).norm(), 4.0) << pitch_deg << " degrees";
  }
}

TEST(MidlineLandmarks, AFaceWithoutANoseHasNone) {
  const MidlineLandmarks found = landmarksOf(strip(false));
  EXPECT_FALSE(found.pronasale);
  EXPECT_FALSE(found.subnasale);
}

TEST(MidlineLandmarks, BelowTheScansEndThereAreNone) {
  const MidlineLandmarks without_chin = landmarksOf(strip(true, -65));
  EXPECT_TRUE(without_chin.pronasale);
  EXPECT_FALSE(without_chin.pogonion);
  const MidlineLandmarks forehead = landmarksOf(strip(true, 60));
  EXPECT_FALSE(forehead.pronasale || forehead.nasion || forehead.subnasale);
}

TEST(MidlineLandmarks, TheInionIsWhereTheBackOfTheHeadBendsIntoTheNeck) {
  const Mesh mesh = strip();
  MidlineProfile profile = midlineProfile(mesh.head_mm, mesh.triangles);
  const double bend_rad = 1.9;  // 39 mm below the middle of the ellipse
  const Vector2d bend(-95 * std::sin(bend_rad), 120 * std::cos(bend_rad));
  profile.back.clear();
  for (double turn = 0; turn < bend_rad; turn += 0.006)
    profile.back.emplace_back(-95 * std::sin(turn), 120 * std::cos(turn));
  const auto skull = profile.back;
  for (double along = 0.7; along < 70; along += 0.7)
    profile.back.push_back(bend + along * Vector2d(0.6, -0.8));
  const auto found = midlineLandmarks(profile);
  ASSERT_TRUE(found.opisthocranion && found.inion);
  EXPECT_LT((*found.inion - bend).norm(), 6.0) << found.inion->transpose();
  profile.back = skull;  // the scan ends at the bend: nothing shows where the neck begins
  EXPECT_FALSE(midlineLandmarks(profile).inion);
}

TEST(MidlineProfile, OfNothingIsEmpty) {
  EXPECT_TRUE(
      midlineProfile({Vector3d(5, 0, 0), Vector3d(6, 0, 0), Vector3d(5, 1, 0)}, {Eigen::Vector3i(0, 1, 2)})
          .front.empty());
  EXPECT_FALSE(midlineLandmarks({}).pronasale);
}

}  // namespace
}  // namespace facenav::anatomy
