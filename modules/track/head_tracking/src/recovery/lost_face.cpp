#include "lost_face.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "facenav/core/processor_time.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/head_tracking/skin_detail_limits.h"
#include "facenav/health/surface_matches.h"
#include "head/pose_fit.h"
#include "head/track_verdict.h"

namespace facenav::head_tracking {
namespace {

constexpr double kOneMotion_s = 0.5;     // longest time between two answers that give the head's speed
constexpr int kThoroughEvery = 4;        // questions; a search at all roll angles takes ten times longer
constexpr double kDiagnosedFor_s = 3.0;  // the room decides anew after that; 0.3 s of one core
constexpr int kFirstLevel = 1;
constexpr double kKnownShare = 0.8;  // share of windows in place; lower with another expression
// Agreement with the reference divided by that of both cameras, mean and standard deviation, for the patient
// and for others. Evidence: resources/doc/evidence.md.
constexpr double kOwnDetail = 0.91, kOwnSigma = 0.15, kOtherDetail = 0.14, kOtherSigma = 0.13;

// True if the images keep the skin's fine detail, as shown by the agreement of both cameras.
bool keepsDetail(const DetailAgreement& of_both_cameras) {
  return of_both_cameras.value() >= settingsOf<SkinDetailLimits>().detail_least_agreed;
}

// Log likelihood ratio of the skin's fine detail; 0 if the images do not keep that detail.
double evidenceOf(const DetailAgreement& seen, const DetailAgreement& of_both_cameras) {
  if (!keepsDetail(of_both_cameras)) return 0.0;
  const double share = seen.value() / of_both_cameras.value();
  const auto logNormal = [](double z, double sigma) { return -0.5 * z * z - std::log(sigma); };
  const double own_sigma = std::hypot(kOwnSigma, seen.sigma()),
               other_sigma = std::hypot(kOtherSigma, seen.sigma());
  return logNormal((std::min(share, kOwnDetail) - kOwnDetail) / own_sigma, own_sigma) -
         logNormal((std::max(share, kOtherDetail) - kOtherDetail) / other_sigma, other_sigma);
}

/// Outline of the skin that was found in the left picture, px.
std::vector<cv::Point> outlineOf(const std::vector<SkinMatch>& matches) {
  std::vector<Eigen::Vector2f> left_px;
  for (const SkinMatch& match : matches)
    if (match.camera == 0) left_px.push_back(match.px.cast<float>());
  return health::outlineOf(left_px);
}

}  // namespace

LostFace::LostFace(std::shared_ptr<FaceRecovery> recovery, const Learnt& learnt, Pace pace)
    : recovery_(std::move(recovery)),
      learnt_(learnt),
      pace_(pace),
      answers_([recovery = recovery_,
                learnt](const Question& question) { return answer(*recovery, learnt, question); },
               pace == Pace::live ? LaterAnswer<Question, Found>::Mode::own_thread
                                  : LaterAnswer<Question, Found>::Mode::in_line,
               pace == Pace::patient ? 0.0 : kAnswer_s) {}

LostFace::Found LostFace::answer(const FaceRecovery& recovery, const Learnt& learnt,
                                 const Question& question) {
  Found found;
  found.captured = question.frame.captured, found.epoch = question.epoch;
  auto face = recovery.find(question.frame, question.last, question.is_thorough);
  if (!face) return found;
  found.face = std::move(*face);
  found.camera_T_head = found.face.pose.camera_T_head;
  found.identify();
  if (question.is_diagnosed && (found.is_out_of_step || found.face.lines.isOutOfStep()))
    found.diagnosed = health::causeOfOffset(question.rig, question.frame, outlineOf(found.face.pose.matches));
  if (!found.is_patient) return found;
  found.frame = question.frame;
  const std::array<ImagePyramid, 2> now = {ImagePyramid(question.frame.left),
                                           ImagePyramid(question.frame.right)};
  const PatchModel& model = *learnt.model;
  const PoseFit patches =
      fitPose(question.rig, model, model.level, now, found.camera_T_head, kFirstLevel, {});
  const DetailAgreement detail = detailAgreement(question.rig, model, model.level[0], now, patches);
  found.face.identity.log_likelihood_ratio += evidenceOf(detail, *learnt.both_cameras);
  found.identify();
  found.is_other |= found.face.identity.verdict() == Identity::Verdict::other;
  if (!found.is_patient) return found;
  // Where the reference's patches look as expected, they are more exact than recovery's windows.
  if (patches.scale < kAsExpected && judge(model, patches).isTracked() &&
      identityOfSkin(detail, *learnt.both_cameras) == SkinIdentity::patient)
    found.camera_T_head = patches.motion;
  else
    learnMoment(recovery, learnt, question.rig, found);
  return found;
}

// Sets the verdict from the identity, and from whether both images show one moment.
void LostFace::Found::identify() {
  const auto verdict = face.identity.verdict();
  is_out_of_step = face.sides == SidesVerdict::out_of_step || face.lines.isClearlyOutOfStep();
  is_patient = verdict == Identity::Verdict::patient && face.sides == SidesVerdict::agree;
  is_other = verdict == Identity::Verdict::other && face.is_face_seen && !is_out_of_step;
}

// Makes new patches from the frame at the pose that recovery found.
void LostFace::learnMoment(const FaceRecovery& recovery, const Learnt& learnt, const cameras::StereoRig& rig,
                           Found& found) {
  const RecoveryPose& pose = found.face.pose;
  const Eigen::Vector3d& centre_mm = learnt.model->centre_mm;
  found.moment = KeyFrames::ofMoment(rig, *learnt.model, found.frame, found.camera_T_head,
                                     recovery.carried(pose, pose.covariance, centre_mm),
                                     recovery.carried(pose, pose.unseen_covariance, centre_mm));
  found.is_patient = found.moment.has_value();
}

std::optional<LostFace::Found> LostFace::take(Timestamp now) {
  auto found = answers_.take(now.s);
  if (is_to_forget_ && !answers_.isBusy()) recovery_->forgetRemembered(), is_to_forget_ = false;
  if (!found || found->epoch != epoch_) return std::nullopt;
  const double allowed = allowed_px(*found);
  if (found->face.identity.verdict() == Identity::Verdict::patient) {
    const auto verdict = step_.judge(found->face.lines, allowed, found->captured);
    if (verdict != StepVerdict::in_step) found->is_patient = false, found->moment.reset();
    found->is_out_of_step |= verdict == StepVerdict::out_of_step;
    found->is_step_unsure = verdict == StepVerdict::unsure;
  }
  explainOffset(*found);
  return found;
}

// A diagnosis only chooses the words: the pair is off its lines by whatever cause.
void LostFace::explainOffset(Found& found) {
  if (found.diagnosed) cause_ = *found.diagnosed, diagnosed_ = found.captured;
  if (!found.is_out_of_step && found.is_patient) cause_ = health::OffsetCause::unknown, diagnosed_.reset();
  found.cause = cause_;
}

// Epipolar error (px) that the head's motion between the exposures of untriggered cameras explains. The
// motion is known from the second answer on.
double LostFace::allowed_px(const Found& found) {
  const auto before = std::exchange(before_, Before{found.camera_T_head, found.captured});
  if (found.face.identity.isLikelyPatient()) seen_ = before_;
  if (!before) return 0.0;
  const double since_s = std::abs(found.captured - before->captured);
  if (since_s < 1e-3 || since_s > kOneMotion_s) return 0.0;
  const Eigen::Vector3d& centre_mm = learnt_.model->centre_mm;
  const Eigen::Vector3d now_mm = found.camera_T_head * centre_mm;
  const double moved_mm = motionAcrossLines_mm(*learnt_.rig, before->camera_T_head * centre_mm, now_mm);
  const double px_per_mm = learnt_.rig->right.k(1, 1) / std::max(1.0, now_mm.z());
  return moved_mm / since_s * learnt_.late->mostLate_s() * px_per_mm;
}

/// Start of the next search: the last answer that found the face, if it is newer than the tracked pose. A
/// head that moves on while it is not sure enough to be shown stays in reach.
std::optional<Eigen::Isometry3d> LostFace::startAfter(const HeadMotion& last) const {
  if (seen_ && (!last.isKnown() || seen_->captured.s > last.captured().s)) return seen_->camera_T_head;
  return last.isKnown() ? std::optional(last.pose()) : std::nullopt;
}

void LostFace::ask(const cameras::StereoFrame& frame, const HeadMotion& last) {
  if (answers_.isBusy()) return;
  const double before_ms = processorTime_ms();
  auto question = std::make_shared<Question>();
  question->frame = frame;
  question->frame.left = frame.left.clone(), question->frame.right = frame.right.clone();
  question->last = startAfter(last), question->is_thorough = asked_++ % kThoroughEvery == 0,
  question->epoch = epoch_;
  question->is_diagnosed = !diagnosed_ || std::abs(frame.captured - *diagnosed_) > kDiagnosedFor_s;
  question->rig = *learnt_.rig;
  recovery_->moveRight(learnt_.rig->right_T_left);
  answers_.ask(std::move(question), frame.captured.s);
  if (pace_ != Pace::live) beside_ms_ += processorTime_ms() - before_ms;
}

// Keeps the found face as a key frame, unless it looks as in the reference.
void LostFace::remember(const Found& found) {
  const bool is_new = found.moment || found.face.identity.in_place_share < kKnownShare;
  if (answers_.isBusy() || !found.is_patient || !is_new) return;
  RecoveredFace face = found.face;
  face.pose.camera_T_head = found.camera_T_head;
  recovery_->remember(face, found.frame);
}

void LostFace::add(const std::vector<FaceKeyFrame>& keys) {
  FACENAV_EXPECT(!answers_.isBusy(), "key frames are added before anything is asked");
  for (const auto& key : keys) recovery_->add(key);
}

void LostFace::forget() {
  ++epoch_;
  is_to_forget_ = true;
}

bool LostFace::picturesKeepDetail() const { return keepsDetail(*learnt_.both_cameras); }

double LostFace::takeBeside_ms() { return std::exchange(beside_ms_, 0.0); }

}  // namespace facenav::head_tracking
