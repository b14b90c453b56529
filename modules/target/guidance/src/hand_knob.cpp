#include "facenav/guidance/hand_knob.h"

#include <algorithm>

#include "facenav/anatomy/brain_norms.h"
#include "facenav/core/error.h"

namespace facenav::guidance {
namespace {

using anatomy::kLeftHandKnob_mm;
using anatomy::kTemplateBrain_mm;

Eigen::Vector3d scaledHandKnob_mm(const Eigen::AlignedBox3d& brain, Side side) {
  if (brain.isEmpty()) throw Error("no hand area can be guessed: the brain is empty");
  const Eigen::Vector3d scale = brain.sizes().cwiseQuotient(kTemplateBrain_mm.sizes());
  const Eigen::Vector3d from_centre_mm = (kLeftHandKnob_mm - kTemplateBrain_mm.center()).cwiseProduct(scale);
  const double below_vertex_mm =
      (kTemplateBrain_mm.max().z() - kLeftHandKnob_mm.z()) * 0.5 * (scale.x() + scale.y());
  const double lateral_mm = side == Side::left ? from_centre_mm.x() : -from_centre_mm.x();
  return {brain.center().x() + lateral_mm, brain.center().y() + from_centre_mm.y(),
          brain.max().z() - below_vertex_mm};
}

}  // namespace

Point<Mni> handKnob(Side side) {
  Eigen::Vector3d p_mm = kLeftHandKnob_mm;
  if (side == Side::right) p_mm.x() = -p_mm.x();
  return Point<Mni>(p_mm);
}

Point<Mri> handKnobGuess(const surface::BrainModel& brain, Side side) {
  Eigen::AlignedBox3d box;
  for (const auto& vertex_mm : brain.mesh.vertices_mm) box.extend(vertex_mm);
  const Eigen::Vector3d guess_mm = scaledHandKnob_mm(box, side);
  return Point<Mri>(*std::min_element(brain.mesh.vertices_mm.begin(), brain.mesh.vertices_mm.end(),
                                      [&](const auto& a, const auto& b) {
                                        return (a - guess_mm).squaredNorm() < (b - guess_mm).squaredNorm();
                                      }));
}

Point<Mri> handKnobGuess(const volume::Mask& brain, Side side) {
  Eigen::AlignedBox3d box;
  for (int k = 0; k < brain.grid.size[2]; ++k)
    for (int j = 0; j < brain.grid.size[1]; ++j)
      for (int i = 0; i < brain.grid.size[0]; ++i)
        if (brain.at(i, j, k)) box.extend(brain.grid.mri_from_voxel * Eigen::Vector3d(i, j, k));
  return Point<Mri>(scaledHandKnob_mm(box, side));
}

}  // namespace facenav::guidance
