#pragma once
// KeptShells: a kept field model of a case (prepare/case_field.h) with a search for its nearest
// place. Private to plan.

#include <array>
#include <map>
#include <vector>

#include "facenav/efield/cortex_field.h"
#include "facenav/prepare/case_field.h"

namespace facenav::steps {

/// Numbers of places by cube, to find the nearest one.
class KeptPlaces {
 public:
  explicit KeptPlaces(const Eigen::Matrix3Xf& places_mm) : places_mm_(places_mm) {
    for (Eigen::Index i = 0; i < places_mm.cols(); ++i) by_cube_[cubeOf(places_mm.col(i))].push_back(i);
  }
  Eigen::Index nearest(const Eigen::Vector3f& p_mm) const {
    Nearest best = nearestAround(p_mm);
    if (best.number >= 0 && best.off_mm2 <= kCube_mm * kCube_mm) return best.number;
    for (Eigen::Index i = 0; i < places_mm_.cols(); ++i)  // deep in the brain
      best.take(i, (places_mm_.col(i) - p_mm).squaredNorm());
    return best.number;
  }
  /// The nearest place within a distance of at most the cubes' size; -1: there is none.
  Eigen::Index nearestWithin(const Eigen::Vector3f& p_mm, float most_mm) const {
    const Nearest best = nearestAround(p_mm);
    return best.number >= 0 && best.off_mm2 <= most_mm * most_mm ? best.number : -1;
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
  Nearest nearestAround(const Eigen::Vector3f& p_mm) const {
    const auto [x, y, z] = cubeOf(p_mm);
    Nearest best;
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dz = -1; dz <= 1; ++dz) {
          const auto there = by_cube_.find({x + dx, y + dy, z + dz});
          if (there == by_cube_.end()) continue;
          for (const Eigen::Index i : there->second) best.take(i, (places_mm_.col(i) - p_mm).squaredNorm());
        }
    return best;
  }
  static Cube cubeOf(const Eigen::Vector3f& p_mm) {
    const Eigen::Vector3f c = (p_mm / kCube_mm).array().floor();
    return {int(c.x()), int(c.y()), int(c.z())};
  }
  Eigen::Matrix3Xf places_mm_;
  std::map<Cube, std::vector<Eigen::Index>> by_cube_;
};

/// The case's kept model with its points.
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

  /// Field at any points, from `shells`, the field at the kept ones. The difference of the shells from
  /// the sphere about `centre_mm` changes slowly: it is taken from the nearest kept point.
  Eigen::Matrix3Xd elsewhere(const Eigen::Matrix3Xf& shells, const efield::CoilDipoles& coil,
                             const RigidTransform<Mri, frames::Coil>& mri_T_coil,
                             const Eigen::Vector3d& centre_mm, const Eigen::Matrix3Xd& points_mm) const;
};

}  // namespace facenav::steps
