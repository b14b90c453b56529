#include "facenav/session/navigator.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "facenav/coil_tracking/coil_card.h"
#include "facenav/health/rig_error.h"
#include "facenav/session/face_memory.h"

namespace facenav::session {
namespace {

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

/// Takes "on target" away under an alignment that is too uncertain.
void withholdUncertain(const ChosenTarget& chosen, guidance::GuidanceState& guidance) {
  if (guidance.state != guidance::State::on_target) return;
  const std::string uncertain = tooUncertainInWords(chosen);
  if (uncertain.empty()) return;
  guidance.state = guidance::State::adjust;
  guidance.action = guidance::Action::none;
  guidance.instruction = uncertain;
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
      model_(setup.coil),
      is_head_served_(setup.is_head_served),
      is_coil_served_(setup.is_coil_served),
      tolerance_(setup.tolerance),
      trust_(setup.rig),
      scalp_(setup.scalp),
      head_(std::move(head)),
      coil_(std::move(coil)) {
  if (setup.camera_T_mri_at_reference)  // Head = Camera at the reference frame, by the tracker's contract
    head_T_mri_ = setup.camera_T_mri_at_reference->reframe<Head, Mri>();
  head_tracking::HeadReference reference = setup.reference;
  if (head_T_mri_) reference.key_frames = asTracked(setup.key_frames, *head_T_mri_);
  health::withRigError(rig_, reference.frame, [&] { head_->start(rig_, reference, setup.pace); });
  coil_->start(rig_, setup.coil);
  trust_.start(setup.reference);
  if (setup.scalp && setup.camera_T_mri_at_reference && !setup.reference.surface.empty()) {
    drift_check_ = std::make_shared<monitoring::DriftCheck>(rig_, setup.scalp, setup.reference,
                                                            *setup.camera_T_mri_at_reference);
    const auto measure = [check = drift_check_](const auto& frame, const auto& camera_T_mri) {
      return check->measure(frame, camera_T_mri);
    };
    const auto mode = setup.pace == head_tracking::Pace::live ? monitoring::DriftWatchdog::Mode::own_thread
                                                              : monitoring::DriftWatchdog::Mode::in_line;
    trust_.setWatchdog(std::make_unique<monitoring::DriftWatchdog>(measure, mode));
    trust_.setCheck(std::make_unique<monitoring::RegistrationCheck>(measure, mode));
  }
  const bool has_pictures = !setup.is_head_served;
  if (setup.scalp && has_pictures && setup.pace == head_tracking::Pace::live)
    gap_watch_ = makeGapWatch(setup);
}

std::vector<casefile::StoredKeyFrame> Navigator::learntKeyFrames() const {
  // A wrong alignment would place the key frames wrongly in the MRI, also in later sessions.
  if (!head_T_mri_ || trust_.isAlignmentInDoubt()) return {};
  return asKept(head_->learntKeyFrames(), *head_T_mri_);
}

void Navigator::setTarget(std::optional<ChosenTarget> target) {
  target_ = target ? std::make_shared<const ChosenTarget>(std::move(*target)) : nullptr;
  previous_ = {};
}

void Navigator::setCoil(const coil_tracking::CoilModel& coil) {
  if (second_) coil_tracking::requireTellable(coil, second_->model);
  coil_->start(rig_, coil);
  model_ = coil;
  coil_deferred_ = {};
  previous_ = {};
}

void Navigator::addSecondCoil(const coil_tracking::CoilModel& coil,
                              std::unique_ptr<coil_tracking::CoilTracker> tracker) {
  coil_tracking::requireTellable(coil, model_);
  tracker->start(rig_, coil);
  second_ = Second{coil, std::move(tracker), nullptr, {}};
}

void Navigator::setSecondTarget(std::optional<ChosenTarget> target) {
  FACENAV_EXPECT(second_.has_value(), "there is a second coil");
  second_->target = target ? std::make_shared<const ChosenTarget>(std::move(*target)) : nullptr;
  second_->previous = {};
}

NavigationState Navigator::process(std::shared_ptr<const cameras::StereoFrame> frame) {
  FACENAV_EXPECT(frame != nullptr, "a frame is needed");
  const Timestamp begin = Timestamp::now();
  double watching_ms = 0.0;  // not part of tracking: in parallel in a live session
  NavigationState state;
  state.frame = frame->number;
  state.captured = frame->captured;
  state.arrived = state.taken = begin;
  state.is_aligned = head_T_mri_.has_value();
  state.target = target_ ? target_->target.name : "";
  state.coil_name = model_.name;
  state.is_head_served = is_head_served_;
  state.is_coil_served = is_coil_served_;
  if (second_) {
    state.second.emplace();
    state.second->name = second_->model.name;
    state.second->chosen = second_->target;
  }
  state.chosen = target_;
  state.tolerance = tolerance_;
  if (isUsable(*frame, rig_)) {
    // The camera may have been moved when it was plugged in again.
    if (std::exchange(was_away_, false)) checkRegistration(true);
    watching_ms += track(*frame, state);
    place(state);
    const Timestamp tracked = Timestamp::now();
    judge(frame, state);
    measureGap(frame, state);
    if (trust_.hasWatchdog()) watching_ms += (Timestamp::now() - tracked) * 1e3;
    state.images = std::move(frame);
    guide(state);
    guideSecond(state);
    if (rigFault(state)) state = blanked(state, LostReason::camera);
  } else {
    state.withheld = monitoring::withheldByAbsence(*frame);
    was_away_ = was_away_ || state.withheld;
    state.images = std::move(frame);
    state = blanked(state, LostReason::camera);
  }
  state.processing_ms = state.latency_ms = std::max(0.0, (Timestamp::now() - begin) * 1e3 - watching_ms);
  return state;
}

/// Tracks both coils with one budget of work. A coil that was seen goes first, because it needs little; coils
/// that are lost search in turn. Returns the first coil's result, with the work and the observation of both.
coil_tracking::CoilResult Navigator::trackCoils(const cameras::StereoFrame& frame,
                                                const coil_tracking::CoilContext& context,
                                                NavigationState& state) {
  if (!second_) return coil_->track(frame, context);
  const bool is_turn = frame.number % 2 != 0;
  const bool is_second_first = was_coil_tracked_ == second_->was_tracked ? is_turn : second_->was_tracked;
  coil_tracking::CoilContext later = context;
  auto& first_tracker = is_second_first ? *second_->tracker : *coil_;
  auto& later_tracker = is_second_first ? *coil_ : *second_->tracker;
  auto earlier_found = first_tracker.track(frame, context);
  if (earlier_found.work.comparisons > 0) later.work_before = earlier_found.work;
  auto later_found = later_tracker.track(frame, later);
  auto& coil = is_second_first ? later_found : earlier_found;
  auto& second = is_second_first ? earlier_found : later_found;
  was_coil_tracked_ = coil.isTracked();
  second_->was_tracked = second.isTracked();
  state.second->coil = second;
  coil.deferred.comparisons += second.deferred.comparisons;
  if (!coil.observation) coil.observation = second.observation;
  return coil;
}

/// Tracks head, then coil. Returns the time (ms) of work that a live session does in parallel with the
/// frames.
double Navigator::track(const cameras::StereoFrame& frame, NavigationState& state) {
  const auto right_T_left = trust_.rig().right_T_left();
  const auto head =
      head_->track(frame, {coil_deferred_, std::exchange(is_learnt_in_doubt_, false), right_T_left});
  const auto coil = trackCoils(
      frame, {head.exposure_offset, head.work, right_T_left, trust_.rig().rightTurnSigma_rad()}, state);
  coil_deferred_ = coil.deferred;
  state.head = head;
  state.head_detail = head.loss_detail;
  state.exposure_offset = head.exposure_offset;
  state.row_times_s = coil.row_times_s;
  state.coil = coil;
  trust_.addCameras(frame, state.head, coil);
  state.rig_correction = trust_.rig().correction();
  if (drift_check_ && state.rig_correction) drift_check_->moveRight(trust_.rig().right_T_left());
  return head.beside_ms;
}

void Navigator::place(NavigationState& state) const {
  if (!state.head)
    state.camera_T_mri = Lost{state.head.reason()};
  else if (head_T_mri_)
    state.camera_T_mri = {state.head->camera_T_head * *head_T_mri_, state.head.quality()};
  if (state.coil)
    state.camera_T_coil = {state.coil->camera_T_marker * model_.marker_T_coil(), state.coil.quality()};
  else
    state.camera_T_coil = Lost{state.coil.reason()};
  if (!second_) return;
  auto& second = *state.second;
  if (second.coil)
    second.camera_T_coil = {second.coil->camera_T_marker * second_->model.marker_T_coil(),
                            second.coil.quality()};
  else
    second.camera_T_coil = Lost{second.coil.reason()};
}

bool Navigator::checkRegistration(bool is_withheld_until) {
  return trust_.checkRegistration(is_withheld_until);
}

/// Decides whether the poses may be shown. Uses the tracked pose even while it is withheld.
void Navigator::judge(const std::shared_ptr<const cameras::StereoFrame>& frame, NavigationState& state) {
  trust_.addFace(frame, state.head, state.camera_T_mri ? std::optional(*state.camera_T_mri) : std::nullopt);
  state.check = trust_.finding();
  state.withheld = trust_.withheld(*frame);
  if (trust_.hasNewAlarm()) is_learnt_in_doubt_ = true;
  // After guidance, a fault of the cameras blanks the whole state.
  if (!state.withheld || state.withheld->isOfCameras()) return;
  state.head = Lost{LostReason::high_residual};
  state.camera_T_mri = Lost{LostReason::high_residual};
}

/// Measures the gap: from the poses in each frame, from stereo about once a second in parallel.
void Navigator::measureGap(const std::shared_ptr<const cameras::StereoFrame>& frame, NavigationState& state) {
  const auto maybe = [](const auto& tracked) { return tracked ? std::optional(*tracked) : std::nullopt; };
  const auto camera_T_mri = maybe(state.camera_T_mri);
  const auto camera_T_coil = maybe(state.camera_T_coil);
  if (gap_watch_) gap_watch_->add(frame, camera_T_mri, camera_T_coil);
  if (scalp_ && camera_T_mri && state.second && state.second->camera_T_coil)
    state.second->gap_mm = gapToSkin_mm(camera_T_mri->inverse() * *state.second->camera_T_coil, *scalp_);
  if (!scalp_ || !camera_T_mri || !camera_T_coil) return;
  state.gap.by_poses_mm = gapToSkin_mm(camera_T_mri->inverse() * *camera_T_coil, *scalp_);
  // The predicted error is that of a point in space; the gap is affected only by its component along the
  // normal.
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
  if (target_) withholdUncertain(*target_, state.guidance);
}

void Navigator::guideSecond(NavigationState& state) {
  if (!second_) return;
  auto& second = *state.second;
  if (second.chosen)
    second.guidance = guidance::evaluate(second.chosen->target, state.camera_T_mri, second.camera_T_coil,
                                         tolerance_, second.chosen->predicted_error_mm, second_->previous);
  const std::string loss = state.camera_T_mri ? secondCoilLossInWords(state) : lossInWords(state);
  if (!loss.empty()) second.guidance.instruction = loss;
  second_->previous = second.guidance;
  if (second.chosen) withholdUncertain(*second.chosen, second.guidance);
}

}  // namespace facenav::session
