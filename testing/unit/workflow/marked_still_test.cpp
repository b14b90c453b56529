// The picture for an alignment without a projector: taken when face and resting marker are seen.

#include "facenav/workflow/marked_still.h"

#include <gmock/gmock.h>

#include "facenav/core/error.h"
#include "support/setup_room.h"

namespace facenav::workflow {
namespace {

using ::testing::HasSubstr;
using testing::RoomShows;
namespace rooms = coil_tracking::testing;

/// What is said of some seconds of a room that shows this.
std::string refusalOf(RoomShows shows, bool has_face, double turned_deg = 0, double limit_s = 3.0) {
  const auto rig = rooms::roomRig();
  const auto room = std::make_shared<testing::SetupRoom>();
  room->shows = shows;
  room->turned_deg = turned_deg;
  testing::SetupRoomSource source(room, rig);
  const auto face = has_face ? std::optional(cv::Rect(220, 130, 200, 200)) : std::nullopt;
  MarkedStill still(rig,
                    {std::make_shared<testing::FixedFace>(face), coil_tracking::makeMarkerCoilTracker()});
  TaskMonitor monitor;
  try {
    takeMarkedStill(source, still, limit_s, monitor);
  } catch (const Error& error) {
    return error.what();
  }
  EXPECT_EQ(still.still().left.cols, rig.width_px);
  EXPECT_FALSE(still.still().right_late_s);
  return still.words();
}

TEST(MarkedStill, IsTakenWhenFaceAndRestingMarkerAreSeen) {
  EXPECT_EQ(refusalOf(RoomShows::marker, true), "the picture is taken");
}

TEST(MarkedStill, SaysWhatIsMissing) {
  EXPECT_THAT(refusalOf(RoomShows::nothing, true), HasSubstr("hold the coil beside the face"));
  EXPECT_THAT(refusalOf(RoomShows::marker, true, 3.0), HasSubstr("does not fit the cameras' calibration"));
  EXPECT_THAT(refusalOf(RoomShows::marker, false), HasSubstr("both cameras must see the whole face"));
}

TEST(MarkedStill, IsTakenOfAFaceThatAMaskHidesFromTheDetector) {
  EXPECT_EQ(refusalOf(RoomShows::marker, false, 0, 10.0), "the picture is taken");
  EXPECT_THAT(refusalOf(RoomShows::nothing, false, 0, 10.0), HasSubstr("hold the coil beside the face"));
}

TEST(MarkedStill, OfCamerasThatMovedIsNone) {
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
  MarkedStill still(
      rig, {std::make_shared<testing::FixedFace>(std::nullopt), coil_tracking::makeMarkerCoilTracker()});
  TaskMonitor monitor;
  EXPECT_THROW(takeMarkedStill(source, still, 1.0, monitor), Error);
  EXPECT_THROW(still.still(), std::logic_error);
}

}  // namespace
}  // namespace facenav::workflow
