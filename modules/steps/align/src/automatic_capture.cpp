#include "facenav/align/automatic_capture.h"

#include <deque>
#include <opencv2/imgproc.hpp>

#include "facenav/align/known_lengths.h"
#include "facenav/core/error.h"
#include "steady_mean.h"

namespace facenav::steps {
namespace {

// Shortest rest of the marker; a hand at a turning point is still for less.
constexpr double kResting_s = 0.25;
constexpr double kFaceAgain_s = 0.5;  // time until a face that was not found is searched again
// Time after which the picture is taken without a face. A mask or a beard can hide it from the detector; the
// alignment works without its landmarks, and refuses a picture that shows no face. Longer is safer: a patient
// may still be sitting down.
constexpr double kWithoutFace_s = 6.0;
// Number of averaged pictures: those at 30 frames a second while the marker must rest. Evidence:
// resources/doc/evidence.md.
constexpr std::size_t kPictures = 8;
// Fewest pictures with a still face, if the right picture is of another moment: a face that moves in between
// would have a wrong depth.
constexpr int kSteadyPictures = 2;

cv::Rect grown(const cv::Rect& rect, double share) {
  const cv::Size by(int(share * rect.width), int(share * rect.height));
  return {rect.tl() - cv::Point(by), rect.size() + by + by};
}

/// Region of the whole face with forehead and chin; the marker with its white margin is not averaged.
SteadyRegion regionOf(const face::FaceLandmarks& face, const std::array<Eigen::Vector2d, 4>& marker_px) {
  std::vector<cv::Point2f> corners;
  for (const auto& corner : marker_px) corners.emplace_back(float(corner.x()), float(corner.y()));
  return {grown(face.face, 0.4), grown(cv::boundingRect(corners), 0.3)};
}

}  // namespace

struct AutomaticCapture::Implementation {
  Implementation(const cameras::StereoRig& calibrated, AutomaticCaptureMethods with)
      : rig(calibrated), methods(std::move(with)), resting(rig, methods.coil, *methods.coil_tracker) {}
  const cameras::StereoRig rig;
  AutomaticCaptureMethods methods;
  RestingMarker resting;
  std::deque<cameras::StereoFrame> at_rest;  // newest last
  std::optional<double> face_missed_s, face_first_missed_s;
  bool has_face_moved = false;
  std::optional<cameras::StereoFrame> still;

  void keep(const cameras::StereoFrame& frame) {
    at_rest.push_back(frame);
    at_rest.back().left = frame.left.clone();
    at_rest.back().right = frame.right.clone();
    if (at_rest.size() > kPictures) at_rest.pop_front();
  }
  /// Takes the picture. Returns false if the face is not seen, for some seconds, or moves between pictures of
  /// two moments.
  bool take(const cameras::StereoFrame& frame) {
    const auto face = measured_face::findFace(rig, frame, *methods.face_detector);
    if (face.left && face.right) {
      const auto& marker = *resting.last();
      auto mean =
          steadyMean(at_rest, regionOf(*face.left, marker.left_px), regionOf(*face.right, marker.right_px));
      has_face_moved = mean.pictures < kSteadyPictures && !isOfOneMoment(frame);
      if (has_face_moved) return false;
      still = std::move(mean.frame);
      still->right_late_s.reset();  // neither face nor marker moved: the delay has no effect
    } else {
      face_missed_s = frame.captured.s;
      if (!face_first_missed_s) face_first_missed_s = face_missed_s;
      if (*face_missed_s - *face_first_missed_s < kWithoutFace_s) return false;
      still = at_rest.back();  // the face may have moved, so the delay is kept
    }
    return true;
  }
};

AutomaticCapture::AutomaticCapture(const cameras::StereoRig& rig, AutomaticCaptureMethods methods) {
  FACENAV_EXPECT(methods.face_detector && methods.coil_tracker, "a face and a marker are looked for");
  implementation_ = std::make_unique<Implementation>(rig, std::move(methods));
}
AutomaticCapture::~AutomaticCapture() = default;

bool AutomaticCapture::add(const cameras::StereoFrame& frame) {
  Implementation& self = *implementation_;
  if (self.still) return true;
  if (!self.resting.add(frame)) {
    self.at_rest.clear();
    self.face_first_missed_s.reset();
    self.has_face_moved = false;
    return false;
  }
  self.keep(frame);
  if (self.resting.rested_s() < kResting_s) return false;
  if (self.face_missed_s && frame.captured.s - *self.face_missed_s < kFaceAgain_s) return false;
  return self.take(frame);
}

std::string AutomaticCapture::words() const {
  const Implementation& self = *implementation_;
  if (self.still) return "the picture is taken";
  if (self.resting.isContradicted()) return kMarkerContradicted;
  if (!self.resting.isSeen()) return "hold the coil beside the face, its marker to both cameras";
  if (self.resting.rested_s() < kResting_s) return "hold the coil still";
  if (self.has_face_moved) return "hold the head still: the cameras do not expose at the same time";
  return "both cameras must see the whole face: look at them, nothing before the face";
}

const cameras::StereoFrame& AutomaticCapture::still() const {
  FACENAV_EXPECT(implementation_->still, "the picture is not taken yet");
  return *implementation_->still;
}

void takeStillCapture(capture::FrameSource& source, AutomaticCapture& still, double limit_s,
                      TaskMonitor& monitor) {
  std::optional<double> first_s;
  while (const auto frame = source.next()) {
    if (!frame->rig_fault.empty()) throw Error("not aligned: " + frame->rig_fault);
    if (!frame->absence.empty()) continue;
    if (!first_s) first_s = frame->captured.s;
    if (still.add(*frame)) return;
    const double waited_s = frame->captured.s - *first_s;
    monitor.report(still.words(), std::min(1.0, waited_s / limit_s));
    if (waited_s > limit_s) throw Error("no picture was taken: " + still.words());
  }
  throw Error("no picture was taken before the cameras ended: " + still.words());
}

}  // namespace facenav::steps
