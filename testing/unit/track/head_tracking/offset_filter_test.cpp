#include "head/offset_filter.h"

#include <gtest/gtest.h>

#include <random>

namespace facenav::head_tracking {
namespace {

constexpr double kFrame_s = 1.0 / 60.0;

/// Patches on a face of 120 mm at 600 mm, in two cameras of 800 px, 120 mm apart.
class MovingFace {
 public:
  MovingFace() {
    for (int i = 0; i < 200; ++i) {
      const Eigen::Vector3d p_mm(uniform(-60, 60), uniform(-70, 70), uniform(-30, 30));
      Patch patch;
      for (int c = 0; c < 2; ++c) {
        const Eigen::Vector3d at_mm = p_mm + Eigen::Vector3d(c == 0 ? 0.0 : -120.0, 0.0, 600.0);
        Eigen::Matrix<double, 2, 3> d_p;
        d_p << 800 / at_mm.z(), 0, -800 * at_mm.x() / (at_mm.z() * at_mm.z()), 0, 800 / at_mm.z(),
            -800 * at_mm.y() / (at_mm.z() * at_mm.z());
        patch.view[c].jacobian << d_p * -skew(p_mm), d_p;
      }
      level_.patches.push_back(patch);
    }
  }

  /// Residual displacements of a head that moves at `velocity`, its left pose known with some error, if the
  /// fit corrected for the motion `allowed`.
  PoseFit fit(const Vector6d& velocity, double late_s, const Vector6d& allowed, double shared_px = 0.0) {
    PoseFit fit;
    Vector6d off;
    for (int i = 0; i < 6; ++i) off[i] = (i < 3 ? 1e-4 : 0.05) * uniform(-1, 1);
    for (const auto& patch : level_.patches) {
      std::array<PatchMeasurement, 2> measurements;
      for (int c = 0; c < 2; ++c) {
        Eigen::Vector2d d =
            patch.view[c].jacobian * off + Eigen::Vector2d(normal_(random_), normal_(random_));
        if (c == 1)
          d += patch.view[c].jacobian * (late_s * velocity - allowed) + Eigen::Vector2d(shared_px, 0);
        measurements[c].displacement = d.cast<float>();
        measurements[c].is_visible = true, measurements[c].weight = 1.f,
        measurements[c].ncc = measurements[c].expected_ncc = 0.9f;
      }
      fit.measurements.push_back(measurements);
    }
    return fit;
  }
  const PatchLevel& level() const { return level_; }

 private:
  double uniform(double low, double high) { return low + (high - low) * double(random_() >> 11) * 0x1p-53; }
  std::mt19937_64 random_{5};
  std::normal_distribution<double> normal_{0.0, 0.15};
  PatchLevel level_;
};

Vector6d nodding(int frame) {
  Vector6d velocity = Vector6d::Zero();
  const double t = frame * kFrame_s;
  velocity << 0.3 * std::sin(3 * t), 0.2 * std::cos(2 * t), 0, 40 * std::sin(2 * t), 50 * std::cos(3 * t), 0;
  return velocity;
}

OffsetFilter after(int frames, double late_s, double shared_px = 0.0, double speed = 1.0) {
  MovingFace face;
  OffsetFilter filter;
  for (int i = 0; i < frames; ++i) {
    const Vector6d velocity = speed * nodding(i), allowed = filter.late_s() * velocity;
    filter.add(face.level(), face.fit(velocity, late_s, allowed, shared_px), velocity, allowed, kFrame_s);
  }
  return filter;
}

TEST(OffsetFilter, LearnsWhenTheRightCameraExposesFromTheMovingHead) {
  for (const double late_ms : {-12.0, -3.0, 8.0, 16.0}) {
    const auto filter = after(120, 1e-3 * late_ms);
    EXPECT_NEAR(1e3 * filter.late_s(), late_ms, 1.0) << late_ms;
    EXPECT_LT(1e3 * filter.sigma_s(), 1.5);
  }
}

TEST(OffsetFilter, SynchronousCamerasAreLeftAlone) { EXPECT_EQ(after(240, 0.0).late_s(), 0.0); }

TEST(OffsetFilter, AHeadThatHardlyMovesSaysNothingWhateverTheDisparitiesErr) {
  // 0.05 px of disparity in all patches at 2 mm/s look like 19 ms.
  const auto filter = after(240, 0.0, 0.05, 0.04);
  EXPECT_EQ(filter.late_s(), 0.0);
  EXPECT_GT(1e3 * filter.sigma_s(), 4.0) << "and what is not known is said";
}

TEST(OffsetFilter, AnOffsetThatJumpsIsFoundAgain) {
  MovingFace face;
  OffsetFilter filter = after(120, 0.015);
  for (int i = 120; i < 360; ++i) {
    const Vector6d velocity = nodding(i), allowed = filter.late_s() * velocity;
    filter.add(face.level(), face.fit(velocity, -0.012, allowed), velocity, allowed, kFrame_s);
  }
  EXPECT_NEAR(1e3 * filter.late_s(), -12.0, 1.5);
}

TEST(OffsetFilter, ADelayThatTheDriversStateIsBelievedFromTheFirstFrame) {
  OffsetFilter filter;
  EXPECT_EQ(filter.late_s(), 0.0);
  filter.state(0.009);
  EXPECT_NEAR(1e3 * filter.late_s(), 9.0, 0.5);
  EXPECT_LT(1e3 * filter.sigma_s(), 3.0);
  OffsetFilter in_step;
  in_step.state(0.001);
  EXPECT_EQ(in_step.late_s(), 0.0) << "within the error of the stamps nothing is corrected";
}

TEST(OffsetFilter, FollowsClocksThatDriftAndNotTheJitterOfTheirStamps) {
  OffsetFilter filter;
  for (int i = 0; i < 600; ++i) filter.state(0.009 + 1e-5 * i + (i % 2 ? 1e-3 : -1e-3));
  EXPECT_NEAR(1e3 * filter.late_s(), 15.0, 0.5);
}

TEST(OffsetFilter, DriversThatTheMovingHeadContradictsAreNoLongerBelieved) {
  MovingFace face;
  OffsetFilter filter;
  for (int i = 0; i < 240; ++i) {
    filter.state(0.016);
    const Vector6d velocity = nodding(i), allowed = filter.late_s() * velocity;
    filter.add(face.level(), face.fit(velocity, -0.004, allowed), velocity, allowed, kFrame_s);
  }
  EXPECT_NEAR(1e3 * filter.late_s(), -4.0, 1.0);
}

}  // namespace
}  // namespace facenav::head_tracking
