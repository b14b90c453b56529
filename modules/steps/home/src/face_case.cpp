// Makes a case without an MRI from the best face in a recording.

#include "facenav/align/face_model.h"
#include "facenav/align/film_beginning.h"
#include "facenav/casefile/sha256.h"
#include "facenav/core/error.h"
#include "facenav/core/software_version.h"
#include "facenav/measured_face/projected_dots.h"

namespace facenav::steps {
namespace fs = std::filesystem;
namespace {

struct FaceRecording {
  const capture::Recording& recording;
  const Registrations& methods;
  FaceModelSetup setup;
};

FaceModel measureFrom(measured_face::AlignedFrom from, const FaceRecording& of, TaskMonitor& monitor) {
  if (from != measured_face::AlignedFrom::film)
    return measureFaceModel(of.recording.rig, *of.recording.capture, from, of.setup, monitor);
  const auto& trackers = of.methods.head_trackers;
  const auto tracker = trackers.create(trackers.defaultName());
  const auto film = capture::makeSource(of.recording);
  const auto [first, last] = beginningOf(of.recording, &of.setup.detector);
  return measureFaceModel(*film, first, last, *tracker, of.setup, monitor);
}

/// Lists the ways for which the recording has pictures, the best first.
std::vector<measured_face::AlignedFrom> waysToMeasure(const capture::Recording& recording,
                                                      const std::optional<measured_face::AlignedFrom>& only) {
  std::vector<measured_face::AlignedFrom> ways;
  if (recording.capture &&
      (only == measured_face::AlignedFrom::dots || measured_face::showsDots(*recording.capture)))
    ways.push_back(measured_face::AlignedFrom::dots);
  if (recording.frame_count > 1) ways.push_back(measured_face::AlignedFrom::film);
  if (recording.capture) ways.push_back(measured_face::AlignedFrom::plain);
  if (!only) return ways;
  for (const measured_face::AlignedFrom way : ways)
    if (way == *only) return {way};
  throw Error("the recording has no " +
                  std::string(only == measured_face::AlignedFrom::film ? "film" : "capture/ pair"),
              recording.folder.string(), "choose another way (dots, plain, film), or record one");
}

/// Finds the coil's marker: at rest in the film, else in the plain pair.
std::optional<health::ScaleObservation> markerOf(const capture::Recording& recording,
                                                 const Registrations& methods,
                                                 const coil_tracking::CoilModel& coil) {
  if (methods.coil_trackers.entries().empty()) return std::nullopt;
  const auto tracker = methods.coil_trackers.create(methods.coil_trackers.defaultName());
  if (const auto length = restingMarkerIn(recording, coil, *tracker)) return length;
  if (!recording.capture) return std::nullopt;
  const auto seen = markerInPair(recording.rig, recording.capture->plain, coil, *tracker);
  if (seen.is_contradicted) throw Error(kMarkerContradicted, recording.folder.string());
  return seen.length;
}

/// Returns the face with dots if it is valid; else the one with the smaller error.
FaceModel bestFace(const FaceRecording& of, const std::optional<measured_face::AlignedFrom>& only,
                   TaskMonitor& monitor) {
  std::optional<FaceModel> best;
  std::optional<Error> refusal;
  for (const measured_face::AlignedFrom from : waysToMeasure(of.recording, only)) {
    if (best && best->from == measured_face::AlignedFrom::dots) break;
    try {
      auto model = measureFrom(from, of, monitor);
      if (!best || model.skin.measurement->point_mm < best->skin.measurement->point_mm)
        best = std::move(model);
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& error) {
      if (from == measured_face::AlignedFrom::dots)
        throw;  // moved cameras: no other pictures may be used instead
      if (!refusal) refusal = error;
    }
  }
  if (best) return std::move(*best);
  if (refusal) throw Error(*refusal);
  throw Error("the recording has no pictures of the face", of.recording.folder.string(),
              "record a still pair (facenav record --capture) or a film of the face");
}

}  // namespace

casefile::CaseStore makeFaceCase(const Registrations& methods, const FaceCaseOrder& order,
                                 TaskMonitor& monitor) {
  const auto recording = capture::openCapture(order.recording);
  const auto detector = methods.face_detector();
  FaceRecording of{recording, methods, {*detector}};
  of.setup.marker = markerOf(recording, methods, order.coil ? *order.coil : coilNamedIn({order.recording}));
  const auto model = bestFace(of, order.from, monitor);
  const casefile::Provenance made{
      "face-case",
      softwareVersion(),
      {{"from", measured_face::nameOf(model.from)}},
      {{"recording",
        casefile::sha256OfInput(order.recording /
                                (model.from == measured_face::AlignedFrom::film ? "left" : "capture"))}}};
  return casefile::CaseStore::createFromFace(
      order.case_folder, {model.skin, {faceFinding(model)}, order.label}, {made}, order.replaces);
}

}  // namespace facenav::steps
