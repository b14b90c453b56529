#include "facenav/room/simulate.h"

#include <nlohmann/json.hpp>

#include "facenav/cameras/projector_model.h"
#include "facenav/capture/recording.h"
#include "facenav/core/whole_file.h"
#include "facenav/room/synthetic_source.h"

namespace facenav::room {
namespace {

using nlohmann::json;

json rows(const Eigen::Matrix4d& matrix) {
  json numbers = json::array();
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) numbers.push_back(matrix(row, column));
  return numbers;
}

json coilJson(const RoomCoil& coil) {
  return {
      {"name", coil.name},
      {"marker", {{"dictionary", coil.dictionary}, {"id", coil.marker_id}, {"size_mm", coil.marker_size_mm}}},
      {"marker_T_coil", rows(coil.marker_T_coil.matrix())}};
}

json frameJson(const GroundTruth& truth) {
  json frame{{"frame", truth.frame},
             {"label", truth.label},
             {"face_visible_fraction", truth.face_visible_fraction},
             {"is_patient_there", truth.is_patient_there},
             {"must_be_lost", truth.must_be_lost},
             {"is_out_of_step", truth.is_out_of_step},
             {"jaw_mm", truth.jaw_mm}};
  const auto numbers = [](const Eigen::Vector3d& v) { return json{v.x(), v.y(), v.z()}; };
  if (truth.right_moved.isZero()) return frame;
  frame["right_turn_deg"] = numbers(kDegPerRad * truth.right_moved.head<3>());
  frame["right_shift_mm"] = numbers(truth.right_moved.tail<3>());
  return frame;
}

struct JsonVisitor {
  json& object;
  template <class Value>
  void operator()(const Field& field, const Value& value) {
    object[field.name] = value;
  }
};

void addTruth(capture::RecordingWriter& writer, const GroundTruth& truth) {
  std::optional<Eigen::Isometry3d> camera_T_marker;
  if (truth.camera_T_marker) camera_T_marker = truth.camera_T_marker->isometry();
  std::optional<Eigen::Isometry3d> camera_T_mri;
  if (truth.is_patient_there) camera_T_mri = truth.camera_T_mri.isometry();
  std::optional<Eigen::Isometry3d> camera_T_second;
  if (truth.camera_T_second_marker) camera_T_second = truth.camera_T_second_marker->isometry();
  writer.addTruth(truth.frame, camera_T_mri, camera_T_marker, camera_T_second);
}

}  // namespace

void simulate(const ScenarioOptions& options, std::shared_ptr<const VirtualPatient> patient,
              const std::optional<RigidTransform<Mri, frames::Target>>& target,
              const std::filesystem::path& recording, TaskMonitor& monitor) {
  SyntheticSource source(options, std::move(patient), target);
  capture::RecordingWriter writer(recording, source.rig());
  const std::string step = "virtual room: " + options.name;
  monitor.report(step, 0.0);
  writer.setCapture(source.capturePair());
  json frames = json::array();
  while (const auto frame = source.next()) {
    writer.add(*frame);
    addTruth(writer, source.truth());
    frames.push_back(frameJson(source.truth()));
    monitor.report(step, double(frame->number + 1) / double(*source.frameCount()));
  }
  json scenario{
      {"scenario", options.name}, {"frames", frames}, {"mri_T_target", rows(source.target().matrix())}};
  const ScenarioOptions played = resolved(options);
  ScenarioOptions::visit(played, JsonVisitor{scenario["options"]});
  scenario["capture_camera_T_mri"] = rows(source.captureTruth().matrix());
  writeWholeFile(writer.temporaryFolder() / "coil.json", coilJson(source.coil()).dump(2) + "\n");
  if (const auto& second = source.secondCoil()) {
    writeWholeFile(writer.temporaryFolder() / "coil2.json", coilJson(*second).dump(2) + "\n");
    scenario["mri_T_second_target"] = rows(source.secondTarget()->matrix());
  }
  writeWholeFile(writer.temporaryFolder() / "scenario.json", scenario.dump(2) + "\n");
  cameras::writeProjector(source.projector(), writer.temporaryFolder() / "projector.yml");
  writer.close();
}

}  // namespace facenav::room
