#include "facenav/plan/pose_target.h"

#include "facenav/guidance/mep_map.h"

namespace facenav::steps {
namespace {

/// Depth of the cortex below the coil's centre if no model of the brain gives it.
constexpr double kUsualCortexDepth_mm = 25;
/// The plate's centre may lie this far below the skin of the model: hair, a dented mask.
constexpr double kDeepestPlate_mm = 15;
constexpr double kFarthestSkin_mm = 60;

}  // namespace

Point<Mri> cortexOnAxis(const casefile::CaseStore& store, const RigidTransform<Mri, Coil>& mri_T_coil,
                        std::optional<double> otherwise_mm) {
  const auto brain = store.brain();
  return cortexOnAxis(brain ? &*brain : nullptr, mri_T_coil, otherwise_mm);
}

Point<Mri> cortexOnAxis(const surface::BrainModel* brain, const RigidTransform<Mri, Coil>& mri_T_coil,
                        std::optional<double> otherwise_mm) {
  if (brain)
    if (const auto met = guidance::axisOnSurface(brain->mesh, mri_T_coil)) return *met;
  return mri_T_coil * Point<Coil>(0, 0, otherwise_mm.value_or(kUsualCortexDepth_mm));
}

Point<Mri> skinOnAxis(const surface::ScalpSurface& scalp, const RigidTransform<Mri, Coil>& mri_T_coil) {
  const RigidTransform<Coil, Coil> back(Eigen::Quaterniond::Identity(), {0, 0, -kDeepestPlate_mm});
  const auto met = guidance::axisOnSurface(scalp.mesh, mri_T_coil * back);
  const Point<Mri> centre(mri_T_coil.translation_mm());
  return met && (met->mm - centre.mm).norm() < kFarthestSkin_mm ? *met : centre;
}

}  // namespace facenav::steps
