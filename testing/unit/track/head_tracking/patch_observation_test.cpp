// Information of the patches about the pose: mean and difference against the whole covariance, and filters
// against shading.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "head/patch_filters.h"
#include "head/patch_observation.h"

namespace facenav::head_tracking {
namespace {

using patch::kSamples;
using patch::kSide;

constexpr double kCommon_px = 0.15;  // as in patch_observation.cpp, where no other error is common

/// A patch of smooth skin, seen obliquely by the right camera.
Patch skewPatch() {
  Patch patch;
  patch.right_mm = {0.75, 0.05, 0.2}, patch.down_mm = {-0.03, 0.8, 0.1};
  Eigen::Matrix<double, 2, 3> left, right;
  left << 1.3, 0.02, -0.1, -0.03, 1.25, 0.08;
  right << 1.1, 0.1, -0.45, -0.05, 1.3, 0.15;
  Eigen::Matrix3d turned;
  turned << 0, 40, -12, -38, 0, 25, 10, -22, 0;
  patch.view[0].jacobian << left * turned, left;
  patch.view[1].jacobian << right * turned, right;
  patch.view[0].covariance << 0.02, 0.004, 0.004, 0.01;
  patch.view[1].covariance << 0.015, -0.003, -0.003, 0.05;
  for (auto& view : patch.view) view.is_usable = true, view.ray = Eigen::Vector3d::UnitZ();
  return patch;
}

PatchChange unchanged() {
  PatchChange change;
  change.key_from_now = {Eigen::Matrix2d::Identity(), Eigen::Matrix2d::Identity()};
  change.ray = {Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitZ()};
  return change;
}

TEST(PatchWorth, MeanAndDifferenceTellAllThatTheWholeCovarianceTells) {
  const Patch patch = skewPatch();
  ASSERT_TRUE(canBePaired(patch));
  Matrix6d observed = Matrix6d::Zero();
  for (const auto& part : observedByBoth(patch, unchanged()))
    observed += part.jacobian.transpose() * part.covariance.inverse() * part.jacobian;
  // All four errors at once: each camera's own, and one along the skin common to both.
  Eigen::Matrix<double, 3, 2> tangents;
  tangents << patch.right_mm, patch.down_mm;
  Eigen::Matrix<double, 4, 2> seen;
  Eigen::Matrix<double, 4, 6> jacobian;
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
  for (int c = 0; c < 2; ++c) {
    seen.middleRows<2>(2 * c) = patch.view[c].jacobian.rightCols<3>() * tangents;
    jacobian.middleRows<2>(2 * c) = patch.view[c].jacobian;
    covariance.block<2, 2>(2 * c, 2 * c) = patch.view[c].covariance;
  }
  const Eigen::Matrix2d skin_from_left = seen.topRows<2>().inverse();
  covariance +=
      seen * (kCommon_px * kCommon_px * skin_from_left * skin_from_left.transpose()) * seen.transpose();
  const Matrix6d whole = jacobian.transpose() * covariance.inverse() * jacobian;
  EXPECT_LT((observed - whole).norm(), 1e-9 * whole.norm());
}

TEST(PatchWorth, LightThatChangesLeavesTheDifferenceItsSay) {
  Patch patch = skewPatch();
  for (auto& view : patch.view) view.shading = 400 * Eigen::Matrix2d::Identity();
  PatchChange lit = unchanged();
  lit.light_change = 0.3;
  const auto before = observedByBoth(patch, unchanged()), after = observedByBoth(patch, lit);
  EXPECT_GT(after[0].covariance.trace(), 1.1 * before[0].covariance.trace());
  EXPECT_NEAR(after[1].covariance.trace(), before[1].covariance.trace(), 1e-12);
}

TEST(PatchWorth, APatchSeenEdgeOnIsNotPaired) {
  Patch patch = skewPatch();
  patch.view[1].jacobian.rightCols<3>() << 1, 0, -3.75, 0, 0.1, 0;
  EXPECT_FALSE(canBePaired(patch));
}

/// Fine marks on the skin, and their slopes.
struct Marks {
  std::vector<float> grey, d_u, d_v;
  explicit Marks(double shift_px = 0.0) {
    for (int i = 0; i < kSamples; ++i) {
      const double x = i % kSide - 3.5 + shift_px, y = i / kSide - 3.5;
      grey.push_back(float(6 * std::sin(1.3 * x + 0.4 * y) + 5 * std::cos(0.5 * x - 1.2 * y)));
      d_u.push_back(float(7.8 * std::cos(1.3 * x + 0.4 * y) - 2.5 * std::sin(0.5 * x - 1.2 * y)));
      d_v.push_back(float(2.4 * std::cos(1.3 * x + 0.4 * y) + 6 * std::sin(0.5 * x - 1.2 * y)));
    }
    const auto centre = [](std::vector<float>& values) {
      float mean = 0;
      for (float value : values) mean += value / float(kSamples);
      for (float& value : values) value -= mean;
    };
    centre(grey), centre(d_u), centre(d_v);
  }
};

float dot(const std::vector<float>& a, const std::vector<float>& b) {
  float sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// Displacement in px that the filters compute from a difference to the marks.
Eigen::Vector2f displacement(const std::array<std::vector<float>, 2>& filters, const Marks& marks,
                             const std::vector<float>& difference) {
  Eigen::Matrix2f structure;
  structure << dot(filters[0], marks.d_u), dot(filters[0], marks.d_v), dot(filters[1], marks.d_u),
      dot(filters[1], marks.d_v);
  return structure.inverse() * Eigen::Vector2f(dot(filters[0], difference), dot(filters[1], difference));
}

TEST(PatchFilters, GainAndOffsetDropOut) {
  const Marks marks;
  const auto filters = displacementFilters(marks.grey, marks.d_u, marks.d_v, 0, 2.0, 4.0);
  const std::vector<float> ones(kSamples, 1.f);
  for (const auto& filter : filters) {
    const float length = std::sqrt(dot(filter, filter));
    EXPECT_NEAR(dot(filter, ones), 0.f, 1e-3f * length * 8);
    EXPECT_NEAR(dot(filter, marks.grey), 0.f, 1e-3f * length * std::sqrt(dot(marks.grey, marks.grey)));
  }
}

TEST(PatchFilters, ShadingMovesThePatchLessAndAShiftAsMuch) {
  const Marks marks, shifted(0.1);
  const auto plain = displacementFilters(marks.grey, marks.d_u, marks.d_v, 0, 2.0, 0.0),
             wary = displacementFilters(marks.grey, marks.d_u, marks.d_v, 0, 2.0, 4.0);
  std::vector<float> shading, moved;
  for (int i = 0; i < kSamples; ++i) {
    const float x = float(i % kSide) - 3.5f, y = float(i / kSide) - 3.5f;
    shading.push_back(0.8f * x + 0.5f * y + 0.15f * x * x - 0.1f * x * y);  // the slope of a highlight
    moved.push_back(shifted.grey[i] - marks.grey[i]);
  }
  EXPECT_LT(displacement(wary, marks, shading).norm(), 0.4f * displacement(plain, marks, shading).norm());
  EXPECT_NEAR(displacement(wary, marks, moved).x(), 0.1f, 0.01f);
  EXPECT_NEAR(displacement(wary, marks, moved).y(), 0.0f, 0.01f);
}

}  // namespace
}  // namespace facenav::head_tracking
