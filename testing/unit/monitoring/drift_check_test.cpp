#include "facenav/monitoring/drift_check.h"

#include <gtest/gtest.h>

#include <map>

#include "facenav/geometry/rotation.h"
#include "facenav/monitoring/drift_watchdog.h"
#include "support/synthetic_face.h"

namespace facenav::monitoring {
namespace {

using Verdict = DriftFinding::Verdict;
using facenav::testing::SyntheticFace;
using facenav::testing::SyntheticView;

/// The surface seen by the reference, as a mesh: its points lie on every second pixel.
registration::SkinModel skinOf(const head_tracking::HeadReference& reference) {
  registration::SkinModel skin;
  skin.points.points_mm = reference.surface.points_mm;
  skin.points.normals.assign(skin.points.points_mm.size(), -Eigen::Vector3d::UnitZ());
  std::map<std::pair<int, int>, int> at;
  for (std::size_t i = 0; i < reference.surface_left_px.size(); ++i)
    at[{int(reference.surface_left_px[i].x()) / 2, int(reference.surface_left_px[i].y()) / 2}] = int(i);
  for (const auto& [px, a] : at) {
    const auto b = at.find({px.first + 1, px.second}), c = at.find({px.first, px.second + 1}),
               d = at.find({px.first + 1, px.second + 1});
    if (b == at.end() || c == at.end() || d == at.end()) continue;
    skin.triangles.emplace_back(a, c->second, b->second);
    skin.triangles.emplace_back(b->second, c->second, d->second);
    const auto& p = skin.points.points_mm;
    const Eigen::Vector3d outward =
        (p[std::size_t(c->second)] - p[std::size_t(a)]).cross(p[std::size_t(b->second)] - p[std::size_t(a)]);
    skin.points.normals[std::size_t(a)] = outward.normalized();
  }
  return skin;
}

/// A portrait on a head-like surface. Its MRI frame is the camera's frame at the reference.
class Sitting {
 public:
  Sitting() : face_(SyntheticFace::astronaut()), reference_(face_.reference(rig_, true)) {
    check_ = std::make_shared<const DriftCheck>(
        rig_, std::make_shared<const registration::ScalpField>(skinOf(reference_)), reference_,
        RigidTransform<Camera, Mri>());
    for (const auto& p : reference_.surface.points_mm)
      centre_mm_ += p / double(reference_.surface.points_mm.size());
  }
  static const Sitting& shared() {
    static const Sitting sitting;
    return sitting;
  }
  cameras::StereoFrame render(SyntheticView view) const { return face_.render(rig_, view); }
  /// A rotation (rotation vector, degrees) about the face's centre, and a shift.
  Eigen::Isometry3d about(const Eigen::Vector3d& turn_deg, const Eigen::Vector3d& shift_mm) const {
    Vector6d xi;
    xi << turn_deg * kRadPerDeg, shift_mm;
    return Eigen::Translation3d(centre_mm_) * expRigid(xi) * Eigen::Translation3d(-centre_mm_);
  }
  DriftFinding measure(const cameras::StereoFrame& frame, const Eigen::Isometry3d& pose) const {
    return check_->measure(frame, RigidTransform<Camera, Mri>::fromIsometry(pose));
  }

 private:
  cameras::StereoRig rig_ = facenav::testing::faceRig();
  SyntheticFace face_;
  head_tracking::HeadReference reference_;
  std::shared_ptr<const DriftCheck> check_;
  Eigen::Vector3d centre_mm_ = Eigen::Vector3d::Zero();
};

bool hasPortrait() { return std::filesystem::exists(SyntheticFace::portraitPath()); }

TEST(DriftCheck, AgreesWhereTheFaceIsTrackedFromEverySide) {
  if (!hasPortrait()) GTEST_SKIP() << "python3-skimage's portrait is not installed";
  const auto& sitting = Sitting::shared();
  std::uint64_t seed = 10;
  for (const auto& turn_deg : {Eigen::Vector3d(0, 0, 0), {0, 22, 0}, {12, -18, 8}}) {
    SyntheticView view;
    view.motion = sitting.about(turn_deg, {8, -6, 20});
    view.seed = ++seed;
    view.gain = 0.8;
    const auto found = sitting.measure(sitting.render(view), view.motion);
    EXPECT_EQ(found.verdict, Verdict::agrees) << turn_deg.transpose();
    EXPECT_LT(found.shift_mm, 3 * found.shift_sigma_mm) << turn_deg.transpose();
    EXPECT_LT(found.turn_deg, 3 * found.turn_sigma_deg) << turn_deg.transpose();
  }
}

TEST(DriftCheck, SeesADriftOf3MillimetresOr2Point2DegreesAlongEachAxis) {
  if (!hasPortrait()) GTEST_SKIP() << "python3-skimage's portrait is not installed";
  const auto& sitting = Sitting::shared();
  SyntheticView view;
  view.motion = sitting.about({4, 10, -3}, {10, 5, -8});
  view.seed = 20;
  const auto frame = sitting.render(view);
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      const Eigen::Vector3d along = sign * Eigen::Vector3d::Unit(axis);
      const auto shifted = sitting.measure(frame, sitting.about({0, 0, 0}, 3.0 * along) * view.motion);
      EXPECT_EQ(shifted.verdict, Verdict::drifted) << along.transpose() << ": " << shifted.shift_mm << " mm";
      const Eigen::Isometry3d turned = view.motion * sitting.about(2.2 * along, {0, 0, 0});
      const auto found = sitting.measure(frame, turned);
      EXPECT_EQ(found.verdict, Verdict::drifted) << along.transpose() << ": " << found.turn_deg << " deg";
    }
}

TEST(DriftCheck, KnowsNothingOfAFaceThatItCannotSee) {
  if (!hasPortrait()) GTEST_SKIP() << "python3-skimage's portrait is not installed";
  const auto& sitting = Sitting::shared();
  SyntheticView view;
  auto frame = sitting.render(view);
  auto far = sitting.about({0, 0, 0}, {900, 0, 0});  // outside the image
  EXPECT_EQ(sitting.measure(frame, far).verdict, Verdict::unknown);
  frame.left.setTo(0);
  frame.right.setTo(0);
  EXPECT_EQ(sitting.measure(frame, Eigen::Isometry3d::Identity()).verdict, Verdict::unknown);
}

}  // namespace
}  // namespace facenav::monitoring
