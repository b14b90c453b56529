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

/// The face's box grown to hold forehead, chin and temples; nothing where no face was found.
std::optional<cv::Rect> region(const FaceInSpace& face, const stereo::StereoRig& rig) {
  if (!face.left) return std::nullopt;
  const cv::Rect& box = face.left->face;
  const int grow_x = box.width / 2, grow_y = int(0.6 * box.height);
  const cv::Rect grown(box.x - grow_x, box.y - grow_y, box.width + 2 * grow_x, box.height + 2 * grow_y);
  const cv::Rect inside = grown & cv::Rect(0, 0, rig.width_px, rig.height_px);
  if (inside.area() <= 0) return std::nullopt;
  return inside;
}

stereo::FaceCloudOptions measuringOptions(const FaceInSpace& face, const stereo::StereoRig& rig) {
  stereo::FaceCloudOptions options;
  options.left_roi = region(face, rig);
  if (face.centre) {
    options.nearest_mm = std::max(100.0, face.centre->mm.z() - 180.0);
    options.farthest_mm = face.centre->mm.z() + 220.0;
  }
  return options;
}

constexpr double kClearStatistic = 40;  // as in RigCheck: twice the monitor's own threshold
constexpr int kFineScale_px = 9;
constexpr double kDotsContrast = 1.5;  // of fine detail with dots to that without; skin alone: 1

/// Fine detail by the mean grey level.
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

/// The calibration does not hold any more: looking elsewhere for the face would not help.
class CamerasMoved : public Error {
 public:
  using Error::Error;
};

/// The error that `task` ends with, where another way of doing it may help; what no other way mends is thrown
/// on: cameras at fault, and the user's stop.
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

/// Throws CamerasMoved where points of the face, matched anew, say so.
void requireUnmovedCameras(const stereo::StereoRig& rig, const stereo::StereoFrame& frame,
                           const stereo::StereoFrame& plain, const stereo::FaceCloud& face) {
  stereo::RigMonitor monitor(rig);
  monitor.add(monitoring::matchSurface(rig, frame, face.cloud, face.left_px));
  const auto verdict = monitor.verdict();
  if (!verdict.hasMoved()) return;
  const auto diagnosis = stereo::diagnosePair(rig, plain);
  if (diagnosis.isFault()) throw monitoring::PairError(diagnosis, "not aligned: ");
  // Plain skin that disagrees a little, where the whole plain pair fits, is no moved camera.
  const bool is_clear = verdict.statistic > kClearStatistic && showsDots({frame, plain});
  if (diagnosis.fault != stereo::PairFault::none || is_clear)
    throw CamerasMoved("not aligned: " + verdict.words(), {}, "'facenav calibrate'");
}

/// The aligner and the measurement see only that nothing fits. The cameras are asked first, then the dots;
/// what is left is the face.
[[noreturn]] void refuse(const stereo::StereoRig& rig, const capture::CapturePair& capture,
                         const Error& error) {
  const auto diagnosis = stereo::diagnosePair(rig, capture.plain);
  if (diagnosis.isFault()) throw monitoring::PairError(diagnosis, "not aligned: ");
  if (showsDots(capture)) throw error;
  std::string reason = error.what();
  const std::string prefix = "not aligned: ";
  if (reason.rfind(prefix, 0) == 0) reason.erase(0, prefix.size());
  throw Error(
      prefix +
      "the capture's picture for the dots shows none (switch the projector on); without them: " + reason);
}

registration::AlignmentStart withSharedDepth(registration::AlignmentStart start, const stereo::StereoRig& rig,
                                             const PointCloud<Camera>& face) {
  start.shared_depth_sigma_mm = sharedDepthSigma_mm(rig, face);
  return start;
}

tracking::HeadReference makeReference(const stereo::StereoFrame& plain, const stereo::FaceCloud& face,
                                      const registration::AlignmentResult& result) {
  tracking::HeadReference reference;
  reference.frame = plain;
  const bool has_pixels = face.left_px.size() == face.cloud.size();
  const bool has_flags = result.is_inlier.size() == face.cloud.size();
  const bool has_normals = face.cloud.normals.size() == face.cloud.size();
  for (std::size_t i = 0; has_pixels && i < face.cloud.size(); ++i) {
    if (has_flags && !result.is_inlier[i]) continue;  // hair and coil move apart from the skull, or away
    reference.surface.points_mm.push_back(face.cloud.points_mm[i]);
    if (has_normals) reference.surface.normals.push_back(face.cloud.normals[i]);
    reference.surface_left_px.push_back(face.left_px[i]);
  }
  return reference;
}

/// A detector that takes something else for the face (a scan that ends at the nose, a poster, a mask) must
/// not cost the alignment: what fails with its landmarks is tried once more without them, under the same
/// tests. If that fails too, the first reason is the better one to give: it is returned.
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
  alignment.face_scale_sigma = result.face_scale_sigma;
  alignment.cautions = result.cautions;
  return alignment;
}

AlignmentOutcome alignFromCapture(const stereo::StereoRig& rig, const capture::CapturePair& capture,
                                  const surface::ScalpSurface& scalp, const registration::Aligner& aligner,
                                  const tracking::FaceDetector& detector,
                                  const std::vector<guidance::Target>& targets, TaskMonitor& monitor,
                                  const std::filesystem::path& field_file) {
  if (!scalp.has_face)
    throw Error("not aligned: this scan holds no face to align to", {},
                scalp.findings.empty() ? "use a scan of the whole head" : scalp.findings.front());
  monitor.report("finding the face", 0.0);
  // The field of the scalp is read, or built, while the face is found and measured.
  auto field = std::async(std::launch::async,
                          [&] { return registration::keptScalpField(skinModel(scalp), field_file); });
  AlignmentOutcome outcome;
  outcome.landmarks = findFace(rig, capture.plain, detector);
  const auto measureAndFit = [&] {
    const auto cloud =
        stereo::measureFace(rig, capture.pattern, measuringOptions(outcome.landmarks, rig), monitor);
    outcome.face = cutFace(cloud, outcome.landmarks);
    requireUnmovedCameras(rig, capture.pattern, capture.plain, outcome.face);
    if (!outcome.scalp) outcome.scalp = field.get();
    outcome.result =
        aligner.align(*outcome.scalp, outcome.face.cloud,
                      withSharedDepth(outcome.landmarks.start, rig, outcome.face.cloud), monitor);
  };
  if (const auto error = withoutLandmarksIfMisled(outcome.landmarks, measureAndFit))
    refuse(rig, capture, *error);
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
