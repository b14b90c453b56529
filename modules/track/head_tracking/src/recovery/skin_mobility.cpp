#include "skin_mobility.h"

#include <cmath>

namespace facenav::head_tracking {
namespace {

// Standard deviations by part, mm. Assumed, not fitted: a third of the landmark motion in the strongest posed
// expressions (Cosker, Krumhuber, Hilton 2011, FACS-valid 3-D faces: mouth corners 5-15 mm, cheeks 2-5 mm,
// brows 3-6 mm).
constexpr double kBridge_mm = 0.25;
constexpr double kFirm_mm = 0.5;  // forehead, temples, tip of the nose; and a face without landmarks
constexpr double kSoft_mm = 1.2;  // brows, eyes, cheeks
constexpr double kHair_mm = 3.0;  // beyond the hairline, and in front of the ears
constexpr double kMouth_mm = 4.0;
constexpr double kHairline = -0.75, kEars = 1.05;  // a forehead is as high as the nose is long (Farkas 1994)

Eigen::Vector2d mean(const std::vector<Eigen::Vector2d>& points, int first, int last) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int i = first; i <= last; ++i) sum += points[std::size_t(i)] / double(last - first + 1);
  return sum;
}

}  // namespace

SkinMobility::SkinMobility(const face::FaceLandmarks& face) {
  if (face.points68.size() != 68) return;
  const auto& p = face.points68;
  bridge_px_ = 0.5 * (p[21] + p[22]);
  const Eigen::Vector2d nose = p[33] - bridge_px_;
  nose_px_ = nose.norm();
  eyes_px_ = (mean(p, 36, 41) - mean(p, 42, 47)).norm();
  if (nose_px_ < 4 || eyes_px_ < 4) return;
  down_ = nose / nose_px_;
  is_known_ = true;
}

// Part at a place, in units of the nose's length below the brows, and of the distance between the eyes from
// the midline.
SkinPart SkinMobility::at(const Eigen::Vector2d& px) const {
  if (!is_known_) return {0, kFirm_mm};
  const Eigen::Vector2d d = px - bridge_px_, across(-down_.y(), down_.x());
  const double below = d.dot(down_) / nose_px_, sideways = d.dot(across) / eyes_px_;
  const double aside = std::abs(sideways);
  const auto ofSide = [&](int number, double sigma_mm) {
    return SkinPart{number + (sideways > 0), sigma_mm};
  };
  if (below > 1.08) return {1, kMouth_mm};
  if (below < kHairline || aside > kEars) return ofSide(12, kHair_mm);
  if (below < -0.25) return {2, kFirm_mm};
  if (aside < 0.22)
    return below < 0.1    ? SkinPart{2, kFirm_mm}
           : below < 0.75 ? SkinPart{3, kBridge_mm}
                          : SkinPart{0, kFirm_mm};
  if (below < 0.15) return ofSide(4, kSoft_mm);
  if (aside > 0.85 && below < 0.6) return ofSide(6, kFirm_mm);
  return below < 0.55 ? ofSide(8, kSoft_mm) : ofSide(10, kSoft_mm);
}

}  // namespace facenav::head_tracking
