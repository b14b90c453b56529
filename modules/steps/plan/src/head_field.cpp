#include "facenav/plan/head_field.h"

#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/efield/local_sphere.h"
#include "facenav/efield/primary_field.h"
#include "facenav/prepare/case_field.h"
#include "kept_shells.h"

namespace facenav::steps {
namespace {

// Three shells leave out the fluid round the brain, which changes the field by this much (Stenroos & Koponen
// 2019).
constexpr double kWithoutFluid = 0.23;

class SphereHead : public HeadField {
 public:
  explicit SphereHead(const efield::LocalSphere& sphere) : sphere_(sphere) {}
  FieldTier tier() const override { return FieldTier::local_sphere; }
  std::string inWords() const override {
    return formatted("a sphere fitted to the %s (radius %.0f mm)",
                     sphere_.is_local ? "skull under the coil" : "whole skull", sphere_.radius_mm);
  }
  // Against three shells on one real head, 25 places: 16 %, with all points of the skull 24 %.
  double usualError() const override { return std::hypot(sphere_.is_local ? 0.16 : 0.24, kWithoutFluid); }
  Eigen::Matrix3Xd at(const efield::CoilDipoles& coil, const CoilPose& mri_T_coil,
                      const Eigen::Matrix3Xd& points_mm) const override {
    return efield::sphereField(coil, mri_T_coil, sphere_.centre_mm, points_mm);
  }

 private:
  efield::LocalSphere sphere_;
};

/// Three shells give the field at the kept points of the cortex, and KeptShells::elsewhere at others.
class ShellsHead : public HeadField {
 public:
  ShellsHead(std::shared_ptr<const KeptShells> shells, const efield::LocalSphere& sphere)
      : shells_(std::move(shells)), centre_mm_(sphere.centre_mm) {}
  FieldTier tier() const override { return FieldTier::three_shells; }
  std::string inWords() const override { return "scalp, skull and brain of the case (three shells)"; }
  double usualError() const override { return kWithoutFluid; }
  Eigen::Matrix3Xd at(const efield::CoilDipoles& coil, const CoilPose& mri_T_coil,
                      const Eigen::Matrix3Xd& points_mm) const override {
    return shells_->elsewhere(efield::fieldAt(shells_->field, coil, mri_T_coil), coil, mri_T_coil, centre_mm_,
                              points_mm);
  }

 private:
  std::shared_ptr<const KeptShells> shells_;
  Eigen::Vector3d centre_mm_;
};

std::shared_ptr<const KeptShells> keptShells(const casefile::CaseStore& store) {
  auto kept = keptField(store);
  return kept ? std::make_shared<const KeptShells>(std::move(*kept)) : nullptr;
}

std::unique_ptr<HeadField> surest(std::shared_ptr<const KeptShells> shells,
                                  const efield::LocalSphere& sphere) {
  if (shells) return std::make_unique<ShellsHead>(std::move(shells), sphere);
  return std::make_unique<SphereHead>(sphere);
}

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
  const auto sphere = efield::localSphere(surfaces.skull_mm, near.translation_mm());
  if (wanted == FieldTier::local_sphere) return std::make_unique<SphereHead>(sphere);
  if (wanted && *wanted != FieldTier::three_shells)
    throw Error("no field model of tier " + std::to_string(int(*wanted)) + " is built yet",
                store.folder().string(), "use tier 1 (three shells) or 0 (a local sphere)");
  auto shells = keptShells(store);
  if (wanted && !shells)
    throw Error("the case's three shells are not built, or were built before its masks changed",
                store.folder().string(), "build them ('facenav field' does), or use tier 0");
  return surest(std::move(shells), sphere);
}

ReadHead::ReadHead(const casefile::CaseStore& store)
    : surfaces_(fieldSurfaces(store)), shells_(keptShells(store)) {}

FieldTier ReadHead::tier() const { return shells_ ? FieldTier::three_shells : FieldTier::local_sphere; }

std::unique_ptr<HeadField> ReadHead::near(const CoilPose& pose) const {
  return surest(shells_, efield::localSphere(surfaces_.skull_mm, pose.translation_mm()));
}

CoilPose coilPoseOf(const guidance::Target& target) {
  return target.mri_T_target.reframe<Mri, frames::Coil>();  // Target is the wanted pose of Coil
}

}  // namespace facenav::steps
