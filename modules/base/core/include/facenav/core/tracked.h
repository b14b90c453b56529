#pragma once
// Tracked<T>: a live value with its quality, or Lost with the reason. A pose always has a quality, and a lost
// track has no pose: the type makes it impossible to read an old one. In the frame loop it takes the place of
// Error.

#include <optional>
#include <string>
#include <utility>

#include "facenav/core/error.h"

namespace facenav {
inline namespace core {

/// Reason why a track is lost; named as in resources/doc/formats.md (poses.csv).
enum class LostReason { no_face, few_features, no_marker, high_residual, camera, stale };

std::string toString(LostReason reason);
/// Throws Error for any other word.
LostReason lostReasonFromString(const std::string& word);

struct Lost {
  LostReason reason;
};

template <class T>
class Tracked {
 public:
  Tracked(Lost lost) : reason_(lost.reason) {}
  /// `quality` in 0..1.
  Tracked(T value, double quality) : value_(std::move(value)), quality_(quality) {
    FACENAV_EXPECT(quality >= 0.0 && quality <= 1.0, "quality must lie in 0..1");
  }

  bool isTracked() const { return value_.has_value(); }
  explicit operator bool() const { return isTracked(); }
  const T& value() const {
    FACENAV_EXPECT(value_.has_value(), "a lost track has no value");
    return *value_;
  }
  const T& operator*() const { return value(); }
  const T* operator->() const { return &value(); }
  /// Quality, 0..1; 0 if lost.
  double quality() const { return value_ ? quality_ : 0.0; }
  LostReason reason() const {
    FACENAV_EXPECT(!value_.has_value(), "a tracked value has no reason of loss");
    return reason_;
  }

 private:
  std::optional<T> value_;
  double quality_ = 0.0;
  LostReason reason_ = LostReason::stale;
};

}  // namespace core
}  // namespace facenav
