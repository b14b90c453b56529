#include "facenav/setup/rig_start.h"

#include <algorithm>

#include "facenav/core/number_text.h"
#include "start_face.h"

namespace facenav::steps {
namespace {

constexpr int kStartMarkerFrames = 15;  // half a second
constexpr int kMostMarkerFrames = 60;   // longest time in frames that the marker delays the face
constexpr const char* kStartUnclear =
    "whether the calibration holds is not clear yet: both cameras must see the face or the coil's marker";

std::string listed(const char* title, const std::vector<std::string>& lines) {
  std::string words;
  for (const auto& line : lines) words += (words.empty() ? std::string("; ") + title : "; ") + line;
  return words;
}

std::string markerWords(const health::RigVerification& found) {
  if (found.state != health::RigState::holds || found.lengths.empty()) return found.words();
  const auto& length = found.lengths.front();
  return formatted("the calibration holds: the coil's marker measures %.2f mm, %.2f mm true",
                   length.measured_mm, length.true_mm);
}

}  // namespace

bool RigStart::isWithheld() const { return isFault(state) || earlier.has_value(); }

std::string RigStart::words() const {
  std::string words;
  if (earlier && !isFault(state))
    words = "the check of " + earlier->utc + " found a fault that is not repaired: " + earlier->words;
  else
    words = geometry.empty() ? kStartUnclear : geometry;
  if (differs.empty() && state == health::RigState::holds && !earlier)
    words = "cameras, picture size and adjustments are as kept; " + words;
  return words + listed("not as kept: ", differs) + listed("set again as kept: ", restored);
}

struct RigStartCheck::Implementation {
  Implementation(const capture::NamedRig& rig, RigStartMethods methods)
      : has_tracker(methods.coil_tracker != nullptr),
        marker(rig.rig, std::nullopt,
               coil_tracking::squareFinder(std::move(methods.coil_tracker), rig.rig, methods.coil)),
        face(rig.rig, std::move(methods.face_detector)) {
    if (rig.last_check && health::isFault(health::rigStateNamed(rig.last_check->state)))
      earlier = rig.last_check;
  }
  const bool has_tracker;
  health::RigVerifier marker;
  StartFace face;
  health::RigVerification by_marker;
  int marker_frames = 0;
  std::vector<std::string> differs, restored;
  std::optional<capture::RigCheckNote> earlier;

  bool addMarker(const cameras::StereoFrame& frame);
  bool hasMarker() const { return by_marker.state != health::RigState::unclear; }
  void useMarker(RigStart& now) const;
  void useBoth(RigStart& now) const;
};

RigStartCheck::RigStartCheck(const capture::NamedRig& rig, RigStartMethods methods)
    : implementation_(std::make_unique<Implementation>(rig, std::move(methods))) {}
RigStartCheck::~RigStartCheck() = default;
RigStartCheck::RigStartCheck(RigStartCheck&&) noexcept = default;

void RigStartCheck::noteSettings(std::vector<std::string> differs, std::vector<std::string> restored) {
  implementation_->differs = std::move(differs);
  implementation_->restored = std::move(restored);
}

void RigStartCheck::add(const cameras::StereoFrame& frame) {
  Implementation& self = *implementation_;
  // The marker takes half a second if it is seen, a face seconds: so the marker comes first.
  if (!self.hasMarker() && self.has_tracker && self.addMarker(frame)) return;
  self.face.add(frame);
}

/// Measures the marker. Returns true while it is seen and not measured yet.
bool RigStartCheck::Implementation::addMarker(const cameras::StereoFrame& frame) {
  const int before = marker_frames;
  marker.add(frame);
  const auto now = marker.result();
  marker_frames = now.marker_frames;
  if (marker_frames >= kStartMarkerFrames) by_marker = now;
  return marker_frames > before && !hasMarker() && marker_frames < kMostMarkerFrames;
}

void RigStartCheck::Implementation::useMarker(RigStart& now) const {
  now.state = by_marker.state;
  now.by = RigStart::By::marker;
  now.geometry = markerWords(by_marker);
  if (now.state == health::RigState::holds) now.earlier.reset();
}

/// Combines both. The face cannot contradict a valid marker: a head that moved between two exposures looks
/// like a camera that moved.
void RigStartCheck::Implementation::useBoth(RigStart& now) const {
  useMarker(now);
  now.by = RigStart::By::both;
  if (now.state != health::RigState::holds || !isFault(face.state())) return;
  now.state = health::RigState::unclear;
  now.earlier = earlier;
  now.geometry =
      "the coil's marker fits the calibration and the face does not: hold both still, and check "
      "the cameras with the board";
}

RigStart RigStartCheck::result() const {
  const Implementation& self = *implementation_;
  RigStart now;
  now.differs = self.differs;
  now.restored = self.restored;
  now.earlier = self.earlier;
  const bool has_face = self.face.state() != health::RigState::unclear;
  if (self.hasMarker()) {
    has_face ? self.useBoth(now) : self.useMarker(now);
  } else if (has_face) {
    now.state = self.face.state();
    now.by = RigStart::By::face;
    now.geometry = self.face.words();
  }
  return now;
}

bool RigStartCheck::isDone() const {
  return (implementation_->hasMarker() || !implementation_->has_tracker) && implementation_->face.isDone();
}

}  // namespace facenav::steps
