#include "facenav/align/align_from_capture.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <future>
#include <utility>

#include "camera_doubts.h"
#include "facenav/align/known_lengths.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/health/rig_error.h"
#include "facenav/measured_face/dotted_face.h"
#include "facenav/measured_face/measured_face.h"
#include "facenav/measured_face/plain_skin.h"
#include "facenav/measured_face/projected_dots.h"
#include "facenav/measured_face/shared_depth.h"
#include "facenav/measured_face/skin_model.h"
#include "facenav/measured_face/unmoved_cameras.h"
#include "facenav/monitoring/drift_check.h"

namespace facenav::steps {
namespace {

Eigen::Vector3d middleOf(const PointCloud<Camera>& face) {
  Eigen::Vector3d middle_mm = Eigen::Vector3d::Zero();
  for (const auto& p : face.points_mm) middle_mm += p / double(face.size());
  return middle_mm;
}

/// Relative increase of a length there, per rad of the turn.
double sizeByTurn(const registration::TurnableCamera& right, const Eigen::Vector3d& at_mm) {
  return right.displacement(at_mm).norm() / at_mm.norm();
}

/// Turn of the right camera that corresponds to the cloud's standard deviation. If all points are off by it,
/// outwards from the middle, the face's size changes; a turn changes the face's distance and so its size.
double turnByDeviation_rad(const stereo::FaceCloud& face, const Eigen::Vector3d& middle_mm,
                           double baseline_mm) {
  double deviation_mm2 = 0, radius_mm2 = 0;
  for (std::size_t i = 0; i < face.cloud.size(); ++i)
    radius_mm2 += (face.cloud.points_mm[i] - middle_mm).squaredNorm() / double(face.cloud.size());
  for (const float sigma_mm : face.sigma_mm)
    deviation_mm2 += double(sigma_mm) * double(sigma_mm) / double(face.sigma_mm.size());
  return std::sqrt(deviation_mm2 / radius_mm2) * baseline_mm / middle_mm.norm();
}

/// Returns the right camera, turning across its view of the face and the baseline. Without dense dots,
/// neighbouring points share most of their deviation, so the fit's own error of the turn is too small and the
/// deviation is added. Evidence: resources/doc/evidence.md.
std::optional<registration::TurnableCamera> turnableRight(const cameras::StereoRig& rig,
                                                          const stereo::FaceCloud& face,
                                                          bool has_dense_dots) {
  if (face.cloud.empty()) return std::nullopt;
  const Eigen::Vector3d middle_mm = middleOf(face.cloud);
  const Eigen::Vector3d centre_mm = rig.right_T_left.isometry().inverse().translation();
  return registration::TurnableCamera{
      Point<Camera>(centre_mm), Direction<Camera>(middle_mm.cross(centre_mm).normalized()),
      has_dense_dots ? 0.0 : turnByDeviation_rad(face, middle_mm, centre_mm.norm())};
}

/// Prior of the face's pose for the fit.
registration::AlignmentStart startOf(const cameras::StereoRig& rig,
                                     const std::optional<health::ScaleObservation>& marker,
                                     const AlignmentOutcome& outcome) {
  registration::AlignmentStart start = outcome.landmarks.start;
  const measured_face::FaceError error = measured_face::faceErrorOf(rig, outcome.face);
  start.shared_depth_sigma_mm = error.whole_mm;
  start.sight = error.sight;
  start.noise_mm = error.point_mm;
  start.right = turnableRight(rig, outcome.face, outcome.has_dense_dots);
  if (marker && start.right) start.known_turn = turnBy(*marker, *start.right);
  return start;
}

/// Adds the errors of a face that cameras measured instead of a scan. The fit compares the live face with it;
/// only a turn measured by a marker lacks the stored face's own error of size.
void addErrorsOf(const surface::FaceMeasurement& model, const PointCloud<Camera>& face,
                 registration::AlignmentStart& start) {
  start.shared_depth_sigma_mm = std::hypot(start.shared_depth_sigma_mm, model.whole_mm);
  start.sight.sigma_mm = std::hypot(start.sight.sigma_mm, model.sight_mm);
  if (!start.known_turn || !start.right) return;
  double& sigma_rad = start.known_turn->sigma_rad;
  sigma_rad = std::hypot(sigma_rad, model.size.value_or(0.0) / sizeByTurn(*start.right, middleOf(face)));
}

head_tracking::HeadReference makeReference(const cameras::StereoFrame& plain, const stereo::FaceCloud& face,
                                           const registration::AlignmentResult& result) {
  head_tracking::HeadReference reference;
  reference.frame = plain;
  const bool has_pixels = face.left_px.size() == face.cloud.size();
  const bool has_flags = result.is_inlier.size() == face.cloud.size();
  const bool has_normals = face.cloud.normals.size() == face.cloud.size();
  for (std::size_t i = 0; has_pixels && i < face.cloud.size(); ++i) {
    // Skips hair and coil, which can move relative to the skull, or disappear.
    if (has_flags && !result.is_inlier[i]) continue;
    reference.surface.points_mm.push_back(face.cloud.points_mm[i]);
    if (has_normals) reference.surface.normals.push_back(face.cloud.normals[i]);
    reference.surface_left_px.push_back(face.left_px[i]);
  }
  return reference;
}

/// Runs `measureAndFit`; if it fails, runs it once more without the landmarks, under the same tests, because
/// the detector may have found something else (a scan that ends at the nose, a poster, a mask). If both fail,
/// returns the first error: the second may be about clothes or wallpaper, whatever it blames.
std::exception_ptr withoutLandmarksIfMisled(measured_face::FaceInSpace& landmarks,
                                            const std::function<void()>& measureAndFit) {
  const auto first = failureOf(measureAndFit);
  if (!first || !landmarks.left) return first;
  const auto found = std::exchange(landmarks, {});
  try {
    if (!failureOf(measureAndFit)) return nullptr;
  } catch (const health::RigError&) {
  }
  landmarks = found;
  return first;
}

using Field = std::shared_future<std::shared_ptr<const registration::ScalpField>>;

/// The scalp's field, read or computed while the face is found and measured.
Field fieldOf(const AlignmentSetup& setup) {
  if (!setup.scalp.has_face)
    throw Error("not aligned: this scan holds no face to align to", {},
                setup.scalp.findings.empty() ? "use a scan of the whole head" : setup.scalp.findings.front());
  return std::async(std::launch::async,
                    [skin = measured_face::skinModel(setup.scalp), file = setup.field_file] {
                      return registration::keptScalpField(skin, file);
                    });
}

/// Fits the face in `outcome` to the scalp. `measured`: the pictures that it was measured on.
void fit(const cameras::StereoRig& rig, const AlignmentSetup& setup, const Field& field,
         const cameras::StereoFrame& measured, const cameras::StereoFrame& plain, TaskMonitor& monitor,
         AlignmentOutcome& outcome) {
  measured_face::requireUnmovedCameras(rig, measured, plain, outcome.face, outcome.landmarks);
  outcome.scalp = field.get();
  std::optional<health::ScaleObservation> marker = setup.marker;
  outcome.is_marker_contradicted = false;
  if (!marker && setup.coil_tracker) {
    const auto seen = markerInPair(rig, plain, setup.coil, *setup.coil_tracker);
    marker = seen.length;
    outcome.is_marker_contradicted = seen.is_contradicted;
  }
  const auto& model = setup.scalp.measurement;
  if (isSizeUnknown(setup.scalp)) marker.reset();  // the marker measures the cameras now, not at the visit
  outcome.is_marker_seen = marker.has_value();
  auto start = startOf(rig, marker, outcome);
  if (model) addErrorsOf(*model, outcome.face.cloud, start);
  start.is_patient_confirmed = setup.is_patient_confirmed;
  outcome.result = setup.aligner.align(*outcome.scalp, outcome.face.cloud, start, monitor);
}

/// Describes the possible error of a turned camera, and what to do, if nothing excludes a turn.
std::optional<std::string> unmeasuredTurn(const AlignmentSetup& setup, const AlignmentOutcome& outcome) {
  constexpr double kSaid_mm = 2.0, kBound = 1.96;
  double most_mm = 0;
  for (const auto& target : setup.targets)
    most_mm = std::max(
        most_mm,
        kBound * outcome.result.coilByTurn_mm(target.cortex_point, markerAt(target, setup.coil)).norm());
  if (outcome.is_marker_seen || !outcome.result.right_turn || most_mm < kSaid_mm) return std::nullopt;
  const std::string cost = formatted(
      "nothing excludes that a camera turned sideways since the calibration: then the coil lies up to %.1f "
      "mm "
      "from where it is shown",
      most_mm);
  if (outcome.is_marker_contradicted) return cost + "; " + kMarkerContradicted + ", and align again";
  if (isSizeUnknown(setup.scalp)) return cost + "; " + kSizeUnknown;
  return cost +
         ". Hold the coil still beside the face, its marker to both cameras, while the picture without dots "
         "is "
         "taken, and align again";
}

/// Says that the cameras' rows disagree by far more than their calibration's residuals. A turn up or down
/// causes that. It hardly moves the face, but a sideways turn may come with it; that one is in the bound.
std::optional<std::string> disagreeingRows(const cameras::StereoRig& rig, const AlignmentOutcome& outcome) {
  constexpr double kResiduals = 3.0;
  const auto rows_px = outcome.face.epipolar_median_px;
  if (!rows_px || !rig.rms_px || std::abs(*rows_px) < kResiduals * *rig.rms_px) return std::nullopt;
  return formatted(
      "the images disagree with the calibration by %.1f px across the rows: the cameras may have moved "
      "since; check them with the board, or calibrate again",
      std::abs(*rows_px));
}

/// Sets the results that follow from an accepted fit.
void conclude(const cameras::StereoRig& rig, const AlignmentSetup& setup, const cameras::StereoFrame& plain,
              AlignmentOutcome& outcome) {
  if (const auto words = disagreeingRows(rig, outcome)) outcome.result.cautions.push_back(*words);
  if (const auto changed = changedSettingsFinding("aligned")) outcome.result.cautions.push_back(*changed);
  if (const auto words = unmeasuredTurn(setup, outcome)) outcome.result.cautions.push_back(*words);
  outcome.regions = registration::fitByRegion(*outcome.scalp, outcome.face.cloud, outcome.result);
  outcome.reference = makeReference(plain, outcome.face, outcome.result);
  outcome.skin = std::make_shared<const surface::ScalpSurface>(setup.scalp);
  outcome.coil = setup.coil;
  for (const auto& target : setup.targets) {
    // The coil rests on the MRI's skin, so an uncertain skin makes the coil's position uncertain.
    constexpr double kUnsure_mm = 0.5;
    const double skin_mm = surface::skinDoubtUnder_mm(setup.scalp, target.scalp_point);
    outcome.predicted_tre_mm[target.name] = outcome.predictedError_mm(target);
    outcome.predicted_tre_p95_mm[target.name] = outcome.errorBound_mm(target);
    if (skin_mm > kUnsure_mm)
      outcome.result.cautions.push_back(formatted(
          "the skin at %s is unsure by %.1f mm (pads or haze in the scan): check the coil's gap there",
          target.name.c_str(), skin_mm));
  }
}

/// Throws HeadMoved unless the head is at one place in the picture with dots, which was aligned, and in the
/// plain one, from which the tracker starts.
void requireStillHead(const cameras::StereoRig& rig, const AlignmentOutcome& outcome) {
  const monitoring::DriftCheck check(rig, outcome.scalp, outcome.reference, outcome.result.camera_T_mri);
  const auto& found = check.atReference();
  if (found.verdict != monitoring::DriftFinding::Verdict::drifted) return;
  throw HeadMoved(
      formatted("not aligned: the head moved by %.1f mm and %.1f deg between the picture with dots and "
                "the one without",
                found.shift_mm, found.turn_deg),
      {}, "hold the head still and take both pictures again");
}

}  // namespace

std::vector<Point<Mri>> markerAt(const guidance::Target& target, const coil_tracking::CoilModel& coil) {
  const auto& marker = coil.markers.front();
  const double half_mm = 0.5 * marker.size_mm;
  std::vector<Point<Mri>> corners;
  for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    const Point<Coil> at = marker.coil_T_marker * Point<Marker>(x * half_mm, y * half_mm, 0.0);
    corners.emplace_back(target.mri_T_target * Point<frames::Target>(at.mm));
  }
  return corners;
}

