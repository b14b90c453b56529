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
#include "facenav/registration/aligner.h"
#include "facenav/registration/skin_fit.h"
#include "facenav/stereo/face_cloud.h"
#include "facenav/surface/scalp_surface.h"

namespace facenav::workflow {

/// What the face was measured on: the capture's pair with projected dots, its plain pair, or a film.
enum class AlignedFrom { dots, plain, film };
const char* nameOf(AlignedFrom from);  // "dots", "plain", "film", as in alignment.json
/// Nothing for another name.
std::optional<AlignedFrom> alignedFrom(const std::string& name);

/// The face as found in both images of a plain pair, and its position in space (Camera, mm).
struct FaceInSpace {
  std::optional<face::FaceLandmarks> left, right;
  registration::AlignmentStart start;   // landmarks that were triangulated to a plausible position
  std::optional<Point<Camera>> centre;  // of the landmarks
};
FaceInSpace findFace(const cameras::StereoRig& rig, const cameras::StereoFrame& plain,
                     const face::FaceDetector& detector);

/// The part of a cloud that is the face: near the landmarks if there are any, else the nearest large surface.
stereo::FaceCloud cutFace(const stereo::FaceCloud& cloud, const FaceInSpace& face);

/// False if the image with dots shows no more detail than the plain one: the projector was off.
bool showsDots(const capture::CapturePair& capture);

/// True if the dots lie so far apart that most skin lies between them, as with the paper's pattern of one dot
/// in 64 x 64. The face's size is measured less exactly there. Dense dots that are taken for sparse ones only
/// make the stated bound wider. Ask showsDots() first: noise in pictures without dots can look like sparse
/// ones.
bool areDotsSparse(const capture::CapturePair& capture);

registration::SkinModel skinModel(const surface::ScalpSurface& scalp);

/// A known length (the coil's marker), as both cameras measure it over its true one, with the standard error
/// of that ratio. A camera that turned sideways since the calibration measures every length too long or too
/// short, as it measures every distance.
struct LengthSeen {
  Point<Camera> at;
  double ratio = 1.0, sigma = 0.0;
};

struct AlignmentOutcome {
  registration::AlignmentResult result;
  bool has_dense_dots = false;  // the face was measured with them: its size is known well
  stereo::FaceCloud face;       // input of the aligner; the lists in `result` have one entry per point of it
  std::vector<registration::RegionFit> regions;  // fit of each part of the face, the worst first
  FaceInSpace landmarks;
  head_tracking::HeadReference
      reference;                // for the head tracker: plain frame, inlier points with their pixels
  bool is_marker_seen = false;  // a marker of known size tells how far a camera turned since the calibration
  bool is_marker_contradicted = false;  // both cameras see it; it fits neither their calibration nor its size
  // Per target: standard error, and the 95th percentile of the error, of the coil held there against the
  // head. A camera that turned before the capture moves both alike.
  std::map<std::string, double> predicted_tre_mm, predicted_tre_p95_mm;

  AlignedFrom from = AlignedFrom::dots;
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
  std::optional<LengthSeen> marker = {};
};

/// The corners of the coil's first marker while it is held at the target.
std::vector<Point<Mri>> markerAt(const guidance::Target& target, const coil_tracking::CoilModel& coil);

/// From the capture's pair with dots, or from its plain one. Throws Error: an unknown matcher, a scan without
/// a face, NotMeasured, or the aligner's own refusal ("not aligned: ..."), unchanged.
AlignmentOutcome alignFromCapture(const cameras::StereoRig& rig, const capture::CapturePair& capture,
                                  AlignedFrom from, const AlignmentSetup& setup, TaskMonitor& monitor);

/// From the film's frames `first` to `last` (both included), fused by the head's motion as `tracker` follows
/// it; camera_T_mri is the pose in the first. Throws Error as alignFromCapture and measureFilm do.
AlignmentOutcome alignFromFilm(capture::FrameSource& film, std::int64_t first, std::int64_t last,
                               head_tracking::HeadTracker& tracker, const AlignmentSetup& setup,
                               TaskMonitor& monitor);

}  // namespace facenav::workflow
