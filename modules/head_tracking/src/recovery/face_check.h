#pragma once
// FaceCheck: when a face that is tracked is asked about all the same, beside the frames (lost_face.h). After
// a return: a face that was gone may look different now, and that its patches fit is not enough. And now and
// then: are the pictures still of one moment, is the face the patient's? Asked while the head rests, so that
// cameras that expose one after the other do no harm.

#include <cmath>

#include "facenav/core/timestamp.h"

namespace facenav::head_tracking {

class FaceCheck {
 public:
  /// The track starts; the reference itself needs no question.
  void start(Timestamp now) { state_ = State::wanted, was_gone_ = true, asked_ = now; }
  /// The face was gone and is tracked again by its patches.
  void faceReturned() { state_ = State::wanted, was_gone_ = true; }
  /// The face is lost, or what was learnt is in doubt: an answer counts no more.
  void cancel() { state_ = State::none; }

  /// `speed_mm_s`: of the cortex.
  bool isDue(Timestamp now, double speed_mm_s) {
    if (state_ == State::none && std::abs(now - asked_) > kEvery_s) state_ = State::wanted, was_gone_ = false;
    return state_ == State::wanted && speed_mm_s <= kResting_mm_s;
  }
  void asked(Timestamp now) { state_ = State::asked, asked_ = now; }
  bool isAwaited() const { return state_ == State::asked; }
  /// The answer decided nothing.
  void askAgain() { state_ = State::wanted; }
  /// The question has come to its end, with or without an answer.
  void end() { state_ = State::none; }
  /// Of the question: whether the face had been gone before it.
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
