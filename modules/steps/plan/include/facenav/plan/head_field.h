#pragma once
// HeadField: the electric field of a coil in one case's head. Its models are called tiers, from the quickest
// to the surest; headField is the only place that chooses one. Fields in V/m at a rate of the current of 1
// A/us, places in Mri.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "facenav/casefile/case_store.h"
#include "facenav/efield/coil_dipoles.h"
#include "facenav/prepare/case_field.h"

namespace facenav::steps {

using CoilPose = RigidTransform<Mri, frames::Coil>;

/// The surfaces of a case that its field needs.
struct FieldSurfaces {
  surface::TriangleMesh cortex;  ///< with sulci, else the smooth model of the brain
  bool has_sulci = false;
  std::vector<Eigen::Vector3d> skull_mm;   ///< points near the inner skull: the brain's hull
  std::optional<volume::Mask> brain_mask;  ///< nothing if the case has none
};
/// Reads them. Throws Error if the case has no brain.
FieldSurfaces fieldSurfaces(const casefile::CaseStore& store);

/// Model of a head.
class HeadField {
 public:
  virtual ~HeadField() = default;
  virtual FieldTier tier() const = 0;
  /// What the model is, in words: "a sphere fitted to the skull under the coil (radius 74 mm)".
  virtual std::string inWords() const = 0;
  /// Relative error of the field that is usual for this model, 0..1.
  virtual double usualError() const = 0;
  /// False: only the strength is known, and the vectors' directions mean nothing.
  virtual bool hasDirections() const { return true; }
  /// False: the field is known on the cortex alone.
  virtual bool fillsBrain() const { return true; }
  /// Field of a coil at points (3 x n, mm).
  virtual Eigen::Matrix3Xd at(const efield::CoilDipoles& coil, const CoilPose& mri_T_coil,
                              const Eigen::Matrix3Xd& points_mm) const = 0;
};

/// Chooses the surest model that the case has, or the wanted one. `near`: pose near which the field is
/// wanted, for the local sphere. Throws Error if the case has no such model.
std::unique_ptr<HeadField> headField(const casefile::CaseStore& store, const FieldSurfaces& surfaces,
                                     const CoilPose& near, std::optional<FieldTier> wanted = {});

struct KeptShells;
/// Surfaces and surest model of a case, read once for many poses: reading takes longer than a pose.
class ReadHead {
 public:
  /// Throws Error as fieldSurfaces and keptField do.
  explicit ReadHead(const casefile::CaseStore& store);
  const FieldSurfaces& surfaces() const { return surfaces_; }
  FieldTier tier() const;
  /// True if the case keeps three shells that were built before its masks changed, and can have new ones: the
  /// old ones are not used.
  bool isOutdated() const { return stamp_ && !shells_ && can_have_shells_; }
  /// True while the case still keeps the model's file that was read here, or still none.
  bool isCurrent(const casefile::CaseStore& store) const;
  /// The model that headField chooses for a pose.
  std::unique_ptr<HeadField> near(const CoilPose& pose) const;
  /// The field that was imported for a target's pose (imported_field.h). Throws Error if there is none.
  std::unique_ptr<HeadField> imported(const guidance::Target& target) const;
  /// The kept model of the three shells; null: the case has none (pose_fields.h uses it).
  const std::shared_ptr<const KeptShells>& shells() const { return shells_; }

 private:
  casefile::CaseStore store_;
  FieldSurfaces surfaces_;
  /// When the model's file was written, and its size; nothing without a file.
  using Stamp = std::optional<std::pair<std::filesystem::file_time_type, std::uintmax_t>>;
  static Stamp stampOf(const casefile::CaseStore& store);

  Stamp stamp_;  // from before the file is read
  bool can_have_shells_;
  std::shared_ptr<const KeptShells> shells_;
};

/// Pose of the coil on a target as planned, hair and lift included.
CoilPose coilPoseOf(const guidance::Target& target);

}  // namespace facenav::steps
