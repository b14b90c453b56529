#include "facenav/plan/head_field.h"

#include <array>
#include <cmath>
#include <map>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/efield/local_sphere.h"
#include "facenav/efield/primary_field.h"

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

}  // namespace

/// Numbers of places by cube, to find the nearest one.
class KeptPlaces {
 public:
  explicit KeptPlaces(const Eigen::Matrix3Xf& places_mm) : places_mm_(places_mm) {
    for (Eigen::Index i = 0; i < places_mm.cols(); ++i) by_cube_[cubeOf(places_mm.col(i))].push_back(i);
  }
  Eigen::Index nearest(const Eigen::Vector3f& p_mm) const {
    const auto [x, y, z] = cubeOf(p_mm);
    Nearest best;
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dz = -1; dz <= 1; ++dz) {
          const auto there = by_cube_.find({x + dx, y + dy, z + dz});
          if (there == by_cube_.end()) continue;
          for (const Eigen::Index i : there->second) best.take(i, (places_mm_.col(i) - p_mm).squaredNorm());
        }
    if (best.number >= 0 && best.off_mm2 <= kCube_mm * kCube_mm) return best.number;
    for (Eigen::Index i = 0; i < places_mm_.cols(); ++i)  // deep in the brain
      best.take(i, (places_mm_.col(i) - p_mm).squaredNorm());
    return best.number;
  }

 private:
  static constexpr float kCube_mm = 10.0f;
  using Cube = std::array<int, 3>;
  struct Nearest {
    Eigen::Index number = -1;
    float off_mm2 = 0;
    void take(Eigen::Index i, float d_mm2) {
      if (number < 0 || d_mm2 < off_mm2) number = i, off_mm2 = d_mm2;
    }
  };
  static Cube cubeOf(const Eigen::Vector3f& p_mm) {
    const Eigen::Vector3f c = (p_mm / kCube_mm).array().floor();
    return {int(c.x()), int(c.y()), int(c.z())};
  }
  Eigen::Matrix3Xf places_mm_;
  std::map<Cube, std::vector<Eigen::Index>> by_cube_;
};

/// A kept model of the case with its points.
struct KeptShells {
  KeptShells(FieldTier its_tier, efield::CortexField kept)
      : tier(its_tier),
        field(std::move(kept)),
        places(field.points_mm),
        at_mm(field.points_mm.cast<double>()) {}
  FieldTier tier;
  efield::CortexField field;
  KeptPlaces places;
  Eigen::Matrix3Xd at_mm;
};

namespace {

/// Shells give the field at the kept points of the cortex. Elsewhere their difference from the sphere at the
/// nearest kept point is added to the sphere's field: the difference changes slowly.
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
    const Eigen::Matrix3Xf shells = efield::fieldAt(shells_->field, coil, mri_T_coil);
    std::vector<Eigen::Index> nearest(std::size_t(points_mm.cols()));
    Eigen::Matrix3Xd kept_mm(3, points_mm.cols());
    for (Eigen::Index i = 0; i < points_mm.cols(); ++i) {
      nearest[std::size_t(i)] = shells_->places.nearest(points_mm.col(i).cast<float>());
      kept_mm.col(i) = shells_->at_mm.col(nearest[std::size_t(i)]);
    }
    Eigen::Matrix3Xd field = efield::sphereField(coil, mri_T_coil, centre_mm_, points_mm) -
                             efield::sphereField(coil, mri_T_coil, centre_mm_, kept_mm);
    for (Eigen::Index i = 0; i < field.cols(); ++i)
      field.col(i) += shells.col(nearest[std::size_t(i)]).cast<double>();
    return field;
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
    : surfaces_(fieldSurfaces(store)),
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

CoilPose coilPoseOf(const guidance::Target& target) {
  return target.mri_T_target.reframe<Mri, frames::Coil>();  // Target is the wanted pose of Coil
}

}  // namespace facenav::steps
