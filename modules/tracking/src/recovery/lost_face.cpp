#include "lost_face.h"

#include <cmath>

#include "facenav/core/processor_time.h"
#include "head/pose_fit.h"
#include "head/track_verdict.h"

namespace facenav::tracking {
namespace {

constexpr double kAnswer_s = 0.1;     // a live answer's time, on one core of a small machine
constexpr double kOneMotion_s = 0.5;  // between two answers that tell how fast the head moves
constexpr double kJitter_mm = 0.5;    // of two answers about a head at rest: no motion
constexpr int kThoroughEvery = 4;     // questions: a face at any roll takes ten times longer to look for
constexpr int kMostSteps = 12, kFirstLevel = 1;
// Patches whose errors are those expected, in place of several times as large, show skin that has not moved:
// then they are the more exact. 0.6 to 1.5 in the room, 3 to 5 on a real face with another expression.
constexpr double kAsExpected = 2.0;
// Of the windows on skin that hardly moves, in their place: with fewer the face may be the patient's, but
// skin and hair have moved so far that the pose is not sure. 0.50 and more on one real person (60 returns);
// 0.39 in a room's moment whose pose was 3.8 mm off. Fitted on these.
constexpr double kLeastShare = 0.45;
// Where even the patches' errors are so many times those expected, skin and hair have moved too far for any
// pose: 6.5 at most on one real person (40 returns), 7.6 and more in the same moment of the room. Fitted on
// these.
constexpr double kTooFarOff = 7.0;
// On the variance of patches that the skin's motion pulls along. The room's grimaces want less, a real
// person's more: chosen by how two pairs of cameras agree on one person.
constexpr double kPatchDoubt = 4.0;
constexpr double kKnownLook = 0.8;     // share of the windows in place: 0.6-0.8 with another expression
constexpr double kSamePlace_mm = 3.0;  // of the face, all the same
// Agreement of both cameras on fine detail: 0.73 and more in uncompressed pictures of the room, 0.35 to 0.6
// in strongly compressed photographs.
constexpr double kDetailKept = 0.73;
// Agreement with the reference by that of both cameras, mean and standard deviation: the room's table in
// skin_detail.h (24 poses of patients, 24 of others).
constexpr double kOwnDetail = 0.91, kOwnSigma = 0.15, kOtherDetail = 0.14, kOtherSigma = 0.13;

struct Estimate {
  Eigen::Isometry3d camera_T_head;
  Matrix6d covariance;  // of (w rad, v mm) about the face's centre, Camera's axes
};

// Two estimates of one pose, each by its covariance; the other lies `off` from the first.
Estimate fused(const Estimate& first, const Vector6d& off, const Matrix6d& other,
               const Eigen::Vector3d& centre_mm) {
  const Matrix6d gain = first.covariance * (first.covariance + other).inverse();
  const Vector6d step = gain * off;
  Estimate result{first.camera_T_head, first.covariance - gain * first.covariance};
  result.camera_T_head.linear() = expRotation(step.head<3>()) * first.camera_T_head.linear();
  result.camera_T_head.translation() =
      first.camera_T_head * centre_mm + step.tail<3>() - result.camera_T_head.linear() * centre_mm;
  return result;
}

// Where the pictures keep the skin's fine detail (both cameras agree on it), it speaks, too. Compressed
// pictures hold none: both cameras then agree by half, and it says nothing.
double evidenceOf(const DetailAgreement& seen, const DetailAgreement& of_both_cameras) {
  if (of_both_cameras.value() < kDetailKept) return 0.0;
  const double share = seen.value() / of_both_cameras.value();
  const auto logNormal = [](double z, double sigma) { return -0.5 * z * z - std::log(sigma); };
  const double own_sigma = std::hypot(kOwnSigma, seen.sigma()),
               other_sigma = std::hypot(kOtherSigma, seen.sigma());
  return logNormal((std::min(share, kOwnDetail) - kOwnDetail) / own_sigma, own_sigma) -
         logNormal((std::max(share, kOtherDetail) - kOtherDetail) / other_sigma, other_sigma);
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
  found.is_patient =
      face->identity.verdict() == Identity::Verdict::patient && face->sides == SidesVerdict::agree;
  found.is_out_of_step = face->sides == SidesVerdict::out_of_step || face->lines.isClearlyOutOfStep();
  found.is_other =
      face->identity.verdict() == Identity::Verdict::other && face->is_face_seen && !found.is_out_of_step;
  found.camera_T_head = face->pose.camera_T_head;
  found.face = std::move(*face);
  if (!found.is_patient) return found;
  found.frame = question.frame;
  const PatchModel& model = *learnt.model;
  const std::array<ImagePyramid, 2> now = {ImagePyramid(question.frame.left),
                                           ImagePyramid(question.frame.right)};
  const PoseFit fit =
      fitPose(*learnt.rig, model, model.level, now, found.camera_T_head, kFirstLevel, {}, 0, kMostSteps);
  const DetailAgreement detail = detailAgreement(*learnt.rig, model, model.level[0], now, fit);
  Identity& identity = found.face.identity;
  identity.log_likelihood_ratio += evidenceOf(detail, *learnt.both_cameras);
  found.is_patient = identity.verdict() == Identity::Verdict::patient;
  found.is_other = identity.verdict() == Identity::Verdict::other;
  found.is_patient &= identity.looks_share > kLeastShare;
  if (!found.is_patient) return found;
  const Matrix6d covariance = recovery.carried(found.face.pose, found.face.pose.covariance, model.centre_mm);
  Vector6d off;
  off << logRotation(fit.motion.linear() * found.camera_T_head.linear().transpose()),
      fit.motion * model.centre_mm - found.camera_T_head * model.centre_mm;
  const Verdict verdict = judge(model, fit);
  found.is_patient = fit.scale < kTooFarOff;
  if (!found.is_patient) return found;
  const bool does_serve = fit.scale < kAsExpected && off.tail<3>().norm() < kSamePlace_mm;
  if (does_serve && verdict.isTracked() && whoseSkin(detail, *learnt.both_cameras) == Whose::patients) {
    found.camera_T_head = fit.motion;
    return found;
  }
  Estimate estimate{found.camera_T_head, covariance};
  if (verdict.isTracked() && off.tail<3>().norm() < kSamePlace_mm)
    estimate = fused(estimate, off, kPatchDoubt * verdict.covariance, model.centre_mm);
  found.camera_T_head = estimate.camera_T_head;
  const Matrix6d skin = recovery.carried(found.face.pose, found.face.pose.skin_covariance, model.centre_mm);
  found.moment = KeyFrames::ofMoment(*learnt.rig, model, question.frame, estimate.camera_T_head,
                                     estimate.covariance, skin);
  found.is_patient = found.moment.has_value();
  return found;
}

std::optional<LostFace::Found> LostFace::take(Timestamp now) {
  auto found = answers_.take(now.s);
  if (is_to_forget_ && !answers_.isBusy()) recovery_->forgetRemembered(), is_to_forget_ = false;
  if (!found || found->epoch != epoch_) return std::nullopt;
  const bool is_own_face = found->face.identity.verdict() == Identity::Verdict::patient;
  if (is_own_face && found->face.lines.isOutOfStep(allowed_px(*found)))
    found->is_patient = false, found->is_out_of_step = true, found->moment.reset();
  return found;
}

// How far untriggered cameras may put the face off its epipolar lines: by its motion between the exposures.
// The motion is known from the second answer on.
double LostFace::allowed_px(const Found& found) {
  const auto before = std::exchange(before_, Before{found.camera_T_head, found.captured});
  if (!before) return 0.0;
  const double since_s = std::abs(found.captured - before->captured);
  if (since_s < 1e-3 || since_s > kOneMotion_s) return 0.0;
  const Eigen::Vector3d& centre_mm = learnt_.model->centre_mm;
  const Eigen::Vector3d now_mm = found.camera_T_head * centre_mm;
  const double moved_mm = std::max(0.0, (now_mm - before->camera_T_head * centre_mm).norm() - kJitter_mm);
  const double px_per_mm = learnt_.rig->right.k(1, 1) / std::max(1.0, now_mm.z());
  return moved_mm / since_s * learnt_.late->mostLate_s() * px_per_mm;
}

void LostFace::ask(const stereo::StereoFrame& frame, const std::optional<Eigen::Isometry3d>& last) {
  if (answers_.isBusy()) return;
  const double before_ms = processorTime_ms();
  auto question = std::make_shared<Question>();
  question->frame = frame;
  question->frame.left = frame.left.clone(), question->frame.right = frame.right.clone();
  question->last = last, question->is_thorough = asked_++ % kThoroughEvery == 0, question->epoch = epoch_;
  answers_.ask(std::move(question), frame.captured.s);
  if (pace_ != Pace::live) beside_ms_ += processorTime_ms() - before_ms;
}

// A look that the reference shows already is not worth a place.
void LostFace::remember(const Found& found) {
  const bool is_new = found.moment || found.face.identity.looks_share < kKnownLook;
  if (answers_.isBusy() || !found.is_patient || !is_new) return;
  RecoveredFace face = found.face;
  face.pose.camera_T_head = found.camera_T_head;
  recovery_->remember(face, found.frame);
}

void LostFace::add(const std::vector<FaceLook>& looks) {
  FACENAV_EXPECT(!answers_.isBusy(), "looks are added before anything is asked");
  for (const auto& look : looks) recovery_->add(look);
}

void LostFace::forget() {
  ++epoch_;
  is_to_forget_ = true;
}

bool LostFace::picturesKeepDetail() const { return learnt_.both_cameras->value() >= kDetailKept; }

double LostFace::takeBeside_ms() { return std::exchange(beside_ms_, 0.0); }

}  // namespace facenav::tracking
