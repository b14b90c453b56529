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
  bool has_dense_dots = false;  // the face was measured with them: its size is known well
  stereo::FaceCloud face;       // input of the aligner; the lists in `result` have one entry per point of it
  std::vector<registration::RegionFit> regions;  // fit of each part of the face, the worst first
  measured_face::FaceInSpace landmarks;
  head_tracking::HeadReference
      reference;                // for the head tracker: plain frame, inlier points with their pixels
  bool is_marker_seen = false;  // a marker of known size tells how far a camera turned since the calibration
  bool is_marker_contradicted = false;  // both cameras see it; it fits neither their calibration nor its size
  // Per target: standard error, and the 95th percentile of the error, of the coil held there against the
  // head. A camera that turned before the capture moves both alike.
  std::map<std::string, double> predicted_tre_mm, predicted_tre_p95_mm;

  measured_face::AlignedFrom from = measured_face::AlignedFrom::dots;
  int fused_frames = 1;                           // of a film
  std::string matcher = stereo::kDefaultMatcher;  // that measured the face
  // What the face was aligned to; also used by the drift watchdog.
  std::shared_ptr<const registration::ScalpField> scalp;
  std::shared_ptr<const surface::ScalpSurface> skin;  // the same, with its doubt

  /// Standard error at a target, mm: of the pose there, and of the skin that the coil rests on.
  double predictedError_mm(const guidance::Target& target) const;
  /// The largest predicted error (standard error, mm) at a target; without targets, in the head's middle.
  double worstPredicted_mm() const;
  /// Standard error of the size of the measured face, as a share of it, by what is known of a right camera
  /// that turned sideways. Nothing: that was not estimated.
  std::optional<double> faceSizeError() const;
  casefile::StoredAlignment stored() const;
};

/// The pictures show too little to measure; others may show more. Every other refusal is about the head or
/// the cameras.
class NotMeasured : public Error {
 public:
  using Error::Error;
};

/// What every alignment needs beside the pictures. `field_file`: where the scalp's distance field is kept
/// (casefile::CaseStore::scalpField()); it is made there if missing. `matcher`: one of
/// stereo::denseMatcherNames(), for pictures with dots. `coil`: the one that is going to be held at the
/// targets. `coil_tracker`: looks for its marker in the pictures; empty: nobody looks.
struct AlignmentSetup {
  const surface::ScalpSurface& scalp;
  const registration::Aligner& aligner;
  const face::FaceDetector& detector;
  const std::vector<guidance::Target>& targets;
  std::filesystem::path field_file = {};
  std::string matcher = stereo::kDefaultMatcher;
  coil_tracking::CoilModel coil = coil_tracking::defaultCoil();
  coil_tracking::CoilTracker* coil_tracker = nullptr;
  /// The marker as it was seen at rest at the same time, where that is known. Else the still pair is searched
  /// for it.
  std::optional<health::ScaleObservation> marker = {};
};

/// The corners of the coil's first marker while it is held at the target.
std::vector<Point<Mri>> markerAt(const guidance::Target& target, const coil_tracking::CoilModel& coil);

/// From the capture's pair with dots, or from its plain one. Throws Error: an unknown matcher, a scan without
/// a face, NotMeasured, or the aligner's own refusal ("not aligned: ..."), unchanged.
AlignmentOutcome alignFromCapture(const cameras::StereoRig& rig, const capture::CapturePair& capture,
                                  measured_face::AlignedFrom from, const AlignmentSetup& setup,
                                  TaskMonitor& monitor);

/// From the film's frames `first` to `last` (both included), fused by the head's motion as `tracker` follows
/// it; camera_T_mri is the pose in the first. Throws Error as alignFromCapture and measureFilm do.
AlignmentOutcome alignFromFilm(capture::FrameSource& film, std::int64_t first, std::int64_t last,
                               head_tracking::HeadTracker& tracker, const AlignmentSetup& setup,
                               TaskMonitor& monitor);

}  // namespace facenav::steps
