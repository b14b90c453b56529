#pragma once
// TrackerAlignment: how the tool on the head of another tracker (its frame Subject) stands to the MRI, from a
// file that a person made: the pose itself with its error, or points touched on the head. A session without
// cameras starts from it. Mri and Subject, mm.

#include <filesystem>
#include <string>
#include <vector>

#include "facenav/align/align_from_capture.h"

namespace facenav::steps {

/// A place of the head in both frames, touched with a pointer.
struct TouchedPoint {
  std::string name;  // "nasion"
  Point<Mri> in_mri;
  Eigen::Vector3d in_subject_mm = Eigen::Vector3d::Zero();
};

struct TrackerAlignment {
  RigidTransform<Mri, Head> mri_T_subject;  // Head = Subject
  /// The file states it: root mean square error (in space) of a place on the head, or of each touched point.
  double error_mm = 0;
  std::vector<TouchedPoint> points;        // empty: the pose itself is in the file
  double rms_mm = 0;                       // residual of the points
  Matrix6d covariance = Matrix6d::Zero();  // as AlignmentResult::covariance, with Camera = Subject
  std::vector<std::string> cautions;
};

/// Reads the file (resources/doc/formats.md): "mri_T_subject" (16 numbers) or "points", and "error_mm".
/// Throws Error naming file and key: not rigid or mirrored, no error, fewer than three points, points on one
/// line, or points that do not fit each other within their error.
TrackerAlignment readTrackerAlignment(const std::filesystem::path& path);

/// Writes touched points as such a file, for the user alone. Throws Error if they do not make an alignment,
/// and writes nothing then.
void writeTouchedPoints(const std::vector<TouchedPoint>& points, double error_mm,
                        const std::filesystem::path& path);

/// Throws Error if a touched point lies off the case's skin: another head, or another space, is meant.
void requireOnSkin(const TrackerAlignment& alignment, const surface::ScalpSurface& scalp);

/// The alignment as a session takes it: Camera is Subject at the reference.
AlignmentOutcome outcomeOf(const TrackerAlignment& alignment, const casefile::CaseStore& store);

}  // namespace facenav::steps
