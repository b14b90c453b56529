#pragma once
// CoilCard: the data of coil.json about a coil other than its markers (coil_tracker.h) and its contact
// outline (guidance/coil_plate.h): maker, place of the strongest field, method and time of its calibration.
// Additional keys of coil.json (resources/doc/formats.md), all optional.

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>

#include "facenav/coil_tracking/coil_tracker.h"

namespace facenav::coil_tracking {

/// The key "calibration" of coil.json.
struct CalibrationRecord {
  std::string method;                  // "jig", "pivot"
  std::string utc;                     // 2026-11-23T14:05:09.123Z; empty: not recorded (older files)
  double rms_mm = 0;                   // residual of the fitted points
  double sigma_mm = 0, sigma_deg = 0;  // standard errors of the coil's position and direction
  int frames = 0;                      // number of frames used
};

struct CoilCard {
  std::string name, make, model, serial;
  /// Place of the strongest field, Coil, mm: (0, 0, 0) of a figure-of-eight. Guidance ignores it and aims
  /// with the centre of the contact face.
  Eigen::Vector3d focus_mm = Eigen::Vector3d::Zero();
  bool has_outline = false;  // the file has "contact_outline_mm"
  std::optional<CalibrationRecord> calibration;

  bool isFocusCentred() const { return focus_mm.head<2>().norm() < 1.0; }
};

/// Throws Error naming file and key.
CoilCard readCoilCard(const std::filesystem::path& coil_json);

/// Name of a marker for users: "4x4_50 id 7", "pattern coil.patt".
std::string markerWords(const MarkerModel& marker);
/// True if both coils have the same marker, so that a picture cannot distinguish them.
bool shareMarker(const CoilModel& a, const CoilModel& b);
/// Throws Error if both coils have the same marker.
void requireOwnMarker(const CoilModel& a, const CoilModel& b);
/// Throws Error if a session cannot tell two coils apart: they have the same marker, or one name.
void requireTellable(const CoilModel& a, const CoilModel& b);

}  // namespace facenav::coil_tracking