double AlignmentOutcome::predictedError_mm(const guidance::Target& target) const {
  const double skin_mm = skin ? surface::skinDoubtUnder_mm(*skin, target.scalp_point) : 0.0;
  return std::hypot(result.predictedError_mm(target.cortex_point), skin_mm);
}

double AlignmentOutcome::errorBound_mm(const guidance::Target& target) const {
  constexpr double kBound = 1.96;  // standard errors of the skin
  const double skin_mm = skin ? surface::skinDoubtUnder_mm(*skin, target.scalp_point) : 0.0;
  return std::hypot(result.coilErrorBound_mm(target.cortex_point, markerAt(target, coil)), kBound * skin_mm);
}

std::optional<double> AlignmentOutcome::faceSizeError() const {
  if (!result.right || !result.right_turn || face.cloud.empty()) return std::nullopt;
  return std::hypot(result.right_turn->rad, result.right_turn->sigma_rad) *
         sizeByTurn(*result.right, middleOf(face.cloud));
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
  alignment.face_size_error = faceSizeError();
  alignment.cautions = result.cautions;
  alignment.rests_on_confirmation = result.rests_on_confirmation;
  alignment.from = measured_face::nameOf(from);
  if (from == measured_face::AlignedFrom::dots && matcher != stereo::kDefaultMatcher)
    alignment.matcher = matcher;
  return alignment;
}

