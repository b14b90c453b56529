#pragma once
// The region of the face that a skin point belongs to, and how much soft tissue lies there. Regions are laid
// out from the nose tip along the axes of Mri (adult distances, after Farkas 1994). They are exact to a
// centimetre, enough for names and weights.

#include <Eigen/Core>
#include <string>

namespace facenav::anatomy {

class FaceRegions {
 public:
  explicit FaceRegions(const Eigen::Vector3d& nose_tip_mri_mm) : nose_(nose_tip_mri_mm) {}

  /// Name of the region, with the patient's left and right: "forehead", "left brow", "nose", "right
  /// cheekbone", "left cheek", "mouth", "chin", "left jaw", "right temple".
  std::string nameOf(const Eigen::Vector3d& p_mri_mm) const;
  /// Softness of the tissue: 0 where skin lies close to bone (forehead, brow, bridge of the nose,
  /// cheekbones), 1 where it moves and sags (cheeks, lips, jaw).
  double softness(const Eigen::Vector3d& p_mri_mm) const;
  /// Probability that something other than skin is seen there: hair above the hairline and at the temples;
  /// seldom a hand, a coil or a mask on the face.
  double foreignShare(const Eigen::Vector3d& p_mri_mm) const;

 private:
  Eigen::Vector3d nose_;
};

}  // namespace facenav::anatomy
