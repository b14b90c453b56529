#include "facenav/session/navigator.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "facenav/core/number_text.h"
#include "facenav/monitoring/pair_fault.h"
#include "facenav/session/face_memory.h"

namespace facenav::session {
namespace {

// The watchdog's dense measurement does not correct for the time between the exposures. It takes sideways
// motion between them for about five times as much depth.
constexpr double kMostBetweenExposures_mm = 0.2;

constexpr const char* kNotChecked = "REGISTRATION NOT CHECKED: show the whole face to both cameras";

constexpr const char* kJudgedWrong = "ALIGNMENT JUDGED WRONG: align again";

std::string failedWords(const monitoring::RegistrationFinding& finding) {
  return formatted("REGISTRATION FAILED: the face is %.1f mm and %.1f deg off, align again", finding.shift_mm,
                   finding.turn_deg);
}

/// Nothing of the head is shown before the registration is known to hold.
void withhold(NavigationState& state) {
  if (state.withheld.empty()) return;
  state.head = Lost{LostReason::high_residual};
  state.camera_T_mri = Lost{LostReason::high_residual};
}

bool isUsable(const cameras::StereoFrame& frame, const cameras::StereoRig& rig) {
  const auto fits = [&](const cv::Mat& image) {
    return image.type() == CV_8UC1 && image.cols == rig.width_px && image.rows == rig.height_px;
  };
  return fits(frame.left) && fits(frame.right);
}

std::unique_ptr<monitoring::BesideCoilWatch> makeGapWatch(const NavigatorSetup& setup) {
  const auto beside =
      std::make_shared<const monitoring::SurfaceBesideCoil>(setup.rig, setup.scalp, setup.plate.outline_mm);
  return std::make_unique<monitoring::BesideCoilWatch>(
      [beside](const monitoring::BesideCoilWatch::Question& question) {
        return beside->measure(*question.frame, question.camera_T_mri, question.camera_T_coil);
      },
      monitoring::BesideCoilWatch::Mode::own_thread);
}

}  // namespace

std::optional<double> gapToSkin_mm(const RigidTransform<Mri, Coil>& mri_T_coil,
                                   const registration::ScalpField& scalp) {
  const float gap_mm = scalp.fine(mri_T_coil.translation_mm().cast<float>()).distance_mm;
  if (!std::isfinite(gap_mm) || gap_mm >= registration::ScalpField::kFar_mm) return std::nullopt;
  return gap_mm;
}

Navigator::Navigator(const NavigatorSetup& setup, std::unique_ptr<head_tracking::HeadTracker> head,
                     std::unique_ptr<coil_tracking::CoilTracker> coil)
    : rig_(setup.rig),
      marker_T_coil_(setup.coil.marker_T_coil()),
      coil_name_(setup.coil.name),
      tolerance_(setup.tolerance),
      rig_check_(setup.rig),
      scalp_(setup.scalp),
      head_(std::move(head)),
      coil_(std::move(coil)) {
  if (setup.camera_T_mri_at_reference)  // Head = Camera at the reference frame, by the tracker's contract
    head_T_mri_ = setup.camera_T_mri_at_reference->reframe<Head, Mri>();
  head_tracking::HeadReference reference = setup.reference;
  if (head_T_mri_) reference.key_frames = asTracked(setup.key_frames, *head_T_mri_);
  monitoring::withPairFault(rig_, reference.frame, [&] { head_->start(rig_, reference, setup.pace); });
  coil_->start(rig_, setup.coil);
  rig_check_.start(setup.reference);
  if (setup.scalp && setup.camera_T_mri_at_reference && !setup.reference.surface.empty()) {
    drift_check_ = std::make_shared<monitoring::DriftCheck>(rig_, setup.scalp, setup.reference,
                                                            *setup.camera_T_mri_at_reference);
    const auto measure = [check = drift_check_](const auto& frame, const auto& camera_T_mri) {
      return check->measure(frame, camera_T_mri);
    };
    const auto mode = setup.pace == head_tracking::Pace::live ? monitoring::DriftWatchdog::Mode::own_thread
                                                              : monitoring::DriftWatchdog::Mode::in_line;
    watchdog_ = std::make_unique<monitoring::DriftWatchdog>(measure, mode);
    check_ = std::make_unique<monitoring::RegistrationCheck>(measure, mode);
  }
  if (setup.scalp && setup.pace == head_tracking::Pace::live) gap_watch_ = makeGapWatch(setup);
}

std::vector<casefile::StoredKeyFrame> Navigator::learntKeyFrames() const {
  // A wrong alignment would put the face at a wrong place of the MRI, also in later sessions.
  const bool is_in_doubt = is_judged_wrong_ || !withheld_.empty() || (watchdog_ && watchdog_->isAlarmed());
  if (!head_T_mri_ || is_in_doubt) return {};
  return asKept(head_->learntKeyFrames(), *head_T_mri_);
}

void Navigator::setTarget(std::optional<ChosenTarget> target) {
  target_ = target ? std::make_shared<const ChosenTarget>(std::move(*target)) : nullptr;
  previous_ = {};
}

void Navigator::setCoil(const coil_tracking::CoilModel& coil) {
  coil_->start(rig_, coil);
  marker_T_coil_ = coil.marker_T_coil();
  coil_name_ = coil.name;
  coil_deferred_ = {};
  previous_ = {};
}

NavigationState Navigator::process(std::shared_ptr<const cameras::StereoFrame> frame) {
  FACENAV_EXPECT(frame != nullptr, "a frame is needed");
  const Timestamp begin = Timestamp::now();
  double watching_ms = 0.0;  // not part of tracking: in a live session it runs in parallel
  NavigationState state;
  state.frame = frame->number;
  state.captured = frame->captured;
  state.arrived = state.taken = begin;
  state.is_aligned = head_T_mri_.has_value();
  state.target = target_ ? target_->target.name : "";
  state.coil_name = coil_name_;
  state.chosen = target_;
  state.tolerance = tolerance_;
  if (isUsable(*frame, rig_)) {
    // Who plugged a camera in again may have moved it.
    if (std::exchange(was_away_, false)) checkRegistration(true);
    watching_ms += track(*frame, state);
    place(state);
    const Timestamp tracked = Timestamp::now();
    check(frame, state);
    watch(frame, state);
    measureGap(frame, state);
    if (watchdog_) watching_ms += (Timestamp::now() - tracked) * 1e3;
    state.images = std::move(frame);
    guide(state);
    refuseFaultyRig(state);
  } else {
    noteAbsence(*frame, state);
    state.images = std::move(frame);
    state = blanked(state, LostReason::camera);
  }
  state.processing_ms = state.latency_ms = std::max(0.0, (Timestamp::now() - begin) * 1e3 - watching_ms);
  return state;
}

/// Measurements with cameras that do not fit their calibration cannot be trusted.
void Navigator::refuseFaultyRig(NavigationState& state) const {
  auto fault = rig_check_.fault();
  if (!state.images->rig_fault.empty())
    fault = {head_tracking::LossDetail::cameras_moved, state.images->rig_fault};
  if (!fault) return;
  state.rig_fault = fault->words;
  state.rig_fault_detail = fault->detail;
  state = blanked(state, LostReason::camera);
}

void Navigator::noteAbsence(const cameras::StereoFrame& frame, NavigationState& state) {
  if (frame.absence.empty()) return;
  was_away_ = true;
  state.rig_fault = frame.absence;
  state.rig_fault_detail = head_tracking::LossDetail::camera_away;
}

/// Tracks head, then coil. Returns the time (ms) of work that a live session does in parallel with the
/// frames.
double Navigator::track(const cameras::StereoFrame& frame, NavigationState& state) {
  const auto right_T_left = rig_check_.right_T_left();
  const auto head =
      head_->track(frame, {coil_deferred_, std::exchange(is_learnt_in_doubt_, false), right_T_left});
  const auto coil =
      coil_->track(frame, {head.exposure_offset, head.work, right_T_left, rig_check_.rightTurnSigma_rad()});
  coil_deferred_ = coil.deferred;
  state.head = head;
  state.head_detail = head.loss_detail;
  state.exposure_offset = head.exposure_offset;
  state.row_times_s = coil.row_times_s;
  state.coil = coil;
  rig_check_.add(frame, state.head, coil);
  state.rig_correction = rig_check_.correction();
  if (drift_check_ && !state.rig_correction.empty()) drift_check_->moveRight(rig_check_.right_T_left());
  return head.beside_ms;
}

void Navigator::place(NavigationState& state) const {
  if (!state.head)
    state.camera_T_mri = Lost{state.head.reason()};
  else if (head_T_mri_)
    state.camera_T_mri = {state.head->camera_T_head * *head_T_mri_, state.head.quality()};
  if (state.coil)
    state.camera_T_coil = {state.coil->camera_T_marker * marker_T_coil_, state.coil.quality()};
  else
    state.camera_T_coil = Lost{state.coil.reason()};
}

bool Navigator::checkRegistration(bool is_withheld_until) {
  if (!check_) return false;
  check_->begin();
  if (is_withheld_until) withheld_ = kNotChecked;
  return true;
}

/// It measures at the pose that is tracked, also while that is withheld.
void Navigator::check(const std::shared_ptr<const cameras::StereoFrame>& frame, NavigationState& state) {
  if (is_judged_wrong_) state.withheld = kJudgedWrong;
  if (!check_) return;
  check_->add(frame, state.camera_T_mri ? std::optional(*state.camera_T_mri) : std::nullopt);
  if (auto finding = check_->take()) {
    using Verdict = monitoring::DriftFinding::Verdict;
    if (finding->verdict == Verdict::agrees) withheld_.clear();
    if (finding->verdict == Verdict::drifted) withheld_ = failedWords(*finding);
    const bool must_repeat = finding->verdict == Verdict::unknown && withheld_ == kNotChecked;
    if (must_repeat) check_->begin();
    if (!must_repeat || !finding_)
      finding_ = std::make_shared<const monitoring::RegistrationFinding>(*finding);
  }
  state.check = finding_;
  if (!is_judged_wrong_) state.withheld = withheld_;
}

/// A face that is no longer where it is tracked is lost, whatever the tracker says.
void Navigator::watch(const std::shared_ptr<const cameras::StereoFrame>& frame, NavigationState& state) {
  if (!watchdog_) return withhold(state);
  const bool was_alarmed = watchdog_->isAlarmed();
  if (!state.head || state.head->between_exposures_mm < kMostBetweenExposures_mm)
    watchdog_->add(frame, state.camera_T_mri ? std::optional(*state.camera_T_mri) : std::nullopt);
  if (!watchdog_->isAlarmed()) return withhold(state);
  if (!was_alarmed) is_learnt_in_doubt_ = true;
  state.has_drifted = true;
  state.head = Lost{LostReason::high_residual};
  state.camera_T_mri = Lost{LostReason::high_residual};
}

/// From the poses in each frame; from stereo about once a second, beside the frames.
void Navigator::measureGap(const std::shared_ptr<const cameras::StereoFrame>& frame, NavigationState& state) {
  const auto maybe = [](const auto& tracked) { return tracked ? std::optional(*tracked) : std::nullopt; };
  const auto camera_T_mri = maybe(state.camera_T_mri);
  const auto camera_T_coil = maybe(state.camera_T_coil);
  if (gap_watch_) gap_watch_->add(frame, camera_T_mri, camera_T_coil);
  if (!scalp_ || !camera_T_mri || !camera_T_coil) return;
  state.gap.by_poses_mm = gapToSkin_mm(camera_T_mri->inverse() * *camera_T_coil, *scalp_);
  // The predicted error is that of a point in space; the gap feels its part along the normal.
  if (target_) state.gap.alignment_sigma_mm = target_->predicted_error_mm / std::sqrt(3.0);
  if (!gap_watch_ || !gap_watch_->finding()) return;
  const auto& finding = *gap_watch_->finding();
  state.gap.unseen = finding.unseen;
  if (finding.has_measured) state.gap.live = guidance::LiveSurface{finding.above_skin_mm, finding.sigma_mm};
}

void Navigator::guide(NavigationState& state) {
  if (target_)
    state.guidance = guidance::evaluate(target_->target, state.camera_T_mri, state.camera_T_coil, tolerance_,
                                        target_->predicted_error_mm, previous_);
  const std::string loss = lossInWords(state);
  if (!loss.empty()) state.guidance.instruction = loss;
  previous_ = state.guidance;
}

}  // namespace facenav::session
