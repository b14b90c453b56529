#pragma once
// Recognises the projector's dots in the pictures of a capture, by their own structure: bright points in the
// picture with dots that the plain one lacks. The contrast of the dots does not matter, only that they rise
// above the noise of the difference of the two pictures. Input: 8-bit grey pictures, left camera.

#include <optional>

#include "facenav/capture/recording.h"

namespace facenav::measured_face {

/// Bright points of the difference of the two pictures (pattern minus plain, exposures matched patch by
/// patch).
struct DotsSeen {
  int bright = 0;         // points above the noise that only the picture with dots shows
  int dark = 0;           // such points that only the plain picture shows: chance, and motion in between
  double share = 1.0;     // part of the bright points that was counted: the highest ones
  int area_px = 0;        // lit area of the region
  double contrast = 0.0;  // median height of the bright points relative to the skin around them

  /// True unless chance or motion explains the bright points.
  bool areThere() const;
  /// Mean area that one dot has.
  double areaOfOne_px() const;
};

/// Counts the points in `face`, a part of the left picture; nothing: in the whole picture. No points if the
/// pictures differ in size or type.
DotsSeen findDots(const capture::CapturePair& capture, const std::optional<cv::Rect>& face = {});

/// False if the picture with dots shows none: the projector was off.
bool showsDots(const capture::CapturePair& capture, const std::optional<cv::Rect>& face = {});

/// True if most skin lies between the dots, as with the paper's pattern of one dot in 64 x 64. The face's
/// size is then measured less exactly. False without dots.
bool areDotsSparse(const capture::CapturePair& capture, const std::optional<cv::Rect>& face = {});

}  // namespace facenav::measured_face
