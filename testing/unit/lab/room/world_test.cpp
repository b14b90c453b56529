// Drawn set-ups: the same seed gives the same world, inside the stated ranges; faults change what they say.

#include "facenav/room/world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "egg_patient.h"
#include "facenav/core/number_text.h"
#include "facenav/room/world_room.h"
#include "optics/dot_slide.h"
#include "world/world_view.h"

namespace facenav::room {
namespace {

/// A drawn world with small pictures, so that it renders fast.
World smallWorld(std::uint64_t seed) {
  World world = drawWorld(seed);
  auto& rig = world.cameras.rig;
  const double share = 200.0 / rig.width_px;
  rig.focal_px *= share;
  rig.height_px = int(rig.height_px * share), rig.width_px = 200;
  world.film.noise_grey = 1.0, world.film.jpeg_quality = 0, world.film.is_bayer = false;
  return world;
}

double difference(const cv::Mat& a, const cv::Mat& b) {
  return cv::norm(a, b, cv::NORM_L1) / double(a.total());
}

TEST(World, TheSameSeedGivesTheSameWorld) {
  for (std::uint64_t seed : {0, 1, 7, 4000})
    EXPECT_EQ(columnsOf(drawWorld(seed)), columnsOf(drawWorld(seed)));
  std::set<std::string> focal_lengths;
  for (std::uint64_t seed = 0; seed < 40; ++seed)
    focal_lengths.insert(fixed(drawWorld(seed).cameras.rig.focal_px, 3));
  EXPECT_EQ(focal_lengths.size(), 40u);
}

TEST(World, LiesInsideItsRangesAndShowsTheFaceToBothCameras) {
  int dots = 0, children = 0, windows = 0, compressed = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const World world = drawWorld(seed);
    const auto& rig = world.cameras.rig;
    EXPECT_TRUE(rig.focal_px >= 400 && rig.focal_px <= 2500) << seed;
    EXPECT_TRUE(rig.baseline_mm >= 60 && rig.baseline_mm <= 300) << seed;
    EXPECT_TRUE(rig.convergence_deg >= 0 && rig.convergence_deg <= 25) << seed;
    EXPECT_TRUE(world.cameras.distance_mm >= 350 && world.cameras.distance_mm <= 1500) << seed;
    EXPECT_GE(world.cameras.face_px, kLeastFace_px) << seed;
    const int jpeg = world.film.jpeg_quality;
    EXPECT_TRUE(jpeg == 0 || (jpeg >= 30 && jpeg <= 95)) << seed;
    EXPECT_TRUE(world.film.tone >= 0.45 && world.film.tone <= 1) << seed;
    EXPECT_TRUE(world.film.right_light >= 0.5 && world.film.right_light <= 2) << seed;
    for (const auto* moment : {&world.capture, &world.first, &world.second})
      EXPECT_TRUE(isFaceInView(world, *moment)) << seed;
    dots += world.dots.is_on, children += world.person.is_child;
    windows += !world.wall.windows.empty(), compressed += jpeg > 0;
  }
  EXPECT_NEAR(dots, 180, 40);
  EXPECT_NEAR(children, 60, 30);
  EXPECT_NEAR(windows, 90, 35);
  EXPECT_NEAR(compressed, 225, 35);
}

TEST(World, FaultsHaveTheStatedSizes) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    World world = drawWorld(seed);
    const auto late = drawFault(world, WorldFault::out_of_step);
    EXPECT_TRUE(late.late_s >= 0.01 && late.late_s <= 0.5);
    EXPECT_GE(world.speed_mm_s, 20.0) << "the head moves";
    const auto turned = drawFault(world, WorldFault::turned);
    EXPECT_NEAR(turned.turn_deg.norm(), turned.size, 1e-9);
    EXPECT_TRUE(turned.size >= 0.05 && turned.size <= 2.0);
    const auto shifted = drawFault(world, WorldFault::shifted);
    EXPECT_TRUE(shifted.shift_mm.norm() > 0.29 && shifted.shift_mm.norm() < 10.01);
  }
}

TEST(DotSlide, HasDotsOfTheStatedSizeAndDensity) {
  const cv::Size size(1024, 768);
  for (const double filled : {0.4, 1.0}) {
    const cv::Mat slide = drawDotSlide({16.0, 4.0, filled, 0.0}, size, 3);
    EXPECT_NEAR(cv::countNonZero(slide) / double(size.area()), filled * 16.0 / 256.0, 0.05 * filled);
    EXPECT_EQ(difference(slide, drawDotSlide({16.0, 4.0, filled, 0.0}, size, 3)), 0.0);
  }
}

