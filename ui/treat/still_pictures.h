#pragma once
// StillPictures: the pictures for the alignment, as they are taken one by one: a pair with dots and one
// without, or a single pair where there is no projector.

#include <QString>
#include <optional>

#include "facenav/capture/recording.h"
#include "facenav/core/timestamp.h"

namespace facenav::ui {

class StillPictures {
 public:
  void clear();
  /// A pair that shows all that is needed.
  void take(const cameras::StereoFrame& frame);
  void takeDots(const cameras::StereoFrame& frame);
  /// After the dots. Not empty: why it was not taken.
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
