#pragma once
// The ALIGN arrow of the data flow: capture pair (with dots, or plain) or film -> face cloud -> Aligner ->
// camera_T_mri at the capture (film: at its first frame), without a click. The face found in the plain pair
// gives a start (patient's right and up, nose tip), the region to measure, and its depth. If no face is
// found, the whole image is measured and the nearest large surface is used.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/capture/recording.h"
#include "facenav/casefile/case_store.h"
#include "facenav/coil_tracking/coil_tracker.h"
#include "facenav/core/error.h"
#include "facenav/core/task_monitor.h"
#include "facenav/face/face_landmarks.h"
#include "facenav/guidance/target.h"
#include "facenav/head_tracking/head_tracker.h"
#include "facenav/health/scale_observation.h"
#include "facenav/measured_face/aligned_from.h"
#include "facenav/measured_face/face_in_space.h"
#include "facenav/registration/aligner.h"
#include "facenav/registration/skin_fit.h"
#include "facenav/stereo/face_cloud.h"
#include "facenav/surface/scalp_surface.h"

namespace facenav::steps {

struct AlignmentOutcome {
  registration::AlignmentResult result;
  bool has_dense_dots = false;  // the face was measured with dots, so its size is certain
  stereo::FaceCloud face;       // input of the aligner; the lists in `result` have one entry per point of it
  std::vector<registration::RegionFit> regions;  // fit of each part of the face, the worst first
  measured_face::FaceInSpace landmarks;
  head_tracking::HeadReference
      reference;                // for the head tracker: plain frame, inlier points with their pixels
  bool is_marker_seen = false;  // a marker of known size measures the cameras' turn since the calibration
  bool is_marker_contradicted = false;  // seen, but it fits neither calibration nor size
  // Standard error and 95th percentile of the error, by target, of the coil held there against the head. They
  // assume that a camera that turned before the capture moves head and coil alike.
  std::map<std::string, double> predicted_tre_mm, predicted_tre_p95_mm;

  measured_face::AlignedFrom from = measured_face::AlignedFrom::dots;
  int fused_frames = 1;                           // number of frames of a film
  std::string matcher = stereo::kDefaultMatcher;  // method that measured the face
  // Field of the skin that the face was aligned to; also used by the drift watchdog.
  std::shared_ptr<const registration::ScalpField> scalp;
  std::shared_ptr<const surface::ScalpSurface> skin;  // the same skin, with its uncertainty

  coil_tracking::CoilModel coil = coil_tracking::defaultCoil();  // the one that will be held at the targets

  /// Standard error at a target, mm: of the pose there and of the skin that the coil rests on.
  double predictedError_mm(const guidance::Target& target) const;
  /// Bound of the coil's error there against the head that 95 of 100 such alignments keep, mm: the figure
  /// that people are shown. It includes the skin and a camera that may have turned.
  double errorBound_mm(const guidance::Target& target) const;
  /// Relative standard error of the measured face's size, from what is known of a right camera that turned
  /// sideways. Nothing: not estimated.
  std::optional<double> faceSizeError() const;
  casefile::StoredAlignment stored() const;
};

/// Refusal because the pictures show too little to measure; other pictures may show more. Every other refusal
/// concerns the head or the cameras.
class NotMeasured : public Error {
 public:
  using Error::Error;
};

/// Refusal because the head moved between the picture with dots and the plain one. One picture alone, or a
/// film, is not affected.
class HeadMoved : public NotMeasured {
 public:
  using NotMeasured::NotMeasured;
};

/// Inputs of every alignment besides the pictures. `field_file`: file of the scalp's distance field
/// (casefile::CaseStore::scalpField()); made if missing. `matcher`: one of stereo::denseMatcherNames(), for
/// pictures with dots. `coil`: the one that will be held at the targets. `coil_tracker`: searches the
/// pictures for its marker; empty: no search.
struct AlignmentSetup {
  const surface::ScalpSurface& scalp;
  const registration::Aligner& aligner;
  const face::FaceDetector& detector;
  const std::vector<guidance::Target>& targets;
  std::filesystem::path field_file = {};
  std::string matcher = stereo::kDefaultMatcher;
  coil_tracking::CoilModel coil = coil_tracking::defaultCoil();
  coil_tracking::CoilTracker* coil_tracker = nullptr;
  /// The marker as observed at rest at the same time, if known. Else the still pair is searched for it.
  std::optional<health::ScaleObservation> marker = {};
  bool is_patient_confirmed = false;  // as in registration::AlignmentStart
};

/// Corners of the coil's first marker while the coil is held at the target.
std::vector<Point<Mri>> markerAt(const guidance::Target& target, const coil_tracking::CoilModel& coil);

/// Aligns from the capture's pair with dots, or from its plain one. Throws Error: an unknown matcher, a scan
/// without a face, NotMeasured, or the aligner's own refusal ("not aligned: ..."), unchanged.
AlignmentOutcome alignFromCapture(const cameras::StereoRig& rig, const capture::CapturePair& capture,
                                  measured_face::AlignedFrom from, const AlignmentSetup& setup,
                                  TaskMonitor& monitor);

/// Aligns from the film's frames `first` to `last` (both included), fused by the head's motion from
/// `tracker`; camera_T_mri is the pose in the first. Throws Error as alignFromCapture and measureFilm do.
AlignmentOutcome alignFromFilm(capture::FrameSource& film, std::int64_t first, std::int64_t last,
                               head_tracking::HeadTracker& tracker, const AlignmentSetup& setup,
                               TaskMonitor& monitor);

}  // namespace facenav::steps
