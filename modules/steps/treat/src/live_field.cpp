#include "facenav/treat/live_field.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "facenav/core/later_answer.h"
#include "facenav/efield/coil_file.h"
#include "facenav/geometry/rotation.h"
#include "facenav/session/session.h"

namespace facenav::steps {
namespace {

constexpr double kSigmas95 = 1.96;              // of a normal distribution: 95 %
constexpr std::chrono::milliseconds kWait(20);  // for a state, before other wishes are looked at again

/// Bound of the worst axis of a 3 x 3 covariance.
double worst95(const Eigen::Matrix3d& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
  return kSigmas95 * std::sqrt(std::max(0.0, solver.eigenvalues().maxCoeff()));
}

bool isSameTarget(const guidance::Target& a, const guidance::Target& b) {
  return a.name == b.name && a.cortex_point.mm == b.cortex_point.mm &&
         a.mri_T_target.translation_mm() == b.mri_T_target.translation_mm() &&
         a.mri_T_target.rotation() == b.mri_T_target.rotation();
}

bool isOfTarget(const LiveField& field, const session::NavigationState& now) {
  if (!now.chosen || !field.target) return !now.chosen && !field.target;
  return isSameTarget(*field.target, now.chosen->target);
}

/// A subject with what is read and found once for it.
struct ReadSubject {
  explicit ReadSubject(const LiveFieldSubject& subject)
      : fields(std::make_shared<const ReadHead>(subject.store), efield::fieldCoil(subject.coil).dipoles),
        threshold(subject.threshold) {
    if (subject.drawn) nearest = fields.nearestPlaces(subject.drawn->vertices_mm);
  }
  PoseFields fields;
  std::optional<HotspotThreshold> threshold;
  std::vector<Eigen::Index> nearest;  // place of each drawn vertex
};

PlannedStrength plannedOf(const ReadSubject& read, const guidance::Target& target) {
  PlannedStrength result{target};
  result.at_target = *read.fields.at(coilPoseOf(target), target.cortex_point).at_target;
  if (read.threshold)
    result.dose = thresholdDose(read.fields.head(), read.fields.coil(), *read.threshold, result.at_target);
  return result;
}

std::shared_ptr<LiveField> fieldOf(const ReadSubject& read, const LivePose& pose) {
  const auto target = pose.target ? std::optional(pose.target->cortex_point) : std::nullopt;
  const auto computed = read.fields.at(pose.mri_T_coil, target);
  auto field = std::make_shared<LiveField>();
  field->frame = pose.frame;
  field->arrived = pose.arrived;
  field->tier = read.fields.tier();
  field->usual_error = computed.usual_error;
  field->peak = computed.peak;
  field->peak_place = computed.peak_place;
  field->largest_didt_A_per_us = read.fields.coil().largest_didt_A_per_us;
  field->strength.reserve(read.nearest.size());
  for (const Eigen::Index place : read.nearest) field->strength.push_back(computed.strength[place]);
  if (!target) return field;
  field->target = pose.target;
  field->at_target = computed.at_target;
  field->range =
      read.fields.rangeAt(pose.mri_T_coil, *target, *computed.at_target, computed.usual_error, pose.bound);
  return field;
}

}  // namespace

std::optional<LivePose> livePose(const session::NavigationState& state) {
  if (!state.camera_T_mri || !state.camera_T_coil || !state.coil || state.withheld) return std::nullopt;
  LivePose pose{state.frame, state.arrived, state.camera_T_mri->inverse() * *state.camera_T_coil};
  double alignment_bound_mm = 0;
  if (state.chosen) {
    pose.target = state.chosen->target;
    alignment_bound_mm = state.chosen->error_bound_mm;
  }
  const auto& covariance = state.coil->covariance;
  pose.bound.mm = std::hypot(alignment_bound_mm, worst95(covariance.bottomRightCorner<3, 3>()));
  pose.bound.deg = worst95(covariance.topLeftCorner<3, 3>()) * kDegPerRad;
  return pose;
}

bool mayBeShown(const LiveField& field, const session::NavigationState& now) {
  static const double kMostBehind_s = session::SessionOptions().age_limit_s;  // same limit as for poses
  const double behind_s = now.arrived - field.arrived;
  return now.camera_T_mri && now.camera_T_coil && !now.withheld && std::abs(behind_s) <= kMostBehind_s &&
         isOfTarget(field, now);
}

double ofThreshold_pct(const LiveField& field, double output_pct, const ThresholdDose& dose) {
  return 100 * field.at_target.value_or(0) * output_pct / (dose.at_hotspot * dose.threshold_pct);
}

struct LiveFieldWorker::Implementation {
  using States = std::shared_ptr<const LatestValue<session::NavigationState>>;
  std::function<void()> done;
  mutable std::mutex mutex;  // guards the members below; never held while a field is computed
  std::condition_variable changed;
  std::optional<LiveFieldSubject> subject;
  States states;
  std::optional<guidance::Target> target, wanted_target;  // the newest one; the one still to compute
  int wish = 0, states_wish = 0;                          // counts subjects; states that were followed
  std::shared_ptr<const LiveField> field;
  std::shared_ptr<const PlannedStrength> planned;
  std::string failure;
  int computed = 0;
  bool is_unreadable = false, is_stopping = false;  // is_unreadable: the subject cannot be read
  std::thread thread;

  struct Work {
    std::optional<LiveFieldSubject> to_read;
    std::optional<LivePose> pose;
    std::optional<guidance::Target> target;
    int wish = 0, states_wish = 0;
  };
  int read_wish = 0, seen_wish = 0;         // used only by the thread, with the next two
  std::shared_ptr<const ReadSubject> read;  // null: none, or it failed
  std::shared_ptr<const session::NavigationState> seen;

