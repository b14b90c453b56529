#pragma once
// CoilCard: what coil.json says of a coil beside its markers (coil_tracker.h) and its contact outline
// (guidance/coil_plate.h): who made it, where its field is strongest, and how and when it was calibrated.
// Additional keys of resources/doc/formats.md's coil.json, all optional.

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>

#include "facenav/coil_tracking/coil_tracker.h"

namespace facenav::coil_tracking {

/// "calibration" of coil.json.
struct CalibrationRecord {
  std::string method;                  // "jig", "pivot"
  std::string utc;                     // 2026-11-23T14:05:09.123Z; empty: not recorded (older files)
  double rms_mm = 0;                   // residual of the fitted points
  double sigma_mm = 0, sigma_deg = 0;  // standard errors of the coil's position and direction
  int frames = 0;                      // used
};

struct CoilCard {
  std::string name, make, model, serial;
  /// Where the field is strongest, Coil, mm: (0, 0, 0) of a figure-of-eight. Guidance aims with the centre of
  /// the contact face, whatever stands here.
  Eigen::Vector3d focus_mm = Eigen::Vector3d::Zero();
  bool has_outline = false;  // "contact_outline_mm" is there
  std::optional<CalibrationRecord> calibration;

  bool isFocusCentred() const { return focus_mm.head<2>().norm() < 1.0; }
};

/// Throws Error naming file and key.
CoilCard readCoilCard(const std::filesystem::path& coil_json);

/// "4x4_50 id 7", "pattern coil.patt": the print by which a coil is known.
std::string markerWords(const MarkerModel& marker);
/// True where both carry the same print, so that a picture cannot tell one from the other.
bool shareMarker(const CoilModel& a, const CoilModel& b);

}  // namespace facenav::coil_tracking
