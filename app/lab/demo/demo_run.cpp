#include "demo/demo_run.h"

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "demo/demo_pictures.h"
#include "demo/virtual_patient_files.h"
#include "facenav/core/whole_file.h"
#include "facenav/geometry/pose_error.h"
#include "facenav/geometry/rotation.h"
#include "facenav/guidance/hand_knob.h"
#include "facenav/plan/plan_edits.h"
#include "facenav/prepare/prepare_case.h"
#include "facenav/room/simulate.h"
#include "facenav/scene/display.h"
#include "facenav/treat/guide_poses.h"
#include "facenav/treat/track_recording.h"
#include "result_folder.h"
#include "virtual_display.h"

namespace facenav::app {
namespace fs = std::filesystem;
namespace {

constexpr const char* kTarget = "M1 hand L";
constexpr double kHandleAngle_rad = 45.0 * kRadPerDeg;
constexpr double kHairGap_mm = 4.0;

class Stopwatch {
 public:
  explicit Stopwatch(DemoFigures& figures) : figures_(figures) {}
  void lap(const std::string& step) {
    const double now = seconds();
    figures_.step_s.push_back({step, now - last_});
    figures_.total_s = now;
    last_ = now;
  }

 private:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  DemoFigures& figures_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double last_ = 0;
};

std::vector<evaluation::PoseEstimate> estimatesOf(const std::vector<casefile::PoseRow>& rows,
                                                  casefile::PoseObject object) {
  std::vector<evaluation::PoseEstimate> estimates;
  for (const auto& row : rows)
    if (row.object == object)
      estimates.push_back(
          {row.frame, row.pose.has_value(), row.pose.value_or(Eigen::Isometry3d::Identity())});
  return estimates;
}

guidance::Target planHandArea(const casefile::CaseStore& store) {
  const auto brain = store.brain();
  if (!brain)
    throw Error("the demo's patient has no brain model", store.folder().string(), "report this, please");
  const auto atlas = store.atlas();
  const Point<Mri> hand_area = atlas
                                   ? steps::cortexNear(steps::plannedHead(store),
                                                       atlas->toMri(guidance::handKnob(guidance::Side::left)))
                                   : guidance::handKnobGuess(*brain, guidance::Side::left);
  auto target = guidance::planTarget(kTarget, store.scalp(), hand_area, kHandleAngle_rad, kHairGap_mm);
  store.setTargets({{target}});
  return target;
}

RigidTransform<Camera, Mri> captureTruth(const fs::path& recording) {
  const auto json = nlohmann::json::parse(readWholeFile(recording / "scenario.json"));
  Eigen::Matrix4d matrix;
  for (int i = 0; i < 16; ++i) matrix(i / 4, i % 4) = json.at("capture_camera_T_mri").at(i).get<double>();
  return RigidTransform<Camera, Mri>::fromMatrix(matrix);
}

struct Truth {
  std::map<std::int64_t, Eigen::Isometry3d> head, coil;  // camera_T_mri, camera_T_coil
};

/// Reads the room's truth. A recording without a coil (the protractor) has none for the coil.
Truth readRoomTruth(const fs::path& recording) {
  Truth truth{capture::readTruth(recording / "truth/head.csv"), {}};
  if (!fs::exists(recording / "truth/coil.csv")) return truth;
  truth.coil = capture::readTruth(recording / "truth/coil.csv");
  const auto marker_T_coil = coil_tracking::readCoil(recording / "coil.json").marker_T_coil();
  for (auto& [frame, pose] : truth.coil) pose = pose * marker_T_coil.isometry();
  return truth;
}

void measureTreatment(const std::vector<casefile::PoseRow>& poses, const Truth& truth,
                      const guidance::Target& target, DemoFigures& figures) {
  const auto head = estimatesOf(poses, casefile::PoseObject::head),
             coil = estimatesOf(poses, casefile::PoseObject::coil);
  figures.head = evaluation::evaluateTracking(head, truth.head, target.cortex_point.mm);
  figures.coil = evaluation::evaluateTracking(coil, truth.coil, Eigen::Vector3d::Zero());
  std::vector<double> coil_on_head_mm;
  for (std::size_t i = 0; i < std::min(head.size(), coil.size()); ++i) {
    const auto frame = head[i].frame;
    if (!head[i].is_tracked || !coil[i].is_tracked || !truth.head.count(frame) || !truth.coil.count(frame))
      continue;
    const Eigen::Vector3d estimated = head[i].pose.inverse() * coil[i].pose.translation();
    coil_on_head_mm.push_back(
        (estimated - truth.head.at(frame).inverse() * truth.coil.at(frame).translation()).norm());
  }
  figures.coil_on_head_mm = evaluation::summarise(coil_on_head_mm);
  if (truth.head.empty() || truth.coil.empty()) return;
  const Eigen::Vector3d last_mm =
      truth.head.rbegin()->second.inverse() * truth.coil.rbegin()->second.translation();
  figures.final_distance_mm = (last_mm - target.mri_T_target.translation_mm()).norm();
}

room::ScenarioOptions scenario(const char* name, const DemoRequest& request) {
  room::ScenarioOptions options;
  options.name = name;
  options.seed = request.seed;
  return options;
}

casefile::CaseStore prepareCase(Context& context, const fs::path& dicom_folder, const fs::path& folder) {
  steps::PrepareRequest prepare{dicom_folder,
                                folder / "case",
                                {},
                                context.registrations.head_segmenters.defaultName(),
                                context.registrations.brain_segmenters.defaultName()};
  return steps::prepareCase(context.registrations, prepare, context.monitor).store;
}

/// Records the protractor and the treatment in the virtual room.
void simulateBoth(Context& context, const DemoRequest& request, const casefile::CaseStore& store,
                  const guidance::Target& target, const fs::path& folder) {
  const auto patient =
      std::make_shared<const room::VirtualPatient>(room::makePatient(store.mri(), {}, context.monitor));
  room::simulate(scenario("protractor", request), patient, target.mri_T_target, folder / "protractor",
                 context.monitor);
  auto treatment = scenario("treatment", request);
  treatment.frames = request.frames;
  room::simulate(treatment, patient, target.mri_T_target, folder / "recording", context.monitor);
}

steps::TrackRequest trackRequest(const Context& context, const casefile::CaseStore& store,
                                 const fs::path& recording) {
  return {recording,
          store.folder(),
          std::nullopt,
          context.registrations.aligners.defaultName(),
          context.registrations.head_trackers.defaultName(),
          context.registrations.coil_trackers.defaultName(),
          kTarget};
}

void trackProtractor(Context& context, const casefile::CaseStore& store, const guidance::Target& target,
                     const fs::path& folder, DemoFigures& figures) {
  const auto protractor = steps::trackRecording(
      context.registrations, trackRequest(context, store, folder / "protractor"), context.monitor);
  const Truth truth = readRoomTruth(folder / "protractor");
  figures.protractor = evaluation::evaluateTracking(estimatesOf(protractor.poses, casefile::PoseObject::head),
                                                    truth.head, target.cortex_point.mm);
  writeProtractorPlot(figures.protractor, truth.head, folder / "protractor_error.svg");
}

void measureAlignment(const steps::AlignmentOutcome& alignment, const fs::path& recording,
                      const guidance::Target& target, DemoFigures& figures) {
  figures.alignment = alignment.stored();
  const auto error = poseError(alignment.result.camera_T_mri, captureTruth(recording), target.cortex_point);
  figures.alignment_rotation_deg = error.rotation_rad * kDegPerRad;
  figures.alignment_at_target_mm = error.at_point_mm;
}

using States = std::vector<std::shared_ptr<const session::NavigationState>>;

/// Aligns, tracks and guides the treatment: its files, its figures and, for the pictures, each frame's state.
steps::TrackOutcome trackTreatment(Context& context, const casefile::CaseStore& store,
                                   const guidance::Target& target, const fs::path& folder, States& states,
                                   DemoFigures& figures) {
  auto track = trackRequest(context, store, folder / "recording");
  track.coil_file = folder / "recording/coil.json";
  auto tracked = steps::trackRecording(
      context.registrations, track, context.monitor, [&](const session::NavigationState& state) {
        states.push_back(std::make_shared<const session::NavigationState>(state));
      });
  casefile::writePoses(tracked.poses, folder / "poses.csv");
  const auto guidance_rows = steps::guidePoses(store, tracked.poses, kTarget);
  guidance::writeGuidanceCsv(guidance_rows, folder / "guidance.csv");
  figures.frames_on_target =
      int(std::count_if(guidance_rows.begin(), guidance_rows.end(),
                        [](const auto& row) { return row.state.state == guidance::State::on_target; }));
  measureTreatment(tracked.poses, readRoomTruth(folder / "recording"), target, figures);
  measureAlignment(*tracked.alignment, folder / "recording", target, figures);
  return tracked;
}

std::vector<evaluation::ReportFigure> drawAll(Context& context, const casefile::CaseStore& store,
                                              const guidance::Target& target,
                                              const steps::AlignmentOutcome& alignment, States states,
                                              const fs::path& folder) {
  const auto rig = cameras::readRig(folder / "recording/stereo.yml");
  auto pictures = drawNavigation({store, rig, target, std::move(states)}, folder, context.monitor);
  for (auto& figure : drawAlignment(store, alignment, folder)) pictures.push_back(std::move(figure));
  pictures.push_back({"Tracking error over the head's rotation (paper, figure 13).", "protractor_error.svg"});
  return pictures;
}

}  // namespace

DemoFigures runDemo(Context& context, const DemoRequest& request) {
  DemoFigures figures;
  Stopwatch watch(figures);
  ResultFolder result(request.folder, "report.html", "a demo");
  const fs::path& folder = result.path();
  std::optional<VirtualDisplay> display;
  if (!scene::canDrawScenes()) display.emplace();
  const auto patient_files = virtualPatientFiles(context);
  watch.lap("virtual patient");

  const casefile::CaseStore store = prepareCase(context, patient_files.dicom_folder, folder);
  const auto target = planHandArea(store);
  watch.lap("import, brain and skin model, plan");

  simulateBoth(context, request, store, target, folder);
  watch.lap("virtual room: both recordings");

  trackProtractor(context, store, target, folder, figures);
  watch.lap("align and track the protractor");

  States states;
  const auto tracked = trackTreatment(context, store, target, folder, states, figures);
  watch.lap("align, track and guide the treatment");

  const auto pictures = drawAll(context, store, target, *tracked.alignment, std::move(states), folder);
  watch.lap("pictures and video");
  writeDemoReport(figures, pictures, folder);
  result.finish();
  return figures;
}

}  // namespace facenav::app
