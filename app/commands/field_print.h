#pragma once
// What `facenav field` prints: the field of a planned pose, in words or as JSON.

#include <optional>

#include "facenav/efield/coil_file.h"
#include "facenav/plan/best_pose.h"
#include "facenav/plan/cortex_field.h"
#include "facenav/plan/field_region.h"
#include "facenav/plan/imported_field.h"

namespace facenav::app {

/// Output that gives the target the hotspot's field at the motor threshold.
struct FieldDose {
  std::string hotspot;
  double threshold_pct = 0, output_pct = 0;
};

/// Everything that one call found. Fields are in V/m at 1 A/us.
struct FieldReport {
  guidance::Target target;
  efield::FieldCoil coil;                             // not set unless has_coil
  bool has_coil = true;                               // an imported field needs none
  std::optional<steps::ImportedField> imported = {};  // for this pose, whichever tier is shown
  const steps::HeadField* head = nullptr;
  steps::FieldOnCortex on_cortex;
  bool has_sulci = false;
  std::optional<steps::FieldRegions> regions = {};
  std::optional<double> rate_A_per_us = {};  // nothing: not known, fields are shown at 1 A/us alone
  std::optional<steps::BestPose> best = {};
  double best_s = 0;                                          // time that the search took
  std::optional<steps::PoseComparison> best_comparison = {};  // of the best pose
  std::string against = {};                                   // target whose pose is compared
  std::optional<steps::PoseComparison> pose_comparison = {};
  std::optional<steps::FieldComparison> comparison = {};
  std::optional<steps::FieldComparison> without_fluid = {};  // four shells against three
  std::optional<FieldDose> dose = {};
  bool shows_arrows = false;
};

void printField(const FieldReport& report, bool is_json);

}  // namespace facenav::app
