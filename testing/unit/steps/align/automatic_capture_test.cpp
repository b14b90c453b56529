// Automatic capture for an alignment without a projector: when face and resting marker are seen.

#include "facenav/align/automatic_capture.h"

#include <gmock/gmock.h>

#include <opencv2/imgproc.hpp>

#include "facenav/core/error.h"
#include "support/setup_room.h"

namespace facenav::steps {
namespace {

using ::testing::HasSubstr;
using testing::RoomShows;
namespace rooms = coil_tracking::testing;

/// Refusal after some seconds of a room that shows this.
std::string refusalOf(RoomShows shows, bool has_face, double turned_deg = 0, double limit_s = 3.0) {
  const auto rig = rooms::roomRig();
  const auto room = std::make_shared<testing::SetupRoom>();
  room->shows = shows;
  room->turned_deg = turned_deg;
  testing::SetupRoomSource source(room, rig);
  const auto face = has_face ? std::optional(cv::Rect(220, 130, 200, 200)) : std::nullopt;
  AutomaticCapture still(
      rig, {std::make_shared<testing::FixedFace>(face), coil_tracking::makeMarkerCoilTracker()});
  TaskMonitor monitor;
  try {
    takeStillCapture(source, still, limit_s, monitor);
  } catch (const Error& error) {
    return error.what();
  }
  EXPECT_EQ(still.still().left.cols, rig.width_px);
  EXPECT_FALSE(still.still().right_late_s);
  return still.words();
}

TEST(AutomaticCapture, IsTakenWhenFaceAndRestingMarkerAreSeen) {
  EXPECT_EQ(refusalOf(RoomShows::marker, true), "the picture is taken");
}

TEST(AutomaticCapture, SaysWhatIsMissing) {
  EXPECT_THAT(refusalOf(RoomShows::nothing, true), HasSubstr("hold the coil beside the face"));
  EXPECT_THAT(refusalOf(RoomShows::marker, true, 3.0), HasSubstr("does not fit the cameras' calibration"));
  EXPECT_THAT(refusalOf(RoomShows::marker, false), HasSubstr("both cameras must see the whole face"));
}

TEST(AutomaticCapture, IsTakenOfAFaceThatAMaskHidesFromTheDetector) {
  EXPECT_EQ(refusalOf(RoomShows::marker, false, 0, 10.0), "the picture is taken");
  EXPECT_THAT(refusalOf(RoomShows::nothing, false, 0, 10.0), HasSubstr("hold the coil beside the face"));
}

/// Film of a face beside a resting marker: its skin shifts by `step_px` from picture to picture. The right
/// picture is `late_s` late.
class FaceBesideMarker : public capture::FrameSource {
 public:
  FaceBesideMarker(double step_px, std::optional<double> late_s) : step_px_(step_px), late_s_(late_s) {
    room_->shows = RoomShows::marker;
    cv::RNG random(5);
    random.fill(skin_, cv::RNG::NORMAL, 0.0, 200.0);
    cv::GaussianBlur(skin_, skin_, {}, 4.0);
  }
  const cameras::StereoRig& rig() const override { return marker_.rig(); }
  std::shared_ptr<const cameras::StereoFrame> next() override {
    auto frame = std::make_shared<cameras::StereoFrame>(*marker_.next());
    for (cv::Mat* picture : {&frame->left, &frame->right}) {
      const cv::Mat motion = (cv::Mat_<double>(2, 3) << 1, 0, step_px_ * double(shown_), 0, 1, 0);
      cv::Mat moved;
      cv::warpAffine(skin_ + 120.0, moved, motion, skin_.size(), cv::INTER_CUBIC, cv::BORDER_REFLECT);
      *picture = picture->clone();
      moved.convertTo((*picture)(kPatch), CV_8U);
    }
    ++shown_;
    frame->right_late_s = late_s_;
    return frame;
  }
  static inline const cv::Rect kPatch{60, 60, 150, 150};

 private:
  double step_px_;
  std::optional<double> late_s_;
  int shown_ = 0;
  std::shared_ptr<testing::SetupRoom> room_ = std::make_shared<testing::SetupRoom>();
  testing::SetupRoomSource marker_{room_, rooms::roomRig()};
  cv::Mat skin_ = cv::Mat(kPatch.size(), CV_32F);
};

/// Picture taken within 3 s; empty if none was taken.
std::optional<cameras::StereoFrame> takenOf(double step_px, std::optional<double> late_s,
                                            std::string& words) {
  FaceBesideMarker source(step_px, late_s);
  AutomaticCapture still(source.rig(), {std::make_shared<testing::FixedFace>(FaceBesideMarker::kPatch),
                                        coil_tracking::makeMarkerCoilTracker()});
  TaskMonitor monitor;
  try {
    takeStillCapture(source, still, 3.0, monitor);
  } catch (const Error& error) {
    words = error.what();
    return std::nullopt;
  }
  return still.still();
}

TEST(AutomaticCapture, OfCamerasThatDoNotExposeTogetherWaitsForTheFaceToBeAtRest) {
  std::string words;
  EXPECT_FALSE(takenOf(1.0, 0.012, words)) << "its depth would be wrong";
  EXPECT_THAT(words, HasSubstr("hold the head still"));
  const auto resting = takenOf(0.0, 0.012, words);
  ASSERT_TRUE(resting);
  EXPECT_FALSE(resting->right_late_s) << "nothing moved in between";
  EXPECT_TRUE(takenOf(1.0, std::nullopt, words)) << "of one moment: no depth is wrong";
}

TEST(AutomaticCapture, OfCamerasThatMovedIsNone) {
  const auto rig = rooms::roomRig();
  struct Faulty : capture::FrameSource {
    const cameras::StereoRig& rig() const override { return rig_; }
    std::shared_ptr<const cameras::StereoFrame> next() override {
      auto frame = std::make_shared<cameras::StereoFrame>();
      frame->rig_fault = "the cameras have moved";
      return frame;
    }
    cameras::StereoRig rig_ = rooms::roomRig();
  } source;
  AutomaticCapture still(
      rig, {std::make_shared<testing::FixedFace>(std::nullopt), coil_tracking::makeMarkerCoilTracker()});
  TaskMonitor monitor;
  EXPECT_THROW(takeStillCapture(source, still, 1.0, monitor), Error);
  EXPECT_THROW(still.still(), std::logic_error);
}

}  // namespace
}  // namespace facenav::steps
