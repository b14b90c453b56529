#include "facenav/align/face_model.h"

#include <cmath>

#include "camera_doubts.h"
#include "facenav/align/known_lengths.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/measured_face/dotted_face.h"
#include "facenav/measured_face/face_surface.h"
#include "facenav/measured_face/measured_face.h"
#include "facenav/measured_face/plain_skin.h"
#include "facenav/measured_face/projected_dots.h"
#include "facenav/measured_face/unmoved_cameras.h"

namespace facenav::steps {
namespace fs = std::filesystem;
namespace {

const Eigen::Vector3d kFacesNose_mm(0, 95, -30);
constexpr const char* kKeptFace = "face.vtp";  // in alignment_capture/
// Largest relative error of size. It moves the coil by that share of its distance from the face, some 150 mm;
// twice this error moves it by 3 mm, a wrong pose.
constexpr double kMostSizeError = 0.01;
constexpr double kTurned = 3.0;  // standard errors of a length that is certainly wrong, as in the alignment

/// Returns the face's own axes, from its landmarks.
RigidTransform<Camera, Mri> facesOwnFrame(const measured_face::FaceInSpace& face) {
  const auto& start = face.start;
  if (!start.patient_right || !start.patient_superior || !start.nose_tip)
    throw Error("no face was found in both pictures", {},
                "look at the cameras, the whole face lit and in view of both");
  const Eigen::Vector3d x = start.patient_right->v.normalized();
  const Eigen::Vector3d up = start.patient_superior->v;
  const Eigen::Vector3d z = (up - up.dot(x) * x).normalized();
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() << x, z.cross(x), z;
  pose.translation() = start.nose_tip->mm - pose.linear() * kFacesNose_mm;
  return RigidTransform<Camera, Mri>::fromIsometry(pose);
}

/// Relative error of the size of a face elsewhere in the view, from the marker's length: a turn of the right
/// camera changes a length by a share that grows with its distance.
double sizeErrorBy(const health::ScaleObservation& marker, const Eigen::Vector3d& face_mm) {
  const double off = marker.ratio - 1.0;
  if (std::abs(off) > kTurned * marker.sigma)
    throw Error(
        formatted("the coil's marker measures %.1f +/- %.1f %% of its printed size: a camera has turned "
                  "sideways since the calibration, or the print has another size",
                  100 * marker.ratio, 100 * marker.sigma),
        {}, "check the cameras ('facenav rig check') and the size of the print");
  return std::hypot(off, marker.sigma) * face_mm.norm() / marker.at.mm.norm();
}

Eigen::Vector3d middleOfFace(const stereo::FaceCloud& face) {
  Eigen::Vector3d middle_mm = Eigen::Vector3d::Zero();
  for (const auto& p : face.cloud.points_mm) middle_mm += p / double(face.cloud.size());
  return middle_mm;
}

void requireKnownSize(const surface::FaceMeasurement& face, measured_face::AlignedFrom from) {
  if (from == measured_face::AlignedFrom::dots || face.size.value_or(1.0) <= kMostSizeError) return;
  const std::string what =
      face.size
          ? formatted("the face may have been measured by %.0f %% too large or too small: ", 200 * *face.size)
          : std::string("the face may have been measured too large or too small: ");
  throw Error(
      what + "nothing showed well enough whether a camera had turned sideways since the calibration", {},
      "hold the coil still beside the face, its marker to both cameras, and take the pictures again (or "
      "use a projector's dots)");
}

FaceModel modelOf(const cameras::StereoRig& rig, const stereo::FaceCloud& face,
                  const measured_face::FaceInSpace& landmarks, measured_face::AlignedFrom from,
                  const FaceModelSetup& setup) {
  FaceModel model;
  model.from = from;
  model.camera_T_mri = setup.camera_T_mri ? *setup.camera_T_mri : facesOwnFrame(landmarks);
  model.skin = measured_face::faceSurface(rig, face, model.camera_T_mri.inverse(), setup.scalp);
  model.skin.measurement->size = setup.size_error;
  if (setup.marker) model.skin.measurement->size = sizeErrorBy(*setup.marker, middleOfFace(face));
  requireKnownSize(*model.skin.measurement, from);
  measured_face::requireWholeFace(model.skin.mesh);
  return model;
}

void requireDots(const capture::CapturePair& capture) {
  if (measured_face::showsDots(capture)) return;
  throw Error("the capture's picture for the dots shows none", {},
              "switch the projector on and take the pictures again");
}

}  // namespace

FaceModel measureFaceModel(const cameras::StereoRig& rig, const capture::CapturePair& capture,
                           measured_face::AlignedFrom from, const FaceModelSetup& setup,
                           TaskMonitor& monitor) {
  const bool has_dots = from == measured_face::AlignedFrom::dots;
  if (has_dots) requireDots(capture);
  monitor.report("finding the face", 0.0);
  const auto landmarks = measured_face::findFace(rig, capture.plain, setup.detector);
  const auto face =
      has_dots ? measured_face::measureDotted(rig, capture.pattern, landmarks, setup.matcher, monitor)
               : measured_face::measurePlainSkin(rig, capture.plain, landmarks, monitor);
  measured_face::requireUnmovedCameras(rig, has_dots ? capture.pattern : capture.plain, capture.plain, face,
                                       landmarks);
  return modelOf(rig, face, landmarks, from, setup);
}

FaceModel measureFaceModel(capture::FrameSource& film, std::int64_t first, std::int64_t last,
                           head_tracking::HeadTracker& tracker, const FaceModelSetup& setup,
                           TaskMonitor& monitor) {
  const auto seen =
      measured_face::measureFilm(film, first, last, head_tracking::motionSinceFirst(tracker, film.rig()),
                                 setup.detector, monitor, measured_face::kFramesToAlign);
  measured_face::requireUnmovedCameras(film.rig(), *seen.first, *seen.first, seen.cloud.face, seen.landmarks);
  return modelOf(film.rig(), seen.cloud.face, seen.landmarks, measured_face::AlignedFrom::film, setup);
}

void keepFace(const cameras::StereoRig& rig, const AlignmentOutcome& outcome, const fs::path& case_folder) {
  auto skin = measured_face::faceSurface(rig, outcome.face, outcome.result.camera_T_mri.inverse(),
                                         outcome.scalp.get());
  if (skin.mesh.triangles.empty()) return;
  skin.measurement->size = outcome.faceSizeError();
  surface::writeScalp(skin, case_folder / "alignment_capture" / kKeptFace);
}

FaceModel keptFace(const casefile::StoredAlignment& alignment, const fs::path& case_folder) {
  const fs::path file = case_folder / "alignment_capture" / kKeptFace;
  if (!fs::exists(file))
    throw Error("the face of the last alignment was not kept", case_folder.string(), "align the case again");
  FaceModel model;
  model.skin = surface::readScalp(file);
  model.camera_T_mri = alignment.camera_T_mri;
  model.from =
      measured_face::alignedFrom(alignment.from.value_or("")).value_or(measured_face::AlignedFrom::plain);
  requireKnownSize(model.skin.measurement.value_or(surface::FaceMeasurement{}), model.from);
  measured_face::requireWholeFace(model.skin.mesh);
  return model;
}

std::string faceFinding(const FaceModel& model) {
  const auto face = model.skin.measurement.value_or(surface::FaceMeasurement{});
  const char* how = model.from == measured_face::AlignedFrom::dots    ? ""
                    : model.from == measured_face::AlignedFrom::plain ? ", without a projector,"
                                                                      : ", in a film,";
  const std::string size = face.size ? formatted(", its size to %.1f %%", 100 * *face.size)
                                     : std::string(", its size not compared with a marker");
  return formatted("no MRI: the face measured%s in %d points (%.2f mm each, %.2f mm as a whole", how,
                   face.points, face.point_mm, face.whole_mm) +
         size + ") stands in for it; places and errors are relative to that visit";
}

}  // namespace facenav::steps
