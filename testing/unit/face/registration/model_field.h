#pragma once
// The model head and its field, built once in a test program.

#include "support/model_head.h"

namespace facenav::registration::testing {

inline const facenav::testing::ModelHead& modelHead() {
  static const facenav::testing::ModelHead head;
  return head;
}

inline const ScalpField& modelField() {
  static const ScalpField field(modelHead().skin());
  return field;
}

/// The model head's bald face without clothes as the cameras see it.
inline PointCloud<Camera> modelFace(const RigidTransform<Camera, Mri>& camera_T_mri, int points = 5000,
                                    double noise_mm = 0.1) {
  return facenav::testing::measure(
      modelHead(), camera_T_mri,
      {noise_mm, /*has_hair=*/false, /*has_clothes=*/false, -60, 200, points, /*seed=*/7});
}

inline std::vector<int> allOf(const PointCloud<Camera>& cloud) {
  std::vector<int> all(cloud.size());
  for (std::size_t p = 0; p < all.size(); ++p) all[p] = int(p);
  return all;
}

}  // namespace facenav::registration::testing
