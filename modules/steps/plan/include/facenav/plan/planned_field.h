#pragma once
// The electric field of a planned pose at the rate of the coil's current, as a window shows it: numbers at
// the target and at the maximum, and the strength on the surface that is drawn. Places in Mri.

#include "facenav/core/task_monitor.h"
#include "facenav/efield/coil_file.h"
#include "facenav/plan/best_pose.h"
#include "facenav/plan/cortex_field.h"
#include "facenav/plan/field_region.h"
#include "facenav/plan/imported_field.h"
#include "facenav/plan/threshold_dose.h"

namespace facenav::steps {

/// Rate of the coil's current, as a person gives it.
struct CurrentRate {
  enum class Unit { A_per_us, output_pct };  // output_pct: % of the rate at the stimulator's full output
  double value = 1;
  Unit unit = Unit::A_per_us;
  bool operator==(const CurrentRate& other) const { return value == other.value && unit == other.unit; }
};
/// Converts it for a coil, A/us. Throws Error for % of a coil whose largest rate is not known.
double inA_per_us(const CurrentRate& rate, const efield::CoilDipoles& coil);

struct WantedField {
  guidance::Target target;
  std::string coil;  ///< as efield::fieldCoil takes it
  CurrentRate rate = {};
  std::shared_ptr<const surface::TriangleMesh> drawn = {};  ///< null: nothing is drawn
  std::optional<guidance::Target> against = {};             ///< target whose pose is compared
  std::optional<HotspotThreshold> threshold = {};
  std::optional<ImportedField> imported = {};  ///< shown in place of a computed field, whatever the coil
};

/// Fields in V/m at the rate.
struct PlannedField {
  FieldTier tier = FieldTier::local_sphere;
  double usual_error = 0;  ///< relative
  double rate_A_per_us = 1;
  double at_target = 0, along_normal = 0;  ///< both > 0; along_normal is no number without directions
  double peak = 0, peak_distance_mm = 0;
  Point<Mri> peak_place;
  std::optional<ThresholdDose> dose = {};  ///< if the threshold is given
  std::vector<float> strength = {};        ///< at the vertices of the drawn surface
};
/// Throws Error as efield::fieldCoil and inA_per_us do; Cancelled.
PlannedField plannedField(const ReadHead& head, const WantedField& wanted, TaskMonitor& monitor);

/// What the field of the planned pose reaches, and how it differs from that of another target's pose; at the
/// rate. It takes longer than plannedField.
struct PlannedReach {
  std::optional<FieldRegions> regions = {};                  ///< nothing if the case has no brain mask
  std::shared_ptr<const volume::Volume> in_brain = nullptr;  ///< V/m, as FieldInBrain::strength
  std::optional<PoseComparison> against = {};
};
/// Throws Error as plannedField; Cancelled.
PlannedReach plannedReach(const ReadHead& head, const WantedField& wanted, const LabelOf& label,
                          TaskMonitor& monitor);
/// Compares with another pose of the coil, at the rate.
PoseComparison comparePlanned(const ReadHead& head, const WantedField& wanted, const guidance::Target& other);

/// Best pose for the target (best_pose.h), its strengths at the rate. Throws as plannedField.
BestPose bestPlannedPose(const ReadHead& head, const PlannedHead& planned, const WantedField& wanted,
                         FieldAim aim, TaskMonitor& monitor);

}  // namespace facenav::steps
