#pragma once
// The ALIGN arrow of the data flow: capture pair (with dots, and plain) -> face cloud -> Aligner ->
// camera_T_mri at the capture, without a click. The face found in the plain pair gives a start (patient's
// right and up, nose tip), the region to measure, and its depth. If no face is found, the whole image is
// measured and the nearest large surface is used.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/capture/recording.h"
#include "facenav/casefile/case_store.h"
#include "facenav/core/task_monitor.h"
#include "facenav/face/face_landmarks.h"
#include "facenav/guidance/target.h"
#include "facenav/head_tracking/head_tracker.h"
#include "facenav/registration/aligner.h"
#include "facenav/registration/skin_fit.h"
#include "facenav/stereo/face_cloud.h"
#include "facenav/surface/scalp_surface.h"

namespace facenav::workflow {

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

registration::SkinModel skinModel(const surface::ScalpSurface& scalp);

struct AlignmentOutcome {
  registration::AlignmentResult result;
  stereo::FaceCloud face;  // input of the aligner; the lists in `result` have one entry per point of it
  std::vector<registration::RegionFit> regions;  // fit of each part of the face, the worst first
  FaceInSpace landmarks;
  head_tracking::HeadReference
      reference;  // for the head tracker: plain frame, inlier points with their pixels
  // Per target: standard error, and the 95th percentile of the error.
  std::map<std::string, double> predicted_tre_mm, predicted_tre_p95_mm;

  std::string matcher = stereo::kDefaultMatcher;  // that measured the face
  // What the face was aligned to; also used by the drift watchdog.
  std::shared_ptr<const registration::ScalpField> scalp;

  casefile::StoredAlignment stored() const;
};

/// `field_file`: where the scalp's distance field is kept (casefile::CaseStore::scalpField()); it is made
/// there if missing. `matcher`: one of stereo::denseMatcherNames(). Throws Error: an unknown matcher, a scan
/// without a face, no dots, or the aligner's own refusal ("not aligned: ..."), unchanged.
AlignmentOutcome alignFromCapture(const cameras::StereoRig& rig, const capture::CapturePair& capture,
                                  const surface::ScalpSurface& scalp, const registration::Aligner& aligner,
                                  const face::FaceDetector& detector,
                                  const std::vector<guidance::Target>& targets, TaskMonitor& monitor,
                                  const std::filesystem::path& field_file = {},
                                  const std::string& matcher = stereo::kDefaultMatcher);

}  // namespace facenav::workflow
