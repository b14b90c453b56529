// The four steps of the set-up on rendered pictures: place, calibrate, check, coil, and the repair of a bar
// that was bumped.

#include "facenav/setup/rig_setup.h"

#include <gmock/gmock.h>

#include <opencv2/imgproc.hpp>

#include "support/setup_room.h"

namespace facenav::steps {
namespace {

namespace scene = coil_tracking::testing;
using ::testing::HasSubstr;
using testing::RoomShows;
using testing::waitForView;

class RigSetupTest : public ::testing::Test {
 protected:
  std::unique_ptr<RigSetup> open(std::optional<cameras::StereoRig> known = {}) {
    SetupOptions options;
    options.board = testing::kPrintedBoard;
    options.rig = std::move(known);
    return std::make_unique<RigSetup>(std::make_unique<testing::SetupRoomSource>(room_, rig_), options,
                                      testing::setupMethods());
  }
  void show(RigSetup& setup, RoomShows what, SetupStep step) {
    room_->shows = what;
    setup.go(step);
    ASSERT_TRUE(waitForView(setup, [&](const auto& view) { return view.step == step; }));
  }
  static bool isDone(const SetupView& view) { return view.is_done; }

  std::shared_ptr<testing::SetupRoom> room_ = std::make_shared<testing::SetupRoom>();
  cameras::StereoRig rig_ = scene::roomRig();
};

TEST_F(RigSetupTest, CalibratesChecksAndSeesTheCoil) {
  const auto setup = open();
  ASSERT_TRUE(waitForView(*setup, [](const auto& view) { return view.frame && !view.lines.empty(); }));
  EXPECT_FALSE(setup->rig());
  ASSERT_NO_FATAL_FAILURE(show(*setup, RoomShows::new_place, SetupStep::check));
  EXPECT_EQ(setup->latest()->sentence, "calibrate the cameras first");
  ASSERT_NO_FATAL_FAILURE(show(*setup, RoomShows::held_board, SetupStep::calibrate));
  ASSERT_TRUE(waitForView(*setup, [](const auto& view) {
    if (view.sentence.find("is calculated") != std::string::npos) EXPECT_GT(view.views, 3) << "as taken";
    return isDone(view);
  })) << setup->latest()->sentence;
  EXPECT_THAT(setup->latest()->sentence, HasSubstr("at the target; go on"));
  ASSERT_TRUE(setup->uncertainty());
  EXPECT_LT(setup->uncertainty()->point_mm, 1.0);
  EXPECT_NEAR(setup->rig()->baseline_mm(), rig_.baseline_mm(), 1.0);
  ASSERT_NO_FATAL_FAILURE(show(*setup, RoomShows::new_place, SetupStep::check));
  ASSERT_TRUE(waitForView(*setup, isDone)) << setup->latest()->sentence;
  ASSERT_FALSE(setup->latest()->lines.empty());
  EXPECT_THAT(setup->latest()->lines.front().words, HasSubstr("160.00 mm true"));
  EXPECT_THAT(setup->latest()->sentence, HasSubstr("the board measures"));
  EXPECT_THAT(setup->latest()->sentence, HasSubstr("160.00 mm true"));
  EXPECT_THAT(setup->latest()->sentence, HasSubstr("between the measurements"));
  EXPECT_TRUE(setup->verification()->motion.isEnough());
  EXPECT_EQ(setup->verification()->state, health::RigState::holds);
  ASSERT_NO_FATAL_FAILURE(show(*setup, RoomShows::marker, SetupStep::coil));
  EXPECT_TRUE(waitForView(*setup, [](const auto& view) { return view.left_marks.size() == 4; }));
  EXPECT_EQ(setup->latest()->sentence, "the marker is recognised");
}

TEST_F(RigSetupTest, ABumpedBarIsFoundAtTheNextStartAndRepaired) {
  room_->turned_deg = 0.4;
  const auto setup = open(rig_);  // stored state
  ASSERT_NO_FATAL_FAILURE(show(*setup, RoomShows::new_place, SetupStep::check));
  ASSERT_TRUE(waitForView(*setup, [](const auto& view) { return view.needs_repair; }))
      << setup->latest()->sentence;
  EXPECT_THAT(setup->latest()->sentence, HasSubstr("calibrate again"));
  setup->repeatViews();
  ASSERT_NO_FATAL_FAILURE(show(*setup, RoomShows::held_board, SetupStep::calibrate));
  ASSERT_TRUE(waitForView(*setup, isDone)) << setup->latest()->sentence;
  ASSERT_NO_FATAL_FAILURE(show(*setup, RoomShows::new_place, SetupStep::check));
  EXPECT_TRUE(waitForView(*setup, isDone)) << setup->latest()->sentence;
}

TEST_F(RigSetupTest, AMarkerInTwoPlacesChecksAKeptRigToo) {
  const auto setup = open(rig_);
  ASSERT_NO_FATAL_FAILURE(show(*setup, RoomShows::moved_marker, SetupStep::check));
  EXPECT_TRUE(waitForView(*setup, isDone)) << setup->latest()->sentence;
  EXPECT_THAT(setup->latest()->lines.front().words, HasSubstr("marker: "));
}

/// For a board in one place, a rotation and a shift of a camera can cancel each other.
TEST_F(RigSetupTest, ABoardThatStaysInOnePlaceProvesTooLittle) {
  const auto setup = open(rig_);
  ASSERT_NO_FATAL_FAILURE(show(*setup, RoomShows::one_place, SetupStep::check));
  ASSERT_TRUE(waitForView(*setup, [](const auto& view) {
    return view.sentence.find("the first place fits: now move it") != std::string::npos;
  })) << setup->latest()->sentence;
  EXPECT_FALSE(waitForView(*setup, isDone, 3));
  EXPECT_LE(setup->latest()->progress, 0.5);
  ASSERT_EQ(setup->latest()->lines.size(), 2u);
  EXPECT_FALSE(setup->latest()->lines[1].is_good);
  EXPECT_THAT(setup->latest()->lines[1].words, HasSubstr("it moved only"));
  EXPECT_FALSE(setup->verification());
  room_->shows = RoomShows::new_place;
  EXPECT_TRUE(waitForView(*setup, isDone)) << setup->latest()->sentence;
}

/// A film of the board that lies in two files, one pair of which is missing.
class BoardFiles : public capture::FrameSource {
 public:
  BoardFiles(const cameras::StereoRig& rig, std::shared_ptr<std::atomic<int>> pairs_read)
      : film_(rig, testing::boardRound()), pairs_read_(std::move(pairs_read)) {}
  const cameras::StereoRig& rig() const override { return film_.rig(); }
  std::shared_ptr<const cameras::StereoFrame> next() override {
    auto frame = film_.next();
    if (frame) ++*pairs_read_;
    return frame;
  }
  bool isFromFiles() const override { return true; }
  std::string missingPairs() const override { return "1 pair is missing: number 7"; }

