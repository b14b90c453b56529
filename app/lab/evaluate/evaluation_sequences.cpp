#include <nlohmann/json.hpp>

#include "evaluate/evaluation_run.h"
#include "facenav/core/whole_file.h"
#include "facenav/geometry/json_transform.h"
#include "facenav/room/synthetic_source.h"

namespace facenav::app {
namespace fs = std::filesystem;
namespace {

evaluation::FrameTruth truthOf(const room::GroundTruth& truth) {
  evaluation::FrameTruth frame;
  frame.label = truth.label;
  if (truth.is_patient_there) frame.head = truth.camera_T_mri.isometry();
  if (truth.camera_T_marker) frame.marker = truth.camera_T_marker->isometry();
  frame.must_be_lost = truth.must_be_lost;
  frame.face_visible_fraction = truth.face_visible_fraction;
  frame.camera_turn_deg = kDegPerRad * truth.right_moved.head<3>().norm();
  frame.camera_shift_mm = truth.right_moved.tail<3>().norm();
  return frame;
}

/// Reads the labels of frames in scenario.json. A recording without them has only normal frames.
std::map<std::int64_t, evaluation::FrameTruth> labelsOf(const nlohmann::json& scenario) {
  std::map<std::int64_t, evaluation::FrameTruth> labels;
  for (const auto& frame : scenario.value("frames", nlohmann::json::array())) {
    evaluation::FrameTruth& truth = labels[frame.at("frame").get<std::int64_t>()];
    truth.label = frame.value("label", "");
    truth.must_be_lost = frame.value("must_be_lost", false);
    truth.face_visible_fraction = frame.value("face_visible_fraction", 1.0);
  }
  return labels;
}

}  // namespace

coil_tracking::CoilModel coilOf(const room::RoomCoil& coil) {
  coil_tracking::CoilModel model;
  model.name = coil.name;
  coil_tracking::MarkerModel marker;
  marker.dictionary = coil.dictionary;
  marker.id = coil.marker_id;
  marker.size_mm = coil.marker_size_mm;
  marker.coil_T_marker = coil.marker_T_coil.inverse();
  model.markers.push_back(marker);
  return model;
}

EvaluationSequence roomSequence(const room::ScenarioOptions& options, const EvaluationHead& head) {
  const auto room = std::make_shared<room::SyntheticSource>(options, head.patient, head.target.mri_T_target);
  EvaluationSequence sequence;
  sequence.scenario = options.name;
  sequence.capture = room->capturePair();
  sequence.capture_truth = room->captureTruth();
  const room::DepthMaps depth = room->depth();  // the room still renders the capture at this point
  sequence.capture_depth = evaluation::ExactDepth{depth.left_mm, depth.right_mm, depth.left_object == 1};
  sequence.face_middle = head.patient->face_middle;
  sequence.source = room;
  sequence.truth = [room](std::int64_t) { return truthOf(room->truth()); };
  sequence.coil = coilOf(room->coil());
  sequence.frames_per_s = room::resolved(options).frames_per_s;
  return sequence;
}

EvaluationSequence recordedSequence(const fs::path& folder) {
  const auto recording = capture::openRecording(folder);
  if (!recording.capture)
    throw Error("has no capture/ pair to align from", folder.string(),
                "an evaluation starts with an alignment");
  if (!fs::exists(folder / "truth/head.csv"))
    throw Error("holds no truth to measure against", (folder / "truth/head.csv").string(),
                "simulate a recording, or bring one with truth/");
  EvaluationSequence sequence;
  sequence.source = capture::makeSource(recording);
  sequence.capture = recording.capture;
  sequence.frames_per_s = recording.frames_per_s;
  const auto head = capture::readTruth(folder / "truth/head.csv");
  std::map<std::int64_t, Eigen::Isometry3d> marker;
  if (fs::exists(folder / "truth/coil.csv")) marker = capture::readTruth(folder / "truth/coil.csv");
  sequence.coil = fs::exists(folder / "coil.json") ? coil_tracking::readCoil(folder / "coil.json")
                                                   : coil_tracking::defaultCoil();
  nlohmann::json scenario = nlohmann::json::object();
  if (fs::exists(folder / "scenario.json"))
    scenario = nlohmann::json::parse(readWholeFile(folder / "scenario.json"));
  sequence.scenario = scenario.value("scenario", fs::weakly_canonical(folder).filename().string());
  if (scenario.contains("capture_camera_T_mri")) {
    const auto values = scenario["capture_camera_T_mri"].get<std::vector<double>>();
    sequence.capture_truth = RigidTransform<Camera, Mri>::fromMatrix(
        Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(values.data()));
  } else if (!head.empty()) {  // assumption: the head's pose in the first frame is that of the capture
    sequence.capture_truth = RigidTransform<Camera, Mri>::fromIsometry(head.begin()->second);
  } else {
    throw Error("holds no pose of the head", (folder / "truth/head.csv").string(),
                "one line a frame was expected");
  }
  sequence.truth = [head, marker, labels = labelsOf(scenario)](std::int64_t frame) {
    const auto label = labels.find(frame);
    evaluation::FrameTruth truth = label == labels.end() ? evaluation::FrameTruth{} : label->second;
    if (const auto found = head.find(frame); found != head.end()) truth.head = found->second;
    if (const auto found = marker.find(frame); found != marker.end()) truth.marker = found->second;
    return truth;
  };
  return sequence;
}

}  // namespace facenav::app