TEST(Pattern, RepeatsWithItsPeriodBetweenBrightAndDark) {
  for (const auto pattern : {Pattern::stripes, Pattern::checks, Pattern::spots}) {
    double low = 1, high = -1;
    for (double x = 0; x < 40; x += 0.7)
      for (double y = 0; y < 40; y += 0.7) {
        const double value = patternAt(pattern, 20.0, x, y);
        low = std::min(low, value), high = std::max(high, value);
        EXPECT_NEAR(value, patternAt(pattern, 20.0, x + 20.0, y - 40.0), 1e-6);
      }
    EXPECT_EQ(low, -1.0);
    EXPECT_EQ(high, 1.0);
  }
  EXPECT_EQ(patternAt(Pattern::none, 20.0, 3.0, 4.0), 0.0);
}

TEST(WorldRoom, RendersTheSamePicturesAgainWithTheDrawnGreyOfTheFace) {
  World world = smallWorld(3);
  world.film.face_grey = 90.0;
  const auto person = testing::eggPatient();
  WorldRoom room(world, {}, person), again(world, {}, person);
  const auto frame = room.frame(0);
  EXPECT_EQ(difference(frame.left, again.frame(0).left), 0.0);
  EXPECT_EQ(frame.left.size(), cv::Size(world.cameras.rig.width_px, world.cameras.rig.height_px));
  const auto pair = room.capture();
  EXPECT_EQ(pair.pattern.left.empty(), !world.dots.is_on);
  // A patch in the middle of the head: half the drawn grey gives half of it, whatever the tone.
  const Eigen::Vector2d at =
      cameras::project(trueRig(world).left, room.captureTruth().isometry() * person->face_middle.mm);
  const cv::Rect patch(int(at.x()) - 3, int(at.y()) - 3, 7, 7);
  const double grey = cv::mean(pair.plain.left(patch))[0];
  world.film.face_grey = 45.0;
  EXPECT_NEAR(cv::mean(WorldRoom(world, {}, person).capture().plain.left(patch))[0], 0.5 * grey, 1.0);
  EXPECT_LT(grey, 250.0) << "not clipped";
}

TEST(WorldRoom, FaultsChangeThePicturesAsTheySay) {
  World world = smallWorld(5);
  const auto person = testing::eggPatient();
  DrawnFault fault;
  fault.kind = WorldFault::out_of_step, fault.late_s = 0.3;
  world.speed_mm_s = 80.0;
  const auto right = WorldRoom(world, {}, person).frame(2);
  const auto late = WorldRoom(world, fault, person).frame(2);
  EXPECT_EQ(difference(right.left, late.left), 0.0);
  EXPECT_GT(difference(right.right, late.right), 0.3);
  fault = {};
  fault.kind = WorldFault::swapped;
  const auto swapped = WorldRoom(world, fault, person).frame(2);
  EXPECT_EQ(difference(right.left, swapped.right), 0.0);
  EXPECT_EQ(difference(right.right, swapped.left), 0.0);
  fault.kind = WorldFault::frozen, fault.is_from_start = false, fault.frozen_camera = 1;
  WorldRoom frozen(world, fault, person);
  const auto before = frozen.frame(kFirstFrames - 1), after = frozen.frame(kFirstFrames);
  EXPECT_EQ(difference(before.right, after.right), 0.0);
  EXPECT_GT(difference(before.left, after.left), 0.3);
}

TEST(WorldRoom, ACalibrationFindsTheCamerasWithinItsErrors) {
  World world = drawWorld(10);
  world.cameras.corner_px = 0.1;
  const auto truth = trueRig(world), found = calibratedRig(world, truth);
  ASSERT_TRUE(found.rms_px);
  EXPECT_NEAR(*found.rms_px, 0.14, 0.05) << "0.1 px along each axis";
  EXPECT_FALSE(found.covariance.empty());
  EXPECT_NEAR(found.baseline_mm() / truth.baseline_mm(), 1.0, 0.01);
  EXPECT_NEAR(found.left.k(0, 0) / truth.left.k(0, 0), 1.0, 0.01);
}

}  // namespace
}  // namespace facenav::room
