#pragma once
// The face that cameras measured at the first visit, as the model that later visits align to, in place of the
// MRI's skin (`facenav face-case`, `facenav export --as home`). An open surface over the points of a capture
// pair with dots, with its measuring error. Later errors are relative to that visit.

#include <optional>
#include <string>

#include "facenav/workflow/align_from_capture.h"

namespace facenav::workflow {

struct FaceModel {
  surface::ScalpSurface skin;                // open at its edges; in Mri, mm
  RigidTransform<Camera, Mri> camera_T_mri;  // where the face was at the capture
  int points = 0;                            // measured points in the model
  double point_sigma_mm = 0;                 // median of a point's standard deviation along the view
  double whole_sigma_mm = 0;                 // standard error that the whole face shares along the view
};

struct FaceModelSetup {
  const face::FaceDetector& detector;
  std::string matcher = stereo::kDefaultMatcher;
  /// Where the face lies in an MRI's frame, and that MRI's skin: only points on it are taken (hair and
  /// clothes are not). Nothing: the frame Mri is the face's own (x the patient's right, z up, the nose's tip
  /// at (0, 95, -30)).
  std::optional<RigidTransform<Camera, Mri>> camera_T_mri = {};
  const registration::ScalpField* scalp = nullptr;
};

/// Throws Error: no dots, no face in both pictures, cameras that moved since their calibration, too small a
/// part of the face.
FaceModel measureFaceModel(const cameras::StereoRig& rig, const capture::CapturePair& capture,
                           const FaceModelSetup& setup, TaskMonitor& monitor);

/// "the face measured in 15400 points (0.12 mm each, 0.2 mm as a whole) stands in for the MRI: ..".
std::string faceFinding(const FaceModel& face);

/// `facenav face-case`: a case without an MRI, made from a recording's capture pair. Throws Error as
/// measureFaceModel and CaseStore::createFromFace do, and for a recording without a capture.
casefile::CaseStore makeFaceCase(const face::FaceDetector& detector, const std::filesystem::path& recording,
                                 const std::filesystem::path& case_folder, const std::string& label,
                                 bool replaces, TaskMonitor& monitor);

}  // namespace facenav::workflow
