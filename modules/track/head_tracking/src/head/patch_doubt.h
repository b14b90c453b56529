#pragma once
// PatchDoubt: withholds poses of the patches after another person's face, after images off their epipolar
// lines, or after a return with a different appearance, until recovery (lost_face.h) confirms that the face
// is the patient's and the images are in step.

#include <cmath>
#include <optional>

#include "facenav/head_tracking/head_tracker.h"
#include "head_motion.h"
#include "recovery/lost_face.h"

namespace facenav::head_tracking {

class PatchDoubt {
 public:
  struct Fault {
    LostReason reason;
    LossDetail detail;
  };
  static constexpr Fault kOtherFace = {LostReason::no_face, LossDetail::other_face};
  static constexpr Fault kGone = {LostReason::no_face, LossDetail::not_found};
  static constexpr Fault kReturn = {LostReason::no_face, LossDetail::doubtful};  // no evidence against it

  void start(const Fault& fault, Timestamp now) { fault_ = fault, since_ = now, is_face_gone_ = false; }
  void clear() { fault_.reset(), other_seen_.reset(); }

  /// The fault of an answer that is out of step.
  static Fault ofStep(const LostFace::Found& answer) {
    switch (answer.cause) {
      case health::OffsetCause::camera_moved:
        return {LostReason::camera, LossDetail::cameras_moved};
      case health::OffsetCause::two_exposures:
        return {LostReason::camera, LossDetail::out_of_step};
      case health::OffsetCause::unknown:
        break;
    }
    return {LostReason::camera, LossDetail::cameras_disagree};
  }

  /// The present fault. It ends after some seconds without an answer; the patches' own identity check
  /// continues. Where a later answer saw no face, that is what the words say.
  std::optional<Fault> at(Timestamp now) {
    if (fault_ && std::abs(now - since_) > kLongest_s) fault_.reset();
    if (fault_ && is_face_gone_ && fault_->reason == LostReason::camera) return kGone;
    return fault_;
  }

  void hear(const LostFace::Found& answer, Timestamp now) {
    if (answer.is_other) other_seen_ = now, since_ = now;
    is_face_gone_ = !answer.is_out_of_step && !answer.face.identity.isLikelyPatient();
    if (!fault_ || answer.is_out_of_step) return;
    const bool is_of_return = fault_->detail == kReturn.detail;
    const bool says_nothing = !answer.face.identity.isAnswered();
    if (answer.is_patient || (is_of_return && says_nothing)) fault_.reset();
  }

  /// True if another person's face was seen a moment ago.
  bool wasOtherSeen(Timestamp now) const { return other_seen_ && std::abs(now - *other_seen_) < kMoment_s; }

 private:
  static constexpr double kLongest_s = 5.0;
  std::optional<Fault> fault_;
  bool is_face_gone_ = false;
  Timestamp since_;
  std::optional<Timestamp> other_seen_;
};

}  // namespace facenav::head_tracking
