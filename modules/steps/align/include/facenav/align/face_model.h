#pragma once
// The face measured by cameras at the first visit, as the model that later visits align to, in place of the
// MRI's skin (`facenav face-case`, `facenav export --as home`). An open surface over the points of a capture
// pair (with dots, or plain) or of a film, with its measuring errors. Later errors are relative to that
// visit.

#include <optional>
#include <string>

#include "facenav/align/align_from_capture.h"
#include "facenav/methods/registrations.h"

namespace facenav::steps {

struct FaceModel {
  surface::ScalpSurface skin;                // open at its edges, with its `measurement`; in Mri, mm
  RigidTransform<Camera, Mri> camera_T_mri;  // pose of the face at the capture (a film's first frame)
  measured_face::AlignedFrom from = measured_face::AlignedFrom::dots;
};

struct FaceModelSetup {
  const face::FaceDetector& detector;
  std::string matcher = stereo::kDefaultMatcher;  // for pictures with dots
  /// Pose of the face in an MRI's frame, and that MRI's skin: only points on it are used (not hair and
  /// clothes). Nothing: the frame Mri is the face's own (x the patient's right, z up, the nose's tip at (0,
  /// 95, -30)).
  std::optional<RigidTransform<Camera, Mri>> camera_T_mri = {};
  const registration::ScalpField* scalp = nullptr;
  /// A marker of known size in the same pictures, else the relative standard error of the face's size if
  /// known otherwise. With neither, a face without dots is refused, because nothing shows a sideways turn of
  /// a camera.
  std::optional<health::ScaleObservation> marker = {};
  std::optional<double> size_error = {};
};

/// Measures the face in the capture's pair with dots, or in its plain one. Throws Error: no dots, no face in
/// both pictures, cameras that moved since their calibration, an unknown size, too small a part of the face.
FaceModel measureFaceModel(const cameras::StereoRig& rig, const capture::CapturePair& capture,
                           measured_face::AlignedFrom from, const FaceModelSetup& setup,
                           TaskMonitor& monitor);

/// Measures the face in the film's frames `first` to `last` (both included), fused by the head's motion from
/// `tracker`. Throws Error as above, and as measureFilm does.
FaceModel measureFaceModel(capture::FrameSource& film, std::int64_t first, std::int64_t last,
                           head_tracking::HeadTracker& tracker, const FaceModelSetup& setup,
                           TaskMonitor& monitor);

/// Writes the face of an alignment without dots beside its pictures (alignment_capture/face.vtp), since a
/// film's other pictures are not stored. Writes nothing if no face was measured.
void keepFace(const cameras::StereoRig& rig, const AlignmentOutcome& outcome,
              const std::filesystem::path& case_folder);
/// Reads that face. Throws Error: none was stored, an unknown size, too small a part of the face.
FaceModel keptFace(const casefile::StoredAlignment& alignment, const std::filesystem::path& case_folder);

/// Returns "no MRI: the face measured in 15400 points (0.12 mm each, 0.2 mm as a whole, its size to 0.2 %)
/// stands in for it; ..".
std::string faceFinding(const FaceModel& face);

struct FaceCaseOrder {
  std::filesystem::path recording, case_folder;
  std::string label;
  bool replaces = false;
  std::optional<measured_face::AlignedFrom> from =
      {};  // only this way; nothing: dots, else the film or the plain pair
  /// Coil whose marker may be in the pictures; nothing: the recording's coil.json, else the default one.
  std::optional<coil_tracking::CoilModel> coil = {};
};

/// Implements `facenav face-case`: makes a case without an MRI from a recording. Throws Error as
/// measureFaceModel and CaseStore::createFromFace do.
casefile::CaseStore makeFaceCase(const Registrations& methods, const FaceCaseOrder& order,
                                 TaskMonitor& monitor);

}  // namespace facenav::steps
