#include "facenav/plan/head_field.h"

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/efield/local_sphere.h"
#include "facenav/efield/primary_field.h"

namespace facenav::steps {
namespace {

class SphereHead : public HeadField {
 public:
  explicit SphereHead(const efield::LocalSphere& sphere) : sphere_(sphere) {}
  FieldTier tier() const override { return FieldTier::local_sphere; }
  std::string inWords() const override {
    return formatted("a sphere fitted to the %s (radius %.0f mm)",
                     sphere_.is_local ? "skull under the coil" : "whole skull", sphere_.radius_mm);
  }
  // Against three shells on one real head, 25 places: 16 %, with all points of the skull 24 %.
  double usualError() const override { return sphere_.is_local ? 0.16 : 0.24; }
  Eigen::Matrix3Xd at(const efield::CoilDipoles& coil, const CoilPose& mri_T_coil,
                      const Eigen::Matrix3Xd& points_mm) const override {
    return efield::sphereField(coil, mri_T_coil, sphere_.centre_mm, points_mm);
  }

 private:
  efield::LocalSphere sphere_;
};

}  // namespace

FieldSurfaces fieldSurfaces(const casefile::CaseStore& store) {
  FieldSurfaces surfaces;
  auto brain = store.brain();
  if (!brain)
    throw Error("the case has no brain model, so its field is not known", store.folder().string(),
                "prepare it from a scan of the whole head");
  surfaces.skull_mm = brain->mesh.vertices_mm;
  if (auto cortex = store.cortex()) {
    surfaces.cortex = std::move(cortex->mesh);
    surfaces.has_sulci = true;
  } else {
    surfaces.cortex = std::move(brain->mesh);
  }
  surfaces.brain_mask = store.brainMask();
  return surfaces;
}

std::unique_ptr<HeadField> headField(const casefile::CaseStore& store, const FieldSurfaces& surfaces,
                                     const CoilPose& near, std::optional<FieldTier> wanted) {
  if (wanted && *wanted != FieldTier::local_sphere)
    throw Error("the case has no field model of tier " + std::to_string(int(*wanted)),
                store.folder().string(), "tier 0 (a local sphere) is always there");
  return std::make_unique<SphereHead>(efield::localSphere(surfaces.skull_mm, near.translation_mm()));
}

CoilPose coilPoseOf(const guidance::Target& target) {
  return target.mri_T_target.reframe<Mri, frames::Coil>();  // Target is the wanted pose of Coil
}

}  // namespace facenav::steps