AlignmentOutcome alignFromCapture(const cameras::StereoRig& rig, const capture::CapturePair& capture,
                                  measured_face::AlignedFrom from, const AlignmentSetup& setup,
                                  TaskMonitor& monitor) {
  stereo::makeDenseMatcher(setup.matcher);  // refuses an unknown name before any work is done
  for (const auto* frame : {&capture.pattern, &capture.plain})
    if (!frame->rig_fault.empty()) throw Error("not aligned: " + frame->rig_fault);
  const Field field = fieldOf(setup);
  AlignmentOutcome outcome;
  outcome.matcher = setup.matcher;
  monitor.report("finding the face", 0.0);
  outcome.landmarks = measured_face::findFace(rig, capture.plain, setup.detector);
  outcome.from = from;
  const bool has_dots = from == measured_face::AlignedFrom::dots;
  const auto face_box = outcome.landmarks.left ? std::optional(outcome.landmarks.left->face) : std::nullopt;
  const bool is_on_face = face_box && measured_face::showsDots(capture, face_box);
  const auto seen_in = is_on_face ? face_box : std::nullopt;
  outcome.has_dense_dots = has_dots && measured_face::showsDots(capture, seen_in) &&
                           !measured_face::areDotsSparse(capture, seen_in);
  const cameras::StereoFrame& measured = has_dots ? capture.pattern : capture.plain;
  bool is_measured = false;
  const auto measureAndFit = [&] {
    outcome.face =
        has_dots ? measured_face::measureDotted(rig, measured, outcome.landmarks, setup.matcher, monitor)
                 : measured_face::measurePlainSkin(rig, measured, outcome.landmarks, monitor);
    is_measured = true;
    fit(rig, setup, field, measured, capture.plain, monitor, outcome);
  };
  if (const auto failure = withoutLandmarksIfMisled(outcome.landmarks, measureAndFit))
    refuseAlignment(rig, capture, from, failure, is_measured && face_box, setup.matcher,
                    outcome.landmarks.left);
  conclude(rig, setup, capture.plain, outcome);
  if (has_dots) requireStillHead(rig, outcome);
  return outcome;
}