  void run();
  std::optional<Work> next();
  std::optional<LivePose> newerPose(std::unique_lock<std::mutex>& lock);
  void wantPlanned(const guidance::Target& newest);
  void compute(const Work& work);
};

void LiveFieldWorker::Implementation::wantPlanned(const guidance::Target& newest) {
  if (target && isSameTarget(*target, newest)) return;
  target = wanted_target = newest;
  planned.reset();
}

/// Waits a short time for a state that was not seen; unlocks meanwhile. Nothing: none came, it is of no use
/// any more, or it has no pose; then there is no field either.
std::optional<LivePose> LiveFieldWorker::Implementation::newerPose(std::unique_lock<std::mutex>& lock) {
  if (seen_wish != states_wish) seen.reset();
  seen_wish = states_wish;
  const int wish_before = wish;
  const States followed = states;
  lock.unlock();
  const auto state = followed->newerThan(seen, kWait);
  lock.lock();
  if (!state || is_stopping || wish != wish_before || states_wish != seen_wish) return std::nullopt;
  seen = state;
  auto pose = livePose(*state);
  if (!pose) field.reset();
  return pose;
}

/// Waits for work; nothing: the end.
std::optional<LiveFieldWorker::Implementation::Work> LiveFieldWorker::Implementation::next() {
  std::unique_lock lock(mutex);
  const auto is_readable = [this] { return subject && !is_unreadable; };
  for (;;) {
    if (!states) seen.reset();
    changed.wait(lock, [&] {
      return is_stopping || wish != read_wish || (is_readable() && (states || wanted_target));
    });
    if (is_stopping) return std::nullopt;
    Work work;
    if (wish != read_wish) {
      seen.reset();  // its field is wanted of the new subject as well
      work.to_read = subject;
    } else {
      if (states) work.pose = newerPose(lock);
      if (is_stopping) return std::nullopt;
      if (wish != read_wish) continue;
      if (work.pose && work.pose->target) wantPlanned(*work.pose->target);
      work.target.swap(wanted_target);
      if (!work.pose && !work.target) continue;
    }
    work.wish = wish;
    work.states_wish = states_wish;
    return work;
  }
}

void LiveFieldWorker::Implementation::compute(const Work& work) {
  if (work.wish != read_wish) {
    read.reset();
    read_wish = work.wish;
    if (work.to_read) read = std::make_shared<const ReadSubject>(*work.to_read);
    return;
  }
  if (!read) return;
  if (work.target) {
    const auto plan = std::make_shared<const PlannedStrength>(plannedOf(*read, *work.target));
    const std::lock_guard lock(mutex);
    if (work.wish == wish) planned = plan;
  }
  if (!work.pose) return;
  const auto made = fieldOf(*read, *work.pose);
  const std::lock_guard lock(mutex);
  ++computed;
  if (work.wish != wish || work.states_wish != states_wish) return;  // of another case, or no longer wanted
  if (planned && work.pose->target && isSameTarget(planned->target, *work.pose->target))
    made->planned = planned->at_target;
  field = made;
  failure.clear();
}

// Catches all failures, because one on this thread must not end the program.
void LiveFieldWorker::Implementation::run() {
  runInBackground();
  while (const auto work = next()) {
    try {
      compute(*work);
    } catch (const std::exception& error) {
      const std::lock_guard lock(mutex);
      if (work->wish != wish) continue;
      failure = error.what();
      field.reset();
      is_unreadable = read == nullptr;
    }
    if (done) done();
  }
}

LiveFieldWorker::LiveFieldWorker(std::function<void()> done)
    : implementation_(std::make_unique<Implementation>()) {
  implementation_->done = std::move(done);
  implementation_->thread = std::thread([i = implementation_.get()] { i->run(); });
}

LiveFieldWorker::~LiveFieldWorker() {
  {
    const std::lock_guard lock(implementation_->mutex);
    implementation_->is_stopping = true;
  }
  implementation_->changed.notify_all();
  implementation_->thread.join();
}

void LiveFieldWorker::use(std::optional<LiveFieldSubject> subject) {
  auto& i = *implementation_;
  {
    const std::lock_guard lock(i.mutex);
    i.subject = std::move(subject);
    ++i.wish;
    i.field.reset();
    i.planned.reset();
    i.failure.clear();
    i.is_unreadable = false;
    i.wanted_target = i.target;
  }
  i.changed.notify_all();
}

void LiveFieldWorker::plan(const guidance::Target& target) {
  {
    const std::lock_guard lock(implementation_->mutex);
    implementation_->wantPlanned(target);
  }
  implementation_->changed.notify_all();
}

void LiveFieldWorker::follow(std::shared_ptr<const LatestValue<session::NavigationState>> states) {
  auto& i = *implementation_;
  {
    const std::lock_guard lock(i.mutex);
    if (i.states == states) return;
    i.states = std::move(states);
    ++i.states_wish;
    i.field.reset();
  }
  i.changed.notify_all();
}

std::shared_ptr<const LiveField> LiveFieldWorker::latest() const {
  const std::lock_guard lock(implementation_->mutex);
  return implementation_->field;
}

std::shared_ptr<const PlannedStrength> LiveFieldWorker::planned() const {
  const std::lock_guard lock(implementation_->mutex);
  return implementation_->planned;
}

std::string LiveFieldWorker::failure() const {
  const std::lock_guard lock(implementation_->mutex);
  return implementation_->failure;
}

int LiveFieldWorker::computed() const {
  const std::lock_guard lock(implementation_->mutex);
  return implementation_->computed;
}

}  // namespace facenav::steps
