#include "facenav/align/automatic_capture.h"

#include <deque>
#include <opencv2/imgproc.hpp>

#include "facenav/align/known_lengths.h"
#include "facenav/core/error.h"
#include "steady_mean.h"

namespace facenav::steps {
namespace {

// A hand that only passes a turning point is no rest.
constexpr double kResting_s = 0.25;
constexpr double kFaceAgain_s = 0.5;  // a face that is not found is looked for again after this time
// A mask or a beard can hide the face from the detector. The alignment does without its landmarks, and
// refuses a picture that shows no face. Shorter, and a patient who still sits down would be missed.
constexpr double kWithoutFace_s = 6.0;
// Pictures that are averaged: as many as 30 frames a second give while the marker must rest. Chosen before it
// was measured; one smooth face of three (Colin27, seed 163) was refused with one picture and aligned with 8.
constexpr std::size_t kPictures = 8;
// Where the right picture is of another moment, a face that moves in between lies at a wrong depth. It is at
// rest where the newest picture and an earlier one show it at the same place.
constexpr int kSteadyPictures = 2;

cv::Rect grown(const cv::Rect& rect, double share) {
  const cv::Size by(int(share * rect.width), int(share * rect.height));
  return {rect.tl() - cv::Point(by), rect.size() + by + by};
}

/// The whole face with forehead and chin; the marker with its white margin stays as the newest picture has
/// it.
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
  std::deque<cameras::StereoFrame> at_rest;  // the newest last
  std::optional<double> face_missed_s, face_first_missed_s;
  bool has_face_moved = false;
  std::optional<cameras::StereoFrame> still;

  void keep(const cameras::StereoFrame& frame) {
    at_rest.push_back(frame);
    at_rest.back().left = frame.left.clone();
    at_rest.back().right = frame.right.clone();
    if (at_rest.size() > kPictures) at_rest.pop_front();
  }
  /// False where the face is not seen, for some seconds, and where it moves between pictures of two moments.
  bool take(const cameras::StereoFrame& frame) {
    const auto face = measured_face::findFace(rig, frame, *methods.face_detector);
    if (face.left && face.right) {
      const auto& marker = *resting.last();
      auto mean =
          steadyMean(at_rest, regionOf(*face.left, marker.left_px), regionOf(*face.right, marker.right_px));
      has_face_moved = mean.pictures < kSteadyPictures && !isOfOneMoment(frame);
      if (has_face_moved) return false;
      still = std::move(mean.frame);
      still->right_late_s.reset();  // neither face nor marker moved: the delay plays no part
    } else {
      face_missed_s = frame.captured.s;
      if (!face_first_missed_s) face_first_missed_s = face_missed_s;
      if (*face_missed_s - *face_first_missed_s < kWithoutFace_s) return false;
      still = at_rest.back();  // nothing says that this face is at rest: a delay stays stated
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