AlignmentOutcome alignFromFilm(capture::FrameSource& film, std::int64_t first, std::int64_t last,
                               head_tracking::HeadTracker& tracker, const AlignmentSetup& setup,
                               TaskMonitor& monitor) {
  const Field field = fieldOf(setup);
  measured_face::MeasuredFace measured;
  if (const auto failure = failureOf([&] {
        measured = measured_face::measureFilm(film, first, last,
                                              head_tracking::motionSinceFirst(tracker, film.rig()),
                                              setup.detector, monitor, measured_face::kFramesToAlign);
      }))
    throw NotMeasured(wordsOf(failure));
  AlignmentOutcome outcome;
  outcome.from = measured_face::AlignedFrom::film;
  outcome.landmarks = measured.landmarks;
  outcome.face = std::move(measured.cloud.face);
  outcome.fused_frames = measured.fused;
  const cameras::StereoFrame& plain = *measured.first;
  if (const auto failure = failureOf([&] { fit(film.rig(), setup, field, plain, plain, monitor, outcome); }))
    refuseAlignment(film.rig(), {plain, plain}, outcome.from, failure, outcome.landmarks.centre.has_value(),
                    outcome.matcher, outcome.landmarks.left);
  conclude(film.rig(), setup, plain, outcome);
  return outcome;
}

}  // namespace facenav::steps
