// The import check on balls with known noise, ghosts, cuts and wrap-around.

#include "facenav/surface/navigation_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "facenav/core/error.h"

namespace facenav::surface {
namespace {

using ::testing::HasSubstr;

constexpr double kRadius_mm = 30, kSignal = 400;
constexpr int kSize = 96;

struct Ball {
  volume::Volume mri;
  volume::Mask mask;
  TriangleMesh skin;
};

/// Soft-edged ball of kSignal in Rayleigh noise, 1 mm voxels, centred at `centre` (voxels).
Ball makeBall(double noise, const Eigen::Vector3d& centre = {48, 48, 48}) {
  Ball ball;
  ball.mri.grid.size = {kSize, kSize, kSize};
  ball.mask.grid = ball.mri.grid;
  std::mt19937 random(20260401);
  std::normal_distribution<double> normal(0, noise > 0 ? noise : 1);
  for (int k = 0; k < kSize; ++k)
    for (int j = 0; j < kSize; ++j)
      for (int i = 0; i < kSize; ++i) {
        const double r = (Eigen::Vector3d(i, j, k) - centre).norm();
        const double signal =
            kSignal / (1 + std::exp((r - kRadius_mm) / 0.5));  // steepest: kSignal / 2 per mm
        const double value = noise > 0 ? std::hypot(signal + normal(random), normal(random)) : signal;
        ball.mri.voxels.push_back(float(value));
        ball.mask.voxels.push_back(r < kRadius_mm);
      }
  for (int s = 0; s < 2000; ++s) {
    const Eigen::Vector3d n = Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
    ball.skin.vertices_mm.push_back(centre + kRadius_mm * n);
    ball.skin.normals.push_back(n);
  }
  return ball;
}

CheckFinding findingOf(const Ball& ball, CheckTopic topic) {
  ScalpSurface scalp;
  scalp.mesh = ball.skin;
  for (const auto& finding : checkForNavigation(ball.mri, ball.mask, scalp).findings)
    if (finding.topic == topic) return finding;
  ADD_FAILURE() << "no finding on " << toString(topic);
  return {};
}

TEST(ScanQuality, NoiseAndWhatItDoesToTheSkin) {
  for (const double noise : {5.0, 20.0}) {
    const Ball ball = makeBall(noise);
    const auto scan = measureScan(ball.mri, ball.mask, ball.skin);
    EXPECT_NEAR(scan.noise, noise, 0.03 * noise);
    EXPECT_NEAR(scan.skin_step, kSignal, 0.15 * kSignal);
    // Slope kSignal / (4 * 0.5 mm) = 200 per mm. Trilinear values over 0.5 mm give a little less, and the
    // steepest of several noisy ones a little more.
    EXPECT_NEAR(scan.skin_jitter_mm, noise / 200, 0.35 * noise / 200);
    EXPECT_LT(scan.ghost_share, 0.005);
  }
}

/// Adds 5 % of the ball, half the field of view away along y, as with a moving head.
void addGhost(Ball& ball) {
  const auto clean = ball.mri;
  for (int k = 0; k < kSize; ++k)
    for (int j = 0; j < kSize; ++j)
      for (int i = 0; i < kSize; ++i)
        ball.mri.voxels[ball.mri.grid.index(i, j, k)] += 0.05f * clean.at(i, (j + kSize / 2) % kSize, k);
}

TEST(ScanQuality, GhostsAndTheirDirection) {
  Ball ball = makeBall(4);
  const Ball clean = ball;
  addGhost(ball);
  const auto scan = measureScan(ball.mri, ball.mask, ball.skin);
  EXPECT_GT(scan.ghost_share, 0.015);
  EXPECT_EQ(scan.ghost_direction, "front-back");
  EXPECT_NE(findingOf(ball, CheckTopic::ghosts).verdict, Verdict::fine);
  EXPECT_THAT(findingOf(ball, CheckTopic::ghosts).ask, HasSubstr("phase encoding"));
  EXPECT_EQ(findingOf(clean, CheckTopic::ghosts).verdict, Verdict::fine);
}

TEST(ScanQuality, AFewNegativeVoxelsOfAnInterpolatedMrHideNoGhosts) {
  Ball ball = makeBall(4);
  addGhost(ball);
  for (int k = 0; k < 8; ++k) ball.mri.voxels[ball.mri.grid.index(2, 2, 2 * k)] = -1;
  const auto scan = measureScan(ball.mri, ball.mask, ball.skin);
  EXPECT_TRUE(scan.has_ghost_measure);
  EXPECT_FALSE(scan.is_air_signed);
  EXPECT_NEAR(scan.noise, 4, 0.4) << "as of a magnitude image";
  EXPECT_GT(scan.ghost_share, 0.015);
  EXPECT_NE(findingOf(ball, CheckTopic::ghosts).verdict, Verdict::fine);
}

TEST(ScanQuality, GhostsOfACtAreNotMeasurable) {
  for (const char* modality : {"CT", ""}) {  // a NIfTI does not give its modality
    Ball ball = makeBall(10);
    ball.mri.modality = modality;
    for (float& value : ball.mri.voxels) value -= 1000;
    EXPECT_FALSE(measureScan(ball.mri, ball.mask, ball.skin).has_ghost_measure) << modality;
    EXPECT_THAT(findingOf(ball, CheckTopic::ghosts).finding, HasSubstr("not measurable")) << modality;
  }
}

TEST(ScanQuality, SignedNoiseIsItsStandardDeviationAndItsGhostsAreNotMeasurable) {
  Ball ball = makeBall(0);
  std::mt19937 random(7);
  std::normal_distribution<float> normal(0, 10);
  for (float& value : ball.mri.voxels) value += normal(random);
  EXPECT_NEAR(measureScan(ball.mri, ball.mask, ball.skin).noise, 10, 0.4);
  EXPECT_THAT(findingOf(ball, CheckTopic::ghosts).finding, HasSubstr("not measurable"));
}

TEST(ScanQuality, GhostsAreNotMeasurableWhereNoAirBesideTheHeadIsLeft) {
  Ball ball = makeBall(10);
  for (int k = 0; k < kSize; ++k)  // air is left in the corners alone, in line with no part of the head
    for (int j = 0; j < kSize; ++j)
      for (int i = 0; i < kSize; ++i) {
        const int far = (std::abs(i - 48) > 40) + (std::abs(j - 48) > 40) + (std::abs(k - 48) > 40);
        const std::size_t v = ball.mri.grid.index(i, j, k);
        if (far < 2 && !ball.mask.voxels[v]) ball.mri.voxels[v] = 0;
      }
  const auto scan = measureScan(ball.mri, ball.mask, ball.skin);
  EXPECT_FALSE(scan.is_air_blanked);
  EXPECT_GT(scan.noise, 0);
  EXPECT_FALSE(scan.has_ghost_measure);
  EXPECT_THAT(findingOf(ball, CheckTopic::ghosts).finding, HasSubstr("not measurable"));
}

TEST(ScanQuality, ErasedAirIsSaid) {
  Ball ball = makeBall(0);
  for (std::size_t v = 0; v < ball.mri.voxels.size(); ++v)
    if (!ball.mask.voxels[v]) ball.mri.voxels[v] = 0;
  EXPECT_TRUE(measureScan(ball.mri, ball.mask, ball.skin).is_air_blanked);
  EXPECT_THAT(findingOf(ball, CheckTopic::noise).finding, HasSubstr("erased"));
}

TEST(ScanQuality, PartlyErasedAirCountsNeitherAsNoiseNorAsGhosts) {
  Ball ball = makeBall(10);
  for (int k = 0; k < kSize; ++k)  // two corners filled with 0, as after resampling a rotated scan
    for (int j = 0; j < kSize; ++j)
      for (int i = 0; i < kSize; ++i)
        if (i + j < 30 || i + j > 2 * kSize - 30) ball.mri.voxels[ball.mri.grid.index(i, j, k)] = 0;
  const auto scan = measureScan(ball.mri, ball.mask, ball.skin);
  EXPECT_NEAR(scan.noise, 10, 0.4);
  EXPECT_LT(scan.ghost_share, 0.005);
}

TEST(ScanQuality, CutSidesByTheirPatientNames) {
  const Ball top = makeBall(4, {48, 48, kSize - 20});
  const auto scan = measureScan(top.mri, top.mask, top.skin);
  for (const ScanSide& side : scan.sides)
    if (side.name == "top")  // a disc at 19 mm from the centre
      EXPECT_NEAR(side.cut_area_mm2, M_PI * (kRadius_mm * kRadius_mm - 19 * 19), 60);
    else
      EXPECT_EQ(side.cut_area_mm2, 0) << side.name;
  EXPECT_NE(findingOf(top, CheckTopic::vertex).verdict, Verdict::fine);
  Ball flipped = makeBall(4, {20, 48, 48});  // low i is the patient's right where i runs to the left
  flipped.mri.grid.mri_from_voxel.linear()(0, 0) = -1;
  flipped.mask.grid = flipped.mri.grid;
  EXPECT_THAT(findingOf(flipped, CheckTopic::ears).finding, HasSubstr("the right side"));
}

TEST(ScanQuality, WrapAroundOnTheOppositeSide) {
  Ball ball = makeBall(4, {48, kSize - 20, 48});
  EXPECT_EQ(findingOf(ball, CheckTopic::wrap_around).verdict, Verdict::fine);
  for (int k = 0; k < kSize; ++k)
    for (int j = 0; j < 11; ++j)  // tissue beyond the front end reappears at the back
      for (int i = 0; i < kSize; ++i)
        if ((Eigen::Vector3d(i, kSize + j, k) - Eigen::Vector3d(48, kSize - 20, 48)).norm() < kRadius_mm)
          ball.mri.voxels[ball.mri.grid.index(i, j, k)] = float(kSignal);
  const auto finding = findingOf(ball, CheckTopic::wrap_around);
  EXPECT_EQ(finding.verdict, Verdict::caution);
  EXPECT_THAT(finding.finding, HasSubstr("back"));
}

/// A ball that wraps around at the front by 15 mm onto the back, where the head's mask joins it.
Ball foldedOver() {
  Ball ball = makeBall(4, {48, kSize - 15, 48});
  const Eigen::Vector3d behind(48, -15, 48);
  for (int k = 0; k < kSize; ++k)
    for (int j = 0; j < 15; ++j)
      for (int i = 0; i < kSize; ++i)
        if ((Eigen::Vector3d(i, j, k) - behind).norm() < kRadius_mm) {
          ball.mri.voxels[ball.mri.grid.index(i, j, k)] = float(kSignal);
          ball.mask.voxels[ball.mask.grid.index(i, j, k)] = 1;
        }
  return ball;
}

TEST(ScanQuality, FoldOverThatJoinedTheHeadIsFoundAlongFrontAndBackOnly) {
  Ball ball = foldedOver();
  EXPECT_THAT(findingOf(ball, CheckTopic::wrap_around).finding, HasSubstr("the back ("));
  ball.mri.grid.mri_from_voxel.linear() << 0, 1, 0, -1, 0, 0, 0, 0, 1;  // left and right of a head are alike
  ball.mask.grid = ball.mri.grid;
  EXPECT_EQ(findingOf(ball, CheckTopic::wrap_around).verdict, Verdict::fine);
  EXPECT_THAT(findingOf(ball, CheckTopic::ears).finding, HasSubstr("both sides"));
}

/// Sets the slices of the front to one value, as a program pads a scan.
void padFront(Ball& ball, int slices) {
  for (int k = 0; k < kSize; ++k)
    for (int j = kSize - slices; j < kSize; ++j)
      for (int i = 0; i < kSize; ++i) {
        ball.mri.voxels[ball.mri.grid.index(i, j, k)] = 0;
        ball.mask.voxels[ball.mask.grid.index(i, j, k)] = 0;
      }
}

TEST(ScanQuality, APaddedScanEndsWhereItWasMeasured) {
  const auto cutAtFront = [](const Ball& ball) {
    for (const ScanSide& side : measureScan(ball.mri, ball.mask, ball.skin).sides)
      if (side.name == "front") return side.cut_area_mm2;
    return -1.0;
  };
  Ball cut = makeBall(4, {48, 48, 48});
  padFront(cut, kSize - 48 - 20);  // 10 mm of the ball are missing
  EXPECT_NEAR(cutAtFront(cut), M_PI * (kRadius_mm * kRadius_mm - 19 * 19), 60);
  Ball whole = makeBall(4, {48, 48, 48});
  padFront(whole, kSize - 48 - 30);  // the ball ends, rounded, at the padding
  EXPECT_EQ(cutAtFront(whole), 0);
}

TEST(NavigationCheck, UnsureSkinOfTheUpperHeadIsACaution) {
  const Ball ball = makeBall(4);
  ScalpSurface scalp;
  scalp.mesh.vertices_mm = {{0, 0, 0}, {80, 0, 0}, {0, 80, 0}};  // 32 cm2
  scalp.mesh.normals.assign(3, Eigen::Vector3d::UnitZ());
  scalp.mesh.triangles = {{0, 1, 2}};
  const auto skin = [&] {
    for (const auto& finding : checkForNavigation(ball.mri, ball.mask, scalp).findings)
      if (finding.topic == CheckTopic::skin) return finding;
    return CheckFinding{};
  };
  EXPECT_EQ(skin().topic, CheckTopic::skin) << "a case without doubts";
  EXPECT_EQ(skin().verdict, Verdict::fine);
  scalp.doubt_mm = {0.2f, 0.2f, 0.2f};
  EXPECT_EQ(skin().verdict, Verdict::fine);
  scalp.doubt_mm = {1.f, 1.f, 1.f};
  EXPECT_EQ(skin().verdict, Verdict::caution);
  EXPECT_THAT(skin().finding, HasSubstr("32 cm2"));
}

TEST(NavigationCheck, SaysWhatLeftAndRightRestOn) {
  Ball ball = makeBall(4);
  ball.mri.orientation_source = "DICOM";
  EXPECT_EQ(findingOf(ball, CheckTopic::left_and_right).verdict, Verdict::fine);
  ball.mri.orientation_source = "qform";
  EXPECT_EQ(findingOf(ball, CheckTopic::left_and_right).verdict, Verdict::caution);
  EXPECT_THAT(findingOf(ball, CheckTopic::left_and_right).finding, HasSubstr("qform"));
}

TEST(NavigationCheck, WithoutAFaceIsNotUsableAndMeasuresNothing) {
  const Ball ball = makeBall(4);
  ScalpSurface scalp;
  scalp.mesh = ball.skin;
  scalp.findings = {"the face was removed below the brow (a defaced scan): there is no face to align to"};
  const auto check = checkForNavigation(ball.mri, ball.mask, scalp);
  EXPECT_EQ(check.verdict(), Verdict::not_usable);
  EXPECT_TRUE(check.measures.empty());
  EXPECT_THAT(inWords(check.findings[0]), HasSubstr("ask for the original"));
  scalp.findings = {"the scan's edge cuts the face off: there is no face to align to"};
  EXPECT_THAT(inWords(checkForNavigation(ball.mri, ball.mask, scalp).findings[0]),
              HasSubstr("ask for a field of view"));
}

TEST(NavigationCheck, VerdictsByTheirWords) {
  for (const Verdict verdict : {Verdict::fine, Verdict::caution, Verdict::not_usable})
    EXPECT_EQ(verdictFrom(toString(verdict)), verdict);
  EXPECT_THROW(verdictFrom("good"), Error);
}

}  // namespace
}  // namespace facenav::surface
