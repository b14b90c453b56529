#include "evaluate/gate_trial.h"

#include <algorithm>
#include <map>

#include "evaluate/gate_case.h"
#include "evaluate/gate_truth.h"
#include "evaluate/gate_words.h"
#include "evaluate/mirrored_scan.h"
#include "facenav/align/film_beginning.h"
#include "facenav/core/processor_time.h"
#include "facenav/evaluation/frame_errors.h"
#include "facenav/geometry/rotation.h"
#include "facenav/measured_face/aligned_from.h"

namespace facenav::app {
namespace fs = std::filesystem;
namespace {

using room::WorldFault;

constexpr double kFoundWithin_s = 0.2, kLeastVisible = 0.3;

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
WorldScan scanOf(GateHeads& heads, const Trial& trial, const GateRow& row) {
  WorldScan scan = trial.head;
  if (row.fault.kind == WorldFault::mirrored) scan.scalp = mirrored(scan.scalp);
  if (row.fault.kind == WorldFault::other_person && row.fault.is_from_start)
    scan.scalp = heads.of(row.world, 1).scalp;
  return scan;
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
  const auto bound = alignment->predicted_tre_p95_mm.find(kGateTarget);
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

/// Tracks without the scan, where the alignment was refused.
void trackAlone(Context& context, const Trial& trial, GateRow& row) {
  int tracked = 0, frames = 0;
  try {
    steps::trackRecording(
        context.registrations, gateRequest(context, trial.recording), context.monitor,
        [&](const session::NavigationState& state) { ++frames, tracked += state.head.isTracked(); });
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& refusal) {
    row.refusal_alone = gateWords(refusal, trial.recording.parent_path());
  }
  if (frames > 0) row.tracked_alone = double(tracked) / frames;
}

/// What came of tracking with the case.
struct CaseTracking {
  bool has_frames = false;
  bool is_person_asked = false;  // who the patient is; nothing was tracked
};

CaseTracking trackWith(Context& context, const Trial& trial, const steps::TrackRequest& request,
                       GateRow& row) {
  CaseTracking tracking;
  std::map<std::string, int> losses;
  try {
    const auto outcome = steps::trackRecording(context.registrations, request, context.monitor,
                                               [&](const session::NavigationState& state) {
                                                 if (!tracking.has_frames) noteAlignment(context, trial, row);
                                                 tracking.has_frames = true;
                                                 noteFrame(state, trial, row, losses);
                                               });
    const double late_ms = 1e3 * row.fault.late_s;
    row.is_delay_found = late_ms > 0.0 && std::abs(outcome.right_late_ms - late_ms) < 0.5 * late_ms;
    if (outcome.rig_fault)
      for (const auto& name : faultsNamedIn(outcome.rig_fault->words())) row.named.insert(name);
  } catch (const Cancelled&) {
    throw;
  } catch (const registration::PersonUnclear&) {
    tracking.is_person_asked = !request.is_patient_confirmed && row.fault.kind != WorldFault::other_person;
    if (!tracking.is_person_asked) row.refusal = "another person, not confirmed";
  } catch (const Error& refusal) {
    row.refusal = gateWords(refusal, trial.recording.parent_path());
    for (const auto& name : faultsNamedIn(row.refusal)) row.named.insert(name);
  }
  row.losses = inWords(losses);
  return tracking;
}

void track(Context& context, const Trial& trial, GateRow& row) {
  auto request = gateRequest(context, trial.recording);
  request.case_folder = trial.case_folder;
  CaseTracking tracking = trackWith(context, trial, request, row);
  if (tracking.is_person_asked) {
    row.is_confirmed = request.is_patient_confirmed = true;
    tracking = trackWith(context, trial, request, row);
  }
  if (!tracking.has_frames && row.fault.kind == WorldFault::none) trackAlone(context, trial, row);
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
  trial.recording = gateRecordingIn(folder), trial.case_folder = folder / "case";
  record(trial);
  makeGateCase(scanOf(heads, trial, row), trial.case_folder);
  const double rendered_ms = processorTime_ms();
  row.room_s = 1e-3 * (rendered_ms - start_ms);
  track(context, trial, row);
  row.product_s = 1e-3 * (processorTime_ms() - rendered_ms);
  return row;
}

}  // namespace facenav::app
