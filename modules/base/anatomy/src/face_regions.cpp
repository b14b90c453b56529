#include "facenav/anatomy/face_regions.h"

#include <algorithm>
#include <cmath>

namespace facenav::anatomy {
std::string FaceRegions::nameOf(const Eigen::Vector3d& p_mri_mm) const {
  const Eigen::Vector3d d = p_mri_mm - nose_;
  const double aside = std::abs(d.x()), up = d.z();
  const std::string side = d.x() > 0 ? "right " : "left ";
  if (aside < 17 && up > -15 && up < 45) return "nose";
  if (aside > 60 && up > 15) return side + "temple";
  if (up > 62) return "forehead";
  if (up > 20) return aside < 12 ? "forehead" : side + "brow";
  if (up > -5) return aside > 22 ? side + "cheekbone" : "nose";
  if (aside > 62) return side + "jaw";
  if (aside > 27) return up > -55 ? side + "cheek" : side + "jaw";
  return up > -50 ? "mouth" : "chin";
}

double FaceRegions::softness(const Eigen::Vector3d& p_mri_mm) const {
  const Eigen::Vector3d d = p_mri_mm - nose_;
  const double below = std::clamp((10.0 - d.z()) / 20.0, 0.0, 1.0);
  const double from_nose = std::clamp((std::abs(d.x()) - 14.0) / 8.0, 0.0, 1.0);
  return d.z() > -12 ? below * from_nose : below;
}

double FaceRegions::foreignShare(const Eigen::Vector3d& p_mri_mm) const {
  // The hairline lies 75 to 110 mm above the tip of the nose, and gets lower towards the ears.
  constexpr double kOnSkin = 0.05, kAboveHairline = 0.7, kLowest_mm = 60.0, kHighest_mm = 100.0;
  const Eigen::Vector3d d = p_mri_mm - nose_;
  const double above =
      std::clamp((d.z() + 0.012 * d.x() * d.x() - kLowest_mm) / (kHighest_mm - kLowest_mm), 0.0, 1.0);
  return kOnSkin + (kAboveHairline - kOnSkin) * above;
}

}  // namespace facenav::anatomy
