// Compares the predicted error with the true one for live skin that differs from the scan's in ways that a
// fit cannot see.

#include <gtest/gtest.h>

#include "facenav/core/error.h"
#include "facenav/geometry/pose_error.h"
#include "facenav/registration/skin_fit.h"
#include "support/model_head.h"
#include "support/skin_misfit.h"

namespace facenav::registration {
namespace {

using facenav::testing::facing;
using facenav::testing::liveSkin;
using facenav::testing::measureSkin;
using facenav::testing::Misfit;
using facenav::testing::ModelHead;
using facenav::testing::StereoView;

const Point<Mri> kTarget(-40, -10, 60);

struct Fixture {
  SkinModel skin = ModelHead().skin();
  ScalpField scalp{skin};
};
const Fixture& fixture() {
  static const Fixture made;
  return made;
}

struct Aligned {
  PointCloud<Camera> face;
  AlignmentResult result;
  double error_mm;
};

Aligned alignLive(const SkinModel& live, std::uint32_t seed) {
  const auto truth = facing(10 * std::sin(seed), 6 * std::cos(seed), 4 * std::sin(2.0 * seed), {0, 0, 20});
  StereoView view;
  view.seed = seed;
  Aligned out;
  out.face = measureSkin(live, fixture().scalp.noseTip_mm(), truth, view);
  AlignmentStart start;
  start.guess = facing(0, 0, 0);
  TaskMonitor monitor;
  out.result = makeSurfaceAligner()->align(fixture().scalp, out.face, start, monitor);
  out.error_mm = poseError(out.result.camera_T_mri, truth, kTarget).at_point_mm;
  return out;
}

TEST(PredictedError, HoldsForAllKindsOfMisfit) {
  int within = 0, all = 0, refused = 0;
  double worst_bound_mm = 0;
  std::vector<double> errors_mm;
  for (const auto& kind : facenav::testing::misfits())
    for (std::uint32_t seed : {471u, 472u, 473u}) {
      Aligned aligned;
      try {
        aligned = alignLive(liveSkin(fixture().skin, fixture().scalp.noseTip_mm(), kind.first, seed), seed);
      } catch (const Error& refusal) {
        std::printf("%s, seed %u: %s\n", kind.second.c_str(), unsigned(seed), refusal.what());
        ++refused;
        continue;
      }
      // No camera turned here; the bound that allows for it is wider.
      const auto& result = aligned.result;
      const double bound_mm = result.uncertainty().errorBound_mm(result.camera_T_mri, kTarget);
      EXPECT_LE(bound_mm, result.errorBound_mm(kTarget));
      within += aligned.error_mm <= bound_mm;
      if (aligned.error_mm > bound_mm)
        std::printf("%s, seed %u: %.2f mm, bound %.2f mm\n", kind.second.c_str(), unsigned(seed),
                    aligned.error_mm, bound_mm);
      worst_bound_mm = std::max(worst_bound_mm, bound_mm);
      ++all;
      errors_mm.push_back(aligned.error_mm);
      EXPECT_GT(bound_mm, aligned.result.predictedError_mm(kTarget));
    }
  EXPECT_LE(refused, 2);
  EXPECT_GE(within, all - 2) << "of " << all << ": 95 % were promised";
  std::nth_element(errors_mm.begin(), errors_mm.begin() + all / 2, errors_mm.end());
  EXPECT_LT(errors_mm[std::size_t(all / 2)], 0.5);
  EXPECT_LT(worst_bound_mm, 4.0) << "no use if it says too much";
}

TEST(PredictedError, HairOverHalfOfWhatTheScanHasDoesNotPull) {
  // The scan ends at mid-nose, hair hangs far down the forehead. A pose between hair and skin fits all of it
  // loosely; the right one fits the bare skin closely.
  const Eigen::Vector3d nose = fixture().scalp.noseTip_mm();
  const ScalpField scalp(ModelHead().skin(-25));
  int aligned = 0;
  for (const std::uint32_t seed : {481u, 482u, 483u}) {
    const auto truth = facing(14.0 * std::sin(seed), -5, 3);
    StereoView view;
    view.seed = seed;
    view.hairline_mm = 58;
    const auto face = measureSkin(liveSkin(fixture().skin, nose, Misfit::none, seed), nose, truth, view);
    TaskMonitor monitor;
    try {
      const auto result = makeSurfaceAligner()->align(scalp, face, {}, monitor);
      const double error_mm = poseError(result.camera_T_mri, truth, kTarget).at_point_mm;
      EXPECT_LT(error_mm, result.errorBound_mm(kTarget)) << seed;
      aligned += error_mm < 2.0;
    } catch (const Error& refusal) {  // a refusal is allowed; a pose displaced by hair is not
      EXPECT_EQ(std::string(refusal.what()).rfind("not aligned", 0), 0u) << refusal.what();
    }
  }
  EXPECT_GE(aligned, 2) << "of 3";
}

TEST(PredictedError, AMaskOverHalfOfTheFaceDoesNotPull) {
  // A head that nods fits all of mask and brow loosely; the right pose fits the bare skin closely.
  const Eigen::Vector3d nose = fixture().scalp.noseTip_mm();
  for (const std::uint32_t seed : {491u, 492u}) {
    const auto truth = facing(12.0 * std::sin(seed), 5.0 * std::cos(seed), 3, {0, 0, 10});
    StereoView view;
    view.seed = seed;
    view.has_mask = true;
    const auto face = measureSkin(liveSkin(fixture().skin, nose, Misfit::none, seed), nose, truth, view);
    TaskMonitor monitor;
    const auto result = makeSurfaceAligner()->align(fixture().scalp, face, {}, monitor);
    const auto error = poseError(result.camera_T_mri, truth, kTarget);
    EXPECT_LT(error.at_point_mm, 1.0) << seed;
    EXPECT_LT(error.rotation_rad, 0.5 * M_PI / 180) << seed;
    EXPECT_LT(error.at_point_mm, result.errorBound_mm(kTarget)) << seed;
    EXPECT_LT(result.errorBound_mm(kTarget), 2.5) << "no use if it says too much";
    int cloth = 0, inliers_on_cloth = 0;
    for (std::size_t p = 0; p < face.size(); ++p) {
      const Eigen::Vector3d d = (truth.inverse() * Point<Camera>(face.points_mm[p])).mm - nose;
      if (!facenav::testing::isMasked(d)) continue;
      ++cloth;
      inliers_on_cloth += result.is_inlier[p];
    }
    EXPECT_LT(inliers_on_cloth, 0.03 * cloth);
    ASSERT_FALSE(result.cautions.empty());
    EXPECT_NE(result.cautions.front().find("covered"), std::string::npos) << result.cautions.front();
  }
}

TEST(PredictedError, GrowsWithTheMisfit) {
  const auto& nose = fixture().scalp.noseTip_mm();
  const double small_mm =
      alignLive(liveSkin(fixture().skin, nose, Misfit::none, 5), 5).result.errorBound_mm(kTarget);
  const double large_mm =
      alignLive(liveSkin(fixture().skin, nose, Misfit::smooth, 5), 5).result.errorBound_mm(kTarget);
  EXPECT_GT(large_mm, 1.5 * small_mm);
}

TEST(PredictedError, BoundIsTheQuantileOfTheErrorsLength) {
  AlignmentResult result;
  result.freedom = 1e6;
  result.covariance.bottomRightCorner<3, 3>() = 0.04 * Eigen::Matrix3d::Identity();
  EXPECT_NEAR(result.predictedError_mm({}), 0.2 * std::sqrt(3.0), 1e-9);
  EXPECT_NEAR(result.errorBound_mm({}, 0.95), 0.2 * std::sqrt(7.815), 0.005);  // chi square, 3 degrees
  EXPECT_NEAR(result.errorBound_mm({}, 0.99), 0.2 * std::sqrt(11.345), 0.01);
  result.freedom = 10;  // F(3, 10) at 0.95 is 3.708
  EXPECT_NEAR(result.errorBound_mm({}, 0.95), 0.2 * std::sqrt(3 * 3.708 * 8 / 10), 0.005);
}

TEST(SkinFit, NamesTheRegionThatMoved) {
  SkinModel live = fixture().skin;
  const Eigen::Vector3d nose = fixture().scalp.noseTip_mm();
  for (std::size_t v = 0; v < live.points.size(); ++v) {
    const Eigen::Vector3d d = live.points.points_mm[v] - nose;
    const double cheek = std::exp(-std::pow((d.x() + 45) / 22, 2) - std::pow((d.z() + 30) / 24, 2));
    live.points.points_mm[v] += 1.6 * cheek * live.points.normals[v];
  }
  const Aligned aligned = alignLive(live, 3);
  std::vector<RegionFit> skin;
  for (const auto& region : fitByRegion(fixture().scalp, aligned.face, aligned.result))
    if (region.offset_mm < 2.0) skin.push_back(region);  // the others are hair
  ASSERT_FALSE(skin.empty());
  EXPECT_EQ(skin.front().region, "left cheek");
  EXPECT_GT(skin.front().offset_mm, 0.4);
  EXPECT_NE(inWords(skin.front()).find("mm outside the MRI's skin"), std::string::npos);
  EXPECT_LT(aligned.error_mm, 0.5) << "one cheek must not pull the head";
}

}  // namespace
}  // namespace facenav::registration