 private:
  testing::BoardFilm film_;
  std::shared_ptr<std::atomic<int>> pairs_read_;
};

TEST_F(RigSetupTest, FilesAreReadOnlyAsAStepNeedsThemAndTheirEndLosesNothing) {
  SetupOptions options;
  options.board = testing::kPrintedBoard;
  const auto read = std::make_shared<std::atomic<int>>(0);
  RigSetup setup(std::make_unique<BoardFiles>(rig_, read), options, testing::setupMethods());
  ASSERT_TRUE(waitForView(setup, [](const auto& view) { return bool(view.frame); }));
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_EQ(*read, 1) << "the film waits while the cameras are placed";
  setup.go(SetupStep::calibrate);
  ASSERT_TRUE(waitForView(setup, isDone)) << setup.latest()->sentence;
  const auto view = setup.latest();
  EXPECT_THAT(view->lines.back().words, HasSubstr("1 pair is missing: number 7"));
  EXPECT_TRUE(setup.rig());
  const int after = *read;
  setup.go(SetupStep::check);  // what is left of the film is no new place
  ASSERT_TRUE(waitForView(setup, [](const auto& now) {
    return now.sentence.find("at their end") != std::string::npos || now.is_done;
  }));
  EXPECT_TRUE(setup.latest()->failure.empty()) << setup.latest()->failure;
  EXPECT_GE(*read, after);
  setup.go(SetupStep::calibrate);
  EXPECT_TRUE(waitForView(setup, isDone)) << "still calibrated";
}

TEST_F(RigSetupTest, AnUnpluggedCameraIsSaid) {
  const auto setup = open();
  ASSERT_TRUE(waitForView(*setup, [](const auto& view) { return bool(view.frame); }));
  room_->is_unplugged = true;
  ASSERT_TRUE(waitForView(*setup, [](const auto& view) { return !view.failure.empty(); }));
  EXPECT_THAT(setup->latest()->sentence, HasSubstr("unplugged"));
  EXPECT_FALSE(setup->latest()->is_done);
}

cameras::StereoFrame greyPair(double grey, double right_grey, double detail) {
  cameras::StereoFrame frame;
  cv::RNG random(7);
  for (cv::Mat* image : {&frame.left, &frame.right}) {
    cv::Mat noise(480, 640, CV_32F);
    random.fill(noise, cv::RNG::NORMAL, 0, 60);
    cv::GaussianBlur(noise, noise, {}, detail);
    noise *= 12 * detail / cv::norm(noise, cv::NORM_INF);
    noise += image == &frame.left ? grey : right_grey;
    noise.convertTo(*image, CV_8U);
  }
  return frame;
}

std::string placedWords(const cv::Rect& face, const cameras::StereoFrame& frame) {
  PlacementJudge judge(std::make_shared<testing::FixedFace>(face));
  return judge.judge(frame).words();
}

TEST(PlacementJudge, SaysWhatToDoFirst) {
  const cv::Rect middle(220, 130, 200, 200);
  const auto good = greyPair(120, 120, 1.0);
  EXPECT_EQ(placedWords(middle, good), "the cameras are placed well");
  PlacementJudge nobody(std::make_shared<testing::FixedFace>(std::nullopt));
  EXPECT_THAT(nobody.judge(good).words(), HasSubstr("let a person sit"));
  EXPECT_THAT(placedWords({280, 200, 80, 80}, good), HasSubstr("nearer"));
  EXPECT_THAT(placedWords({100, 30, 420, 420}, good), HasSubstr("away from the face"));
  EXPECT_THAT(placedWords({2, 130, 200, 200}, good), HasSubstr("turn the left camera to its left"));
  EXPECT_THAT(placedWords(middle, greyPair(30, 120, 1.0)), HasSubstr("left picture is too dark"));
  EXPECT_THAT(placedWords(middle, greyPair(120, 240, 1.0)), HasSubstr("right picture is too bright"));
  EXPECT_THAT(placedWords(middle, greyPair(200, 80, 1.0)), HasSubstr("much darker"));
  EXPECT_THAT(placedWords(middle, greyPair(120, 120, 4.0)), HasSubstr("focus"));
}

TEST(BlurEffect, RisesWithTheBlur) {
  double last = 0;
  for (const double detail : {0.6, 1.0, 2.0, 4.0, 8.0}) {
    const double blur = blurEffect(greyPair(120, 120, detail).left);
    EXPECT_GT(blur, last) << detail;
    EXPECT_LE(blur, 1.0);
    last = blur;
  }
}

}  // namespace
}  // namespace facenav::steps
