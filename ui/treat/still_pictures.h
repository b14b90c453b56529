#pragma once
// StillPictures: the pictures for the alignment, taken one by one: a pair with dots and one without, or a
// single pair if there is no projector.

#include <QString>
#include <optional>

#include "facenav/capture/recording.h"
#include "facenav/core/timestamp.h"

namespace facenav::ui {

class StillPictures {
 public:
  void clear();
  /// Takes a pair that suffices alone.
  void take(const cameras::StereoFrame& frame);
  void takeDots(const cameras::StereoFrame& frame);
  /// Takes the pair without dots, after the one with dots. Returns the reason if it is refused, else empty.
  QString takePlain(const cameras::StereoFrame& frame);
  bool hasDots() const { return dots_.has_value(); }
  /// Both pairs, if taken within 20 s of each other.
  std::optional<capture::CapturePair> capture() const;
  /// What to do next.
  QString words() const;

 private:
  std::optional<cameras::StereoFrame> dots_, plain_;
  Timestamp dots_taken_, plain_taken_;
};

}  // namespace facenav::ui
