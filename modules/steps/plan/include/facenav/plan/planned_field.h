#pragma once
// The electric field of a planned pose at the rate of the coil's current, as a window shows it: numbers at
// the target and at the maximum, and the strength on the surface that is drawn. Places in Mri.

#include "facenav/core/task_monitor.h"
#include "facenav/efield/coil_file.h"
#include "facenav/plan/best_pose.h"
#include "facenav/plan/cortex_field.h"
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
  std::optional<HotspotThreshold> threshold = {};
};

/// Fields in V/m at the rate.
struct PlannedField {
  FieldTier tier = FieldTier::local_sphere;
  double usual_error = 0;  ///< relative
  double rate_A_per_us = 1;
  double at_target = 0, along_normal = 0;  ///< both > 0
  double peak = 0, peak_distance_mm = 0;
  Point<Mri> peak_place;
  std::optional<ThresholdDose> dose = {};  ///< if the threshold is given
  std::vector<float> strength = {};        ///< at the vertices of the drawn surface
};
/// Throws Error as efield::fieldCoil and inA_per_us do; Cancelled.
PlannedField plannedField(const ReadHead& head, const WantedField& wanted, TaskMonitor& monitor);

/// Best pose for the target (best_pose.h), its strengths at the rate. Throws as plannedField.
BestPose bestPlannedPose(const ReadHead& head, const PlannedHead& planned, const WantedField& wanted,
                         FieldAim aim, TaskMonitor& monitor);

}  // namespace facenav::steps
