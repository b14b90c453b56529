#include "facenav/plan/head_field.h"

#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/efield/local_sphere.h"
#include "facenav/efield/primary_field.h"
#include "facenav/plan/imported_field.h"
#include "facenav/prepare/case_field.h"
#include "kept_shells.h"

namespace facenav::steps {
namespace {

// Three shells leave out the fluid round the brain, which changes the field by this much (Stenroos & Koponen
// 2019).
constexpr double kWithoutFluid = 0.23;
// Four shells leave out the difference of white and grey matter (the same), and sulci narrower than their
// triangles: 14,000 against 21,000 vertices of the brain on the virtual patient.
constexpr double kOneTissue = 0.11, kNarrowSulci = 0.16;

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

/// Shells give the field at the kept points of the cortex, and KeptShells::elsewhere at others.
class ShellsHead : public HeadField {
 public:
  ShellsHead(std::shared_ptr<const KeptShells> shells, const efield::LocalSphere& sphere)
      : shells_(std::move(shells)), centre_mm_(sphere.centre_mm) {}
  FieldTier tier() const override { return shells_->tier; }
  std::string inWords() const override {
    return hasFluid() ? "scalp, skull, fluid and brain of the case (four shells with the fluid)"
                      : "scalp, skull and brain of the case (three shells)";
  }
  double usualError() const override {
    return hasFluid() ? std::hypot(kOneTissue, kNarrowSulci) : kWithoutFluid;
  }
  Eigen::Matrix3Xd at(const efield::CoilDipoles& coil, const CoilPose& mri_T_coil,
                      const Eigen::Matrix3Xd& points_mm) const override {
    return shells_->elsewhere(efield::fieldAt(shells_->field, coil, mri_T_coil), coil, mri_T_coil, centre_mm_,
                              points_mm);
  }

 private:
  bool hasFluid() const { return shells_->tier == FieldTier::four_shells; }

  std::shared_ptr<const KeptShells> shells_;
  Eigen::Vector3d centre_mm_;
};

std::shared_ptr<const KeptShells> keptShells(const casefile::CaseStore& store, FieldTier tier) {
  auto kept = keptField(store, tier);
  return kept ? std::make_shared<const KeptShells>(tier, std::move(*kept)) : nullptr;
}

/// The surest shells that the case has; null: none.
std::shared_ptr<const KeptShells> keptShells(const casefile::CaseStore& store) {
  auto shells = keptShells(store, FieldTier::four_shells);
  return shells ? shells : keptShells(store, FieldTier::three_shells);
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
  FACENAV_EXPECT(wanted != FieldTier::imported, "an imported field is that of a target: importedHead()");
  const auto sphere = efield::localSphere(surfaces.skull_mm, near.translation_mm());
  if (wanted == FieldTier::local_sphere) return std::make_unique<SphereHead>(sphere);
  auto shells = wanted ? keptShells(store, *wanted) : keptShells(store);
  if (wanted && !shells) {
    const bool is_fluid = *wanted == FieldTier::four_shells;
    throw Error(formatted("the case's %s shells are not built, or were built before its masks changed",
                          is_fluid ? "four" : "three"),
                store.folder().string(),
                is_fluid ? "build them ('facenav field --tier 2' does), or use tier 1"
                         : "build them ('facenav field' does), or use tier 0");
  }
  return surest(std::move(shells), sphere);
}

ReadHead::ReadHead(const casefile::CaseStore& store)
    : store_(store),
      surfaces_(fieldSurfaces(store)),
      stamp_(stampOf(store)),
      can_have_shells_(canHaveField(store)),
      shells_(keptShells(store)) {}

ReadHead::Stamp ReadHead::stampOf(const casefile::CaseStore& store) {
  std::error_code missing;
  const auto file = fieldFile(store);
  const auto size = std::filesystem::file_size(file, missing);
  if (missing) return std::nullopt;
  const auto written = std::filesystem::last_write_time(file, missing);
  return missing ? Stamp() : Stamp({written, size});
}

bool ReadHead::isCurrent(const casefile::CaseStore& store) const { return stampOf(store) == stamp_; }

FieldTier ReadHead::tier() const { return shells_ ? shells_->tier : FieldTier::local_sphere; }

std::unique_ptr<HeadField> ReadHead::near(const CoilPose& pose) const {
  return surest(shells_, efield::localSphere(surfaces_.skull_mm, pose.translation_mm()));
}

std::unique_ptr<HeadField> ReadHead::imported(const guidance::Target& target) const {
  return importedHead(store_, target);
}

CoilPose coilPoseOf(const guidance::Target& target) {
  return target.mri_T_target.reframe<Mri, frames::Coil>();  // Target is the wanted pose of Coil
}

}  // namespace facenav::steps
