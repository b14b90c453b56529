// Automatic choice of board views, on a rendered film of a person who holds it.

#include "facenav/setup/board_collector.h"

#include <gmock/gmock.h>

#include "support/board_film.h"

namespace facenav::steps {
namespace {

namespace scene = coil_tracking::testing;
using State = BoardSight::State;
using ::testing::HasSubstr;

BoardCollector collectorFor(const cameras::StereoRig& rig) {
  return {testing::kPrintedBoard, {rig.width_px, rig.height_px}, BoardRules()};
}

/// Adds one resting board; returns the last sight.
BoardSight hold(BoardCollector& collector, const cameras::StereoRig& rig, const testing::HeldBoard& held,
                double begun_s, const scene::SceneOptions& options = {}) {
  BoardSight sight;
  for (int i = 0; i < 4; ++i)
    sight = collector.add(testing::heldBoardFrame(rig, held, i, begun_s + 0.15 * i, options));
  return sight;
}

TEST(BoardCollector, AFilmOfAHeldBoardGivesTheRig) {
  const auto rig = scene::roomRig();
  auto collector = collectorFor(rig);
  testing::BoardFilm film(rig, testing::boardRound());
  int taken = 0, moving = 0;
  while (const auto frame = film.next()) {
    const auto sight = collector.add(*frame);
    taken += sight.state == State::taken;
    moving += sight.state == State::moving;
  }
  EXPECT_GE(taken, 14);
  EXPECT_GT(moving, taken);
  EXPECT_EQ(collector.coverage().tiltsMissing(), 0);
  EXPECT_TRUE(collector.isEnough()) << collector.views().size() << " views; " << collector.wish();
  TaskMonitor monitor;
  const auto result = collector.calibrate(monitor);
  EXPECT_LT(result.rms_px, 0.1);
  // 1 sigma at 600 mm, as it is shown to the nurse, and the true error of a point there.
  const auto effect = cameras::effectAtHead(result.rig, {0, 0, 600});
  EXPECT_LT(effect.point_mm, 1.0);
  const Eigen::Vector3d point(20, -30, 600);
  const auto measured =
      cameras::triangulate(result.rig, cameras::project(rig.left, point),
                           cameras::project(rig.right, rig.right_T_left.isometry() * point));
  EXPECT_LT((measured.mm - point).norm(), 4 * effect.point_mm + 0.2);
}

TEST(BoardCollector, AMovingBoardIsNotTaken) {
  const auto rig = scene::roomRig();
  auto collector = collectorFor(rig);
  for (int i = 0; i < 6; ++i) {
    testing::HeldBoard held;
    held.side_mm.x() = -15 + 5 * i;
    const auto sight = collector.add(testing::heldBoardFrame(rig, held, i, 0.15 * i));
    EXPECT_EQ(sight.state, State::moving);
    EXPECT_EQ(sight.reason, "hold the board still");
  }
  EXPECT_TRUE(collector.views().empty());
}

TEST(BoardCollector, TheSameViewIsNotTakenTwiceAndItSaysWhatIsMissing) {
  const auto rig = scene::roomRig();
  auto collector = collectorFor(rig);
  const testing::HeldBoard held{600, 25, 90, 0, {0, 0}};
  EXPECT_EQ(hold(collector, rig, held, 0).state, State::taken);
  ASSERT_EQ(collector.views().size(), 1u);
  const auto again = hold(collector, rig, held, 10);
  EXPECT_EQ(again.state, State::known);
  EXPECT_THAT(again.reason, HasSubstr("this view is there already"));
  EXPECT_THAT(collector.wish(), HasSubstr("edge"));
  EXPECT_EQ(collector.views().size(), 1u);
}

TEST(BoardCollector, TellsTheTiltsApart) {
  const auto rig = scene::roomRig();
  // The axis lies in the board's plane: about x (0 deg) top or bottom goes back, about y (90 deg) a side.
  for (const double axis_deg : {0.0, 90.0, 180.0, 270.0}) {
    auto collector = collectorFor(rig);
    hold(collector, rig, {600, 30, axis_deg, 0, {0, 0}}, 0);
    const auto all = collector.coverage();
    const int vertical = int(all.is_top_far) + int(all.is_bottom_far),
              sideways = int(all.is_left_far) + int(all.is_right_far);
    EXPECT_EQ(vertical, std::fmod(axis_deg, 180) == 0 ? 1 : 0) << axis_deg;
    EXPECT_EQ(sideways, std::fmod(axis_deg, 180) == 0 ? 0 : 1) << axis_deg;
    // Squares that are further away appear smaller.
    const auto& corners = collector.views().front().left;
    const double first = cv::norm(corners[1] - corners[0]), last = cv::norm(corners[53] - corners[52]);
    if (vertical == 1 && corners[0].y < corners[53].y) {
      EXPECT_EQ(all.is_top_far, first < last);
    }
  }
}

TEST(BoardCollector, BlurredAndBrightBoardsAreRefusedForTheirReason) {
  const auto rig = scene::roomRig();
  scene::SceneOptions blurred, bright, dark;
  blurred.blur_sigma_px = 5;
  bright.white_grey = 400;
  bright.black_grey = 60;
  for (const auto& [options, words] : {std::pair(blurred, "blurred"), std::pair(bright, "too bright")}) {
    auto collector = collectorFor(rig);
    const auto sight = hold(collector, rig, {}, 0, options);
    EXPECT_EQ(sight.state, State::refused) << words;
    EXPECT_THAT(sight.reason, HasSubstr(words));
    EXPECT_TRUE(collector.views().empty());
    EXPECT_FALSE(collector.refusals().empty());
  }
  dark.white_grey = 40;
  dark.ground_grey = 20;
  auto collector = collectorFor(rig);
  EXPECT_THAT(hold(collector, rig, {}, 0, dark).reason, HasSubstr("more light"));
}

TEST(BoardCollector, ABoardThatOneCameraSeesIsSaid) {
  const auto rig = scene::roomRig();
  auto collector = collectorFor(rig);
  auto frame = testing::heldBoardFrame(rig, {}, 0, 0);
  frame.right.setTo(90);
  const auto sight = collector.add(frame);
  EXPECT_EQ(sight.state, State::one_side);
  EXPECT_THAT(sight.reason, HasSubstr("the right camera does not see the whole board"));
  frame.left.setTo(90);
  EXPECT_EQ(collector.add(frame).state, State::none);
}

TEST(BoardCollector, PicturesOfAnotherSizeAreRefused) {
  const auto rig = scene::roomRig();
  BoardCollector collector(testing::kPrintedBoard, {1280, 720}, BoardRules());
  EXPECT_THROW(collector.add(testing::heldBoardFrame(rig, {}, 0, 0)), Error);
}

}  // namespace
}  // namespace facenav::steps
