#pragma once
// SkinMobility: how far the skin of each part of the face moves over the bone between two moments (speech,
// smile, raised brows), as a standard deviation in mm. The bridge of the nose, temples and forehead hardly
// move; cheeks move by millimetres in a smile; lips and chin by more than a centimetre.

#include <Eigen/Core>
#include <optional>

#include "facenav/face/face_landmarks.h"

namespace facenav::head_tracking {

/// A part of the face whose skin moves over the bone as one piece.
struct SkinPart {
  int number = 0;         // the same for all of a part; sides are two parts
  double sigma_mm = 1.0;  // standard deviation of its motion, each direction
};

class SkinMobility {
 public:
  static constexpr int kParts = 14;
  /// Without landmarks every part is taken to move like the forehead.
  SkinMobility() = default;
  explicit SkinMobility(const face::FaceLandmarks& face);

  /// At a pixel of the landmarks' picture.
  SkinPart at(const Eigen::Vector2d& px) const;

 private:
  bool is_known_ = false;
  Eigen::Vector2d bridge_px_ = Eigen::Vector2d::Zero();  // between the brows' inner ends
  Eigen::Vector2d down_ = Eigen::Vector2d::UnitY();      // unit, from there to the base of the nose
  double nose_px_ = 1.0, eyes_px_ = 1.0;                 // length of the nose; between the eyes' middles
};

}  // namespace facenav::head_tracking
