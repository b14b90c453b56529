#include "evaluate/gate_trial.h"

#include <algorithm>
#include <map>

#include "evaluate/gate_truth.h"
#include "evaluate/gate_words.h"
#include "evaluate/mirrored_scan.h"
#include "facenav/align/film_beginning.h"
#include "facenav/casefile/case_store.h"
#include "facenav/core/processor_time.h"
#include "facenav/evaluation/frame_errors.h"
#include "facenav/geometry/rotation.h"
#include "facenav/measured_face/aligned_from.h"
#include "facenav/treat/track_recording.h"

namespace facenav::app {
namespace fs = std::filesystem;
namespace {

using room::WorldFault;

constexpr double kFoundWithin_s = 0.2, kLeastVisible = 0.3;
constexpr const char* kTarget = "behind the bridge of the nose";

/// A scan whose voxels nobody reads: alignment and tracking use the skin alone.
volume::Volume emptyScan() {
  volume::Volume scan;
  scan.grid.size = {8, 8, 8};
  scan.grid.mri_from_voxel = Eigen::Affine3d(Eigen::Translation3d(-112, -112, -112)) * Eigen::Scaling(32.0);
  scan.voxels.assign(512, 0.f);
  scan.orientation_source = "sform";
  return scan;
}

void makeCase(const surface::ScalpSurface& scalp, const Point<Mri>& target, const fs::path& folder) {
  casefile::PreparedCase prepared;
  prepared.mri = emptyScan();
  prepared.head_mask = {prepared.mri.grid, std::vector<std::uint8_t>(512, 1)};
  prepared.scalp = scalp;
  const auto store = casefile::CaseStore::create(folder, prepared, {}, true);
  guidance::Target there;
  there.name = kTarget;
  there.cortex_point = there.scalp_point = target;
  there.mri_T_target = {Eigen::Quaterniond::Identity(), target.mm};
  store.setTargets({{there}});
}

struct Trial {
  WorldHead head;
  cameras::StereoRig truth, stated;
  std::unique_ptr<room::WorldRoom> room;
  fs::path recording, case_folder;
  std::vector<double> visible;  // share of the face, by frame
};

cameras::StereoRig statedRig(const room::World& world, WorldFault fault, const cameras::StereoRig& truth) {
  if (fault != WorldFault::other_rig) return room::calibratedRig(world, truth);
  // Another world's cameras, with pictures of this size.
  room::World other = room::drawWorld(world.seed + 1000003);
  other.cameras.rig.focal_px *= double(truth.width_px) / other.cameras.rig.width_px;
  other.cameras.rig.width_px = truth.width_px, other.cameras.rig.height_px = truth.height_px;
  return room::calibratedRig(other, room::trueRig(other));
}

/// Where the head truly is, as the cameras measure it with the calibration in use.
Eigen::Isometry3d seenTruth(const Trial& trial, int number, bool is_corrected) {
  auto truth = trial.truth, used = trial.stated;
  truth.right_T_left = trial.room->right_T_left(number);
  if (is_corrected)  // by its true motion
    used.right_T_left = RigidTransform<RightCamera, Camera>::fromIsometry(
        truth.right_T_left.isometry() * trial.truth.right_T_left.isometry().inverse() *
        trial.stated.right_T_left.isometry());
  const auto camera_T_mri = number < 0 ? trial.room->captureTruth() : trial.room->truth(number);
  return poseAsMeasured(truth, used, camera_T_mri.isometry(), trial.head.target.mm);
}

void record(Trial& trial) {
  capture::RecordingWriter writer(trial.recording, trial.stated, FileAccess::by_umask, Existing::replace);
  writer.setCapture(trial.room->capture());
  for (int number = 0; number < room::WorldRoom::frameCount(); ++number) {
    writer.add(trial.room->frame(number));
    writer.addTruth(number, seenTruth(trial, number, false), {});
    trial.visible.push_back(trial.room->faceVisibleFraction());
  }
  writer.close();
}

/// The scan that the case holds.
surface::ScalpSurface scanOf(GateHeads& heads, const Trial& trial, const GateRow& row) {
  if (row.fault.kind == WorldFault::mirrored) return mirrored(trial.head.scalp);
  if (row.fault.kind == WorldFault::other_person && row.fault.is_from_start)
    return heads.of(row.world, 1).scalp;
  return trial.head.scalp;
}

/// True if the frame (-1: the capture) has no right pose of this scan.
bool mustBeLost(const room::DrawnFault& fault, int number) {
  const bool is_faulty = fault.is_from_start || room::WorldRoom::isSecond(number);
  switch (fault.kind) {
    case WorldFault::mirrored:
    case WorldFault::swapped:
    case WorldFault::other_person:
      return is_faulty;
    default:
      return false;
  }
}

struct Off {
  double mm, deg;
};
Off offBy(const Eigen::Isometry3d& pose, const Eigen::Isometry3d& truth, const Point<Mri>& target) {
  return {(pose * target.mm - truth * target.mm).norm(),
          kDegPerRad * rotationAngle(pose.linear().transpose() * truth.linear())};
}

/// Number of the frame that the pose belongs to: the film's first one with a face, or -1, the capture.
int alignedFrame(const Context& context, const Trial& trial, const casefile::StoredAlignment& alignment) {
  if (alignment.from != measured_face::nameOf(measured_face::AlignedFrom::film)) return -1;
  const auto detector = context.registrations.face_detector();
  return int(steps::beginningOf(capture::openRecording(trial.recording), detector.get()).first);
}

void noteAlignment(const Context& context, const Trial& trial, GateRow& row) {
  const auto store = casefile::CaseStore::open(trial.case_folder);
  const auto alignment = store.alignment();
  if (!alignment) return;
  row.is_accepted = true;
  row.from = alignment->from.value_or("");
  const auto truth = seenTruth(trial, alignedFrame(context, trial, *alignment), false);
  const auto off = offBy(alignment->camera_T_mri.isometry(), truth, trial.head.target);
  row.start_mm = off.mm, row.start_deg = off.deg;
  const auto bound = alignment->predicted_tre_p95_mm.find(kTarget);
  if (bound != alignment->predicted_tre_p95_mm.end()) row.bound_mm = bound->second;
  for (const auto& caution : alignment->cautions)
    for (const auto& name : faultsNamedIn(caution))
      if (name != "other_person") row.named.insert(name);  // a caution only asks to check that
}

void noteFrame(const session::NavigationState& state, const Trial& trial, GateRow& row,
               std::map<std::string, int>& losses) {
  const int number = int(state.frame);
  const bool is_second = room::WorldRoom::isSecond(number);
  const bool is_visible = trial.visible[std::size_t(number)] >= kLeastVisible;
  row.visible += is_visible, row.second_visible += is_visible && is_second;
  if (state.rig_correction) row.named.insert("moved");
  if (!state.camera_T_mri) {
    const std::string word = session::lossWord(state);
    ++losses[toString(state.camera_T_mri.reason()) + (word.empty() ? "" : ":" + word)];
    for (const auto& name : faultsNamedIn(word)) row.named.insert(name);
    return;
  }
  row.tracked += is_visible, row.second_tracked += is_visible && is_second;
  const double since_s = (number - room::kFirstFrames) / room::kWorldFrames_per_s;
  row.is_found_again = row.is_found_again || (is_second && since_s < kFoundWithin_s);
  if (mustBeLost(row.fault, number)) {
    ++row.over_tolerance, ++row.wrong_shown;
    return;
  }
  const auto off = offBy(state.camera_T_mri->isometry(),
                         seenTruth(trial, number, state.rig_correction.has_value()), trial.head.target);
  row.errors_mm.push_back(off.mm);
  const bool is_over = off.mm > evaluation::kWrong_mm || off.deg > evaluation::kWrong_deg;
  row.over_tolerance += is_over;
  row.wrong_shown += is_over && off.mm > row.bound_mm;
}

std::string inWords(const std::map<std::string, int>& losses) {
  std::string words;
  for (const auto& [word, count] : losses)
    words += (words.empty() ? "" : " ") + word + " x" + std::to_string(count);
  return words;
}

/// The program's words without the trial's own folder.
std::string wordsOf(const Error& refusal, const Trial& trial) {
  std::string words = refusal.what();
  const std::string folder = trial.recording.parent_path().string() + "/";
  for (std::size_t at; (at = words.find(folder)) != std::string::npos;) words.erase(at, folder.size());
  return words;
}

steps::TrackRequest requestOf(const Context& context, const Trial& trial) {
  steps::TrackRequest request;
  request.recording = trial.recording;
  request.aligner = context.registrations.aligners.defaultName();
  request.head_tracker = context.registrations.head_trackers.defaultName();
  request.coil_tracker = context.registrations.coil_trackers.defaultName();
  return request;
}

/// Tracks without the scan, where the alignment was refused.
void trackAlone(Context& context, const Trial& trial, GateRow& row) {
  int tracked = 0, frames = 0;
  try {
    steps::trackRecording(
        context.registrations, requestOf(context, trial), context.monitor,
        [&](const session::NavigationState& state) { ++frames, tracked += state.head.isTracked(); });
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& refusal) {
    row.refusal_alone = wordsOf(refusal, trial);
  }
  if (frames > 0) row.tracked_alone = double(tracked) / frames;
}

/// Tracks with the case. Throws registration::PersonUnclear where a person is to be asked.
void trackWith(Context& context, const Trial& trial, const steps::TrackRequest& request, GateRow& row,
               bool& has_frames) {
  std::map<std::string, int> losses;
  try {
    const auto outcome = steps::trackRecording(context.registrations, request, context.monitor,
                                               [&](const session::NavigationState& state) {
                                                 if (!has_frames) noteAlignment(context, trial, row);
                                                 has_frames = true;
                                                 noteFrame(state, trial, row, losses);
                                               });
    const double late_ms = 1e3 * row.fault.late_s;
    row.is_delay_found = late_ms > 0.0 && std::abs(outcome.right_late_ms - late_ms) < 0.5 * late_ms;
    if (outcome.rig_fault)
      for (const auto& name : faultsNamedIn(outcome.rig_fault->words())) row.named.insert(name);
  } catch (const Cancelled&) {
    throw;
  } catch (const registration::PersonUnclear&) {
    if (!request.is_patient_confirmed && row.fault.kind != WorldFault::other_person) throw;
    row.refusal = "another person, not confirmed";
  } catch (const Error& refusal) {
    row.refusal = wordsOf(refusal, trial);
    for (const auto& name : faultsNamedIn(row.refusal)) row.named.insert(name);
  }
  row.losses = inWords(losses);
}

void track(Context& context, const Trial& trial, GateRow& row) {
  auto request = requestOf(context, trial);
  request.case_folder = trial.case_folder;
  bool has_frames = false;
  try {
    trackWith(context, trial, request, row, has_frames);
  } catch (const registration::PersonUnclear&) {
    row.is_confirmed = request.is_patient_confirmed = true;
    trackWith(context, trial, request, row, has_frames);
  }
  if (!has_frames && row.fault.kind == WorldFault::none) trackAlone(context, trial, row);
}

}  // namespace

bool GateRow::isNamedRightly() const {
  const std::string right = rightNameOf(fault.kind);
  if (right.empty()) return named.empty();
  if (named.empty()) return is_delay_found;
  return named.size() == 1 && *named.begin() == right;
}

GateRow runGateTrial(Context& context, GateHeads& heads, std::uint64_t seed, WorldFault kind,
                     const fs::path& folder) {
  GateRow row;
  row.world = room::drawWorld(seed);
  row.fault = room::drawFault(row.world, kind);
  Trial trial;
  trial.head = heads.of(row.world);
  row.head = trial.head.name;
  const double start_ms = processorTime_ms();
  trial.truth = room::trueRig(row.world);
  trial.stated = statedRig(row.world, kind, trial.truth);
  row.calibration_px = trial.stated.rms_px.value_or(0.0);
  trial.room = std::make_unique<room::WorldRoom>(row.world, row.fault, trial.head.person);
  auto at_capture = trial.truth;
  at_capture.right_T_left = trial.room->right_T_left(-1);
  row.size_measured =
      sizeAsMeasured(at_capture, trial.stated, trial.room->captureTruth().isometry(), trial.head.target.mm);
  trial.recording = folder / "recording", trial.case_folder = folder / "case";
  record(trial);
  makeCase(scanOf(heads, trial, row), trial.head.target, trial.case_folder);
  const double rendered_ms = processorTime_ms();
  row.room_s = 1e-3 * (rendered_ms - start_ms);
  track(context, trial, row);
  row.product_s = 1e-3 * (processorTime_ms() - rendered_ms);
  return row;
}

}  // namespace facenav::app
