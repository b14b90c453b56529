#include "facenav/workflow/align_from_capture.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <future>
#include <opencv2/imgproc.hpp>

#include "facenav/core/error.h"
#include "facenav/monitoring/pair_fault.h"
#include "facenav/monitoring/rig_check.h"
#include "facenav/workflow/settings.h"
#include "facenav/workflow/shared_depth.h"

namespace facenav::workflow {
namespace {

/// The face's box, enlarged to include forehead, chin and temples; nothing if no face was found.
std::optional<cv::Rect> region(const FaceInSpace& face, const cameras::StereoRig& rig) {
  if (!face.left) return std::nullopt;
  const cv::Rect& box = face.left->face;
  const int grow_x = box.width / 2, grow_y = int(0.6 * box.height);
  const cv::Rect grown(box.x - grow_x, box.y - grow_y, box.width + 2 * grow_x, box.height + 2 * grow_y);
  const cv::Rect inside = grown & cv::Rect(0, 0, rig.width_px, rig.height_px);
  if (inside.area() <= 0) return std::nullopt;
  return inside;
}

stereo::FaceCloudOptions measuringOptions(const FaceInSpace& face, const cameras::StereoRig& rig,
                                          const std::string& matcher) {
  stereo::FaceCloudOptions options = stereo::dottedFaceOptions(matcher);
  options.left_roi = region(face, rig);
  if (face.centre) {
    options.nearest_mm = std::max(100.0, face.centre->mm.z() - 180.0);
    options.farthest_mm = face.centre->mm.z() + 220.0;
  }
  return options;
}

constexpr double kClearStatistic = 40;  // as in RigCheck: twice the monitor's own threshold
constexpr int kFineScale_px = 9;
constexpr double kDotsContrast = 1.5;  // ratio of fine detail with dots to that without; without dots it is 1

/// Fine detail relative to the mean grey level.
double fineContrast(const cv::Mat& image) {
  cv::Mat grey, smooth;
  image.convertTo(grey, CV_32F);
  cv::boxFilter(grey, smooth, -1, {kFineScale_px, kFineScale_px});
  return cv::norm(grey - smooth, cv::NORM_L2) / std::max(1.0, cv::norm(grey, cv::NORM_L2));
}

}  // namespace

bool showsDots(const capture::CapturePair& capture) {
  return fineContrast(capture.pattern.left) > kDotsContrast * fineContrast(capture.plain.left);
}

namespace {

/// The calibration is no longer valid: searching elsewhere for the face would not help.
class CamerasMoved : public Error {
 public:
  using Error::Error;
};

/// Runs `task` and returns its error if another way may help. Errors that no other way avoids are rethrown: a
/// fault of the cameras, and the user's stop.
std::optional<Error> errorOf(const std::function<void()>& task) {
  try {
    task();
    return std::nullopt;
  } catch (const CamerasMoved&) {
    throw;
  } catch (const monitoring::PairError&) {
    throw;
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    return error;
  }
}

/// Throws CamerasMoved if points of the face, matched again, show it.
void requireUnmovedCameras(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                           const cameras::StereoFrame& plain, const stereo::FaceCloud& face) {
  cameras::RigMonitor monitor(rig);
  monitor.add(monitoring::matchSurface(rig, frame, face.cloud, face.left_px));
  const auto verdict = monitor.verdict();
  if (!verdict.hasMoved()) return;
  const auto diagnosis = cameras::diagnosePair(rig, plain);
  if (diagnosis.isFault()) throw monitoring::PairError(diagnosis, "not aligned: ");
  // If plain skin disagrees a little but the whole plain pair fits, the cameras did not move.
  const bool is_clear = verdict.statistic > kClearStatistic && showsDots({frame, plain});
  if (diagnosis.fault != cameras::PairFault::none || is_clear)
    throw CamerasMoved("not aligned: " + verdict.words(), {}, "'facenav calibrate'");
}

/// The aligner and the measurement know only that nothing fits. This checks the cameras first, then the dots;
/// if both are in order, it reports the original error.
[[noreturn]] void refuse(const cameras::StereoRig& rig, const capture::CapturePair& capture,
                         const Error& error, const std::string& matcher) {
  const auto diagnosis = cameras::diagnosePair(rig, capture.plain);
  if (diagnosis.isFault()) throw monitoring::PairError(diagnosis, "not aligned: ");
  if (showsDots(capture)) throw error;
  std::string reason = error.what();
  const std::string prefix = "not aligned: ";
  if (reason.rfind(prefix, 0) == 0) reason.erase(0, prefix.size());
  const bool is_default = matcher == stereo::kDefaultMatcher;
  throw Error(prefix + "the capture's picture for the dots shows none (switch the projector on" +
              (is_default ? "" : ": the matcher '" + matcher + "' needs them") +
              "); without them: " + reason);
}

registration::AlignmentStart withSharedDepth(registration::AlignmentStart start,
                                             const cameras::StereoRig& rig, const PointCloud<Camera>& face) {
  start.shared_depth_sigma_mm = sharedDepthSigma_mm(rig, face);
  return start;
}

head_tracking::HeadReference makeReference(const cameras::StereoFrame& plain, const stereo::FaceCloud& face,
                                           const registration::AlignmentResult& result) {
  head_tracking::HeadReference reference;
  reference.frame = plain;
  const bool has_pixels = face.left_px.size() == face.cloud.size();
  const bool has_flags = result.is_inlier.size() == face.cloud.size();
  const bool has_normals = face.cloud.normals.size() == face.cloud.size();
  for (std::size_t i = 0; has_pixels && i < face.cloud.size(); ++i) {
    // Hair and coil can move relative to the skull, or disappear.
    if (has_flags && !result.is_inlier[i]) continue;
    reference.surface.points_mm.push_back(face.cloud.points_mm[i]);
    if (has_normals) reference.surface.normals.push_back(face.cloud.normals[i]);
    reference.surface_left_px.push_back(face.left_px[i]);
  }
  return reference;
}

/// Runs `measureAndFit`; if it fails, runs it once more without the landmarks, under the same tests. The
/// detector may have found something else (a scan that ends at the nose, a poster, a mask), and this must not
/// prevent the alignment. If both fail, the first error is returned because it says more.
std::optional<Error> withoutLandmarksIfMisled(FaceInSpace& landmarks,
                                              const std::function<void()>& measureAndFit) {
  const auto first = errorOf(measureAndFit);
  if (!first || !landmarks.left) return first;
  landmarks = {};
  return errorOf(measureAndFit) ? first : std::nullopt;
}

}  // namespace

registration::SkinModel skinModel(const surface::ScalpSurface& scalp) {
  registration::SkinModel skin;
  skin.points.points_mm = scalp.mesh.vertices_mm;
  skin.points.normals = scalp.mesh.normals;
  skin.triangles = scalp.mesh.triangles;
  skin.field_of_view = scalp.field_of_view;
  skin.has_face = scalp.has_face;
  return skin;
}

casefile::StoredAlignment AlignmentOutcome::stored() const {
  casefile::StoredAlignment alignment;
  alignment.camera_T_mri = result.camera_T_mri;
  alignment.rms_mm = result.rms_mm;
  alignment.max_mm = result.max_mm;
  alignment.inlier_fraction = result.inlier_fraction;
  alignment.points = result.points;
  alignment.predicted_tre_mm = predicted_tre_mm;
  alignment.predicted_tre_p95_mm = predicted_tre_p95_mm;
  alignment.uncertainty = result.uncertainty();
  alignment.face_scale = result.face_scale;
  alignment.cautions = result.cautions;
  if (matcher != stereo::kDefaultMatcher) alignment.matcher = matcher;
  return alignment;
}

AlignmentOutcome alignFromCapture(const cameras::StereoRig& rig, const capture::CapturePair& capture,
                                  const surface::ScalpSurface& scalp, const registration::Aligner& aligner,
                                  const face::FaceDetector& detector,
                                  const std::vector<guidance::Target>& targets, TaskMonitor& monitor,
                                  const std::filesystem::path& field_file, const std::string& matcher) {
  stereo::makeDenseMatcher(matcher);  // refuses an unknown name before any work is done
  if (!scalp.has_face)
    throw Error("not aligned: this scan holds no face to align to", {},
                scalp.findings.empty() ? "use a scan of the whole head" : scalp.findings.front());
  monitor.report("finding the face", 0.0);
  // Read or compute the scalp's field while the face is found and measured.
  auto field = std::async(std::launch::async,
                          [&] { return registration::keptScalpField(skinModel(scalp), field_file); });
  AlignmentOutcome outcome;
  outcome.matcher = matcher;
  outcome.landmarks = findFace(rig, capture.plain, detector);
  const auto measureAndFit = [&] {
    const auto cloud =
        stereo::measureFace(rig, capture.pattern, measuringOptions(outcome.landmarks, rig, matcher), monitor);
    outcome.face = cutFace(cloud, outcome.landmarks);
    requireUnmovedCameras(rig, capture.pattern, capture.plain, outcome.face);
    if (!outcome.scalp) outcome.scalp = field.get();
    outcome.result =
        aligner.align(*outcome.scalp, outcome.face.cloud,
                      withSharedDepth(outcome.landmarks.start, rig, outcome.face.cloud), monitor);
  };
  if (const auto error = withoutLandmarksIfMisled(outcome.landmarks, measureAndFit))
    refuse(rig, capture, *error, matcher);
  if (const auto changed = changedSettingsFinding("aligned")) outcome.result.cautions.push_back(*changed);
  outcome.regions = registration::fitByRegion(*outcome.scalp, outcome.face.cloud, outcome.result);
  outcome.reference = makeReference(capture.plain, outcome.face, outcome.result);
  for (const auto& target : targets) {
    outcome.predicted_tre_mm[target.name] = outcome.result.predictedError_mm(target.cortex_point);
    outcome.predicted_tre_p95_mm[target.name] = outcome.result.errorBound_mm(target.cortex_point);
  }
  return outcome;
}

}  // namespace facenav::workflow
