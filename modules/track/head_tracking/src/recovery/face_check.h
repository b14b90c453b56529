#pragma once
// FaceCheck: when recovery checks a tracked face, in parallel with the frames (lost_face.h). First, after the
// face returned: it may look different now, and fitting patches are not sufficient evidence. Second, at
// intervals: are both images of one moment, is the face the patient's? A check waits until the head rests, so
// that cameras that expose one after the other have no effect.

#include <cmath>

#include "facenav/core/timestamp.h"

namespace facenav::head_tracking {

class FaceCheck {
 public:
  /// Starts with the track. The reference itself needs no check.
  void start(Timestamp now) { state_ = State::wanted, was_gone_ = true, asked_ = now; }
  /// Requests a check: the face was lost and its patches track it again.
  void faceReturned() { state_ = State::wanted, was_gone_ = true; }
  /// Ignores a pending answer, because the face is lost or the key frames are in doubt.
  void cancel() { state_ = State::none; }

  /// `speed_mm_s`: of the cortex.
  bool isDue(Timestamp now, double speed_mm_s) {
    if (state_ == State::none && std::abs(now - asked_) > kEvery_s) state_ = State::wanted, was_gone_ = false;
    return state_ == State::wanted && speed_mm_s <= kResting_mm_s;
  }
  void asked(Timestamp now) { state_ = State::asked, asked_ = now; }
  bool isAwaited() const { return state_ == State::asked; }
  /// Requests another check, because the answer was undecided.
  void askAgain() { state_ = State::wanted; }
  /// Ends the check, with or without an answer.
  void end() { state_ = State::none; }
  /// True if the face had been lost before this check.
  bool wasGone() const { return was_gone_; }

 private:
  static constexpr double kEvery_s = 1.5;
  static constexpr double kResting_mm_s = 20.0;  // 0.3 mm between exposures half a frame apart
  enum class State { none, wanted, asked };
  State state_ = State::none;
  bool was_gone_ = false;
  Timestamp asked_;
};

}  // namespace facenav::head_tracking
