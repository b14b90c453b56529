#pragma once
// SkinMobility: standard deviation (mm) of the motion of each part's skin over the bone between two moments
// (speech, smile, raised brows). The bridge of the nose, temples and forehead hardly move; cheeks move by
// millimetres in a smile; lips and chin by more than a centimetre.

#include <Eigen/Core>
#include <optional>

#include "facenav/face/face_landmarks.h"

namespace facenav::head_tracking {

/// A part of the face whose skin moves over the bone as one piece.
struct SkinPart {
  int number = 0;         // equal within a part; left and right are two parts
  double sigma_mm = 1.0;  // standard deviation of its motion in each direction
};

class SkinMobility {
 public:
  /// Largest mobility of skin that shows the skull's place: not lips and chin.
  static constexpr double kUpperFace_mm = 1.3;
  /// Assumes that every part moves like the forehead; used without landmarks.
  SkinMobility() = default;
  explicit SkinMobility(const face::FaceLandmarks& face);

  /// The part at a pixel of the image with the landmarks.
  SkinPart at(const Eigen::Vector2d& px) const;

 private:
  bool is_known_ = false;
  Eigen::Vector2d bridge_px_ = Eigen::Vector2d::Zero();  // between the brows' inner ends
  Eigen::Vector2d down_ = Eigen::Vector2d::UnitY();      // unit, towards the base of the nose
  double nose_px_ = 1.0, eyes_px_ = 1.0;                 // nose length; distance between the eyes' middles
};

}  // namespace facenav::head_tracking
