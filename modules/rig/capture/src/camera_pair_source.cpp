#include "facenav/capture/camera_pair_source.h"

#include <condition_variable>
#include <mutex>

#include "camera_reader.h"
#include "facenav/core/number_text.h"
#include "file_pair.h"
#include "recording_frames.h"

namespace facenav::capture {
namespace {

constexpr double kNoteworthyDelay_s = 0.002;  // meanwhile a head turns by less than 0.1 deg

/// State of one side: arrival of its last picture, and the reason why no more come.
struct PairSide {
  double last_arrival_s = 0.0;
  std::exception_ptr failure;
};

class LivePair : public CameraPairSource {
 public:
  LivePair(const cameras::StereoRig& rig, std::unique_ptr<Camera> left, std::unique_ptr<Camera> right,
           const PairSettings& settings);
  const cameras::StereoRig& rig() const override { return rig_; }
  std::shared_ptr<const cameras::StereoFrame> next() override;
  std::vector<std::string> cautions() const override;
  PairTiming timing() const override;
  PictureCounts leftCounts() const override { return left_reader_->counts(); }
  PictureCounts rightCounts() const override { return right_reader_->counts(); }
  CameraState leftState() const override { return left_reader_->state(); }
  CameraState rightState() const override { return right_reader_->state(); }

 private:
  std::unique_ptr<CameraReader> read(std::unique_ptr<Camera> camera, PairSide& side,
                                     void (PictureMatcher::*add)(CameraPicture));
  std::optional<PicturePair> waitForPair();
  std::optional<PicturePair> newestPair();
  void requireBoth() const;
  void triggerBoth();
  [[noreturn]] void failSilent();

  const cameras::StereoRig rig_;
  const PairSettings settings_;
  mutable std::mutex mutex_;
  std::condition_variable arrived_;
  PictureMatcher matcher_;
  PairSide left_, right_;
  std::int64_t number_ = 0;
  double next_trigger_s_ = 0.0;
  std::unique_ptr<CameraReader> left_reader_, right_reader_;  // last: their threads use all of the above
};

CameraSettings sized(CameraSettings settings, const cameras::StereoRig& rig) {
  settings.width_px = rig.width_px;
  settings.height_px = rig.height_px;
  return settings;
}

LivePair::LivePair(const cameras::StereoRig& rig, std::unique_ptr<Camera> left, std::unique_ptr<Camera> right,
                   const PairSettings& settings)
    : rig_(rig), settings_(settings), matcher_(1.0 / settings.left.frames_per_s) {
  left->configure(sized(settings.left, rig));
  right->configure(sized(settings.right, rig));
  left->start();
  right->start();
  left_.last_arrival_s = right_.last_arrival_s = Timestamp::now().s;
  left_reader_ = read(std::move(left), left_, &PictureMatcher::addLeft);
  right_reader_ = read(std::move(right), right_, &PictureMatcher::addRight);
}

std::unique_ptr<CameraReader> LivePair::read(std::unique_ptr<Camera> camera, PairSide& side,
                                             void (PictureMatcher::*add)(CameraPicture)) {
  const auto deliver = [this, &side, add](CameraPicture picture) {
    const std::lock_guard lock(mutex_);
    side.last_arrival_s = Timestamp::now().s;
    (matcher_.*add)(std::move(picture));
    arrived_.notify_all();
  };
  const auto fail = [this, &side](std::exception_ptr failure) {
    const std::lock_guard lock(mutex_);
    side.failure = failure;
    arrived_.notify_all();
  };
  return std::make_unique<CameraReader>(std::move(camera), deliver, fail);
}

std::optional<PicturePair> LivePair::newestPair() {
  std::optional<PicturePair> newest;
  while (auto pair = matcher_.take()) newest = std::move(pair);
  return newest;
}

void LivePair::failSilent() {
  const double now_s = Timestamp::now().s;
  const bool is_left_silent = now_s - left_.last_arrival_s >= settings_.patience_s,
             is_right_silent = now_s - right_.last_arrival_s >= settings_.patience_s;
  const std::string left = inWords(left_reader_->identity()), right = inWords(right_reader_->identity());
  if (!is_left_silent && !is_right_silent)
    throw CameraError(CameraFault::hung, "the two cameras give no pictures of one moment",
                      left + "; " + right, "set both to the same rate and check their cables");
  throw CameraError(CameraFault::hung,
                    "the camera gives no new picture for " + formatted("%.1f", settings_.patience_s) + " s",
                    !is_right_silent  ? left
                    : !is_left_silent ? right
                                      : left + "; " + right,
                    "check the cable; then open the cameras again");
}

/// Triggers both cameras together, at the wanted rate.
void LivePair::triggerBoth() {
  if (settings_.left.trigger != Trigger::software || Timestamp::now().s < next_trigger_s_) return;
  next_trigger_s_ = Timestamp::now().s + 1.0 / settings_.left.frames_per_s;
  left_reader_->requestTrigger();
  right_reader_->requestTrigger();
}

void LivePair::requireBoth() const {
  for (const auto& failure : {left_.failure, right_.failure})
    if (failure) std::rethrow_exception(failure);
}

std::optional<PicturePair> LivePair::waitForPair() {
  std::unique_lock lock(mutex_);
  const double until_s = Timestamp::now().s + settings_.patience_s;
  while (Timestamp::now().s < until_s) {
    if (auto pair = newestPair()) return pair;
    requireBoth();
    triggerBoth();
    arrived_.wait_for(lock, std::chrono::milliseconds(10));
  }
  failSilent();
}

/// Next pair; null at the end of a file.
std::shared_ptr<const cameras::StereoFrame> LivePair::next() {
  std::optional<PicturePair> pair;
  try {
    pair = waitForPair();
  } catch (const CameraError& error) {
    if (error.fault() == CameraFault::ended) return nullptr;
    throw;
  }
  auto frame = std::make_shared<cameras::StereoFrame>();
  frame->right_late_s = pair->right_late_s();
  frame->captured = pair->left.captured;
  frame->left = std::move(pair->left.grey);
  frame->right = std::move(pair->right.grey);
  frame->number = number_++;
  requireRigSize(rig_, frame->left, frame->right,
                 inWords(left_reader_->identity()) + "; " + inWords(right_reader_->identity()));
  return frame;
}

std::vector<std::string> LivePair::cautions() const {
  std::vector<std::string> all;
  for (const auto& [side, state] :
       {std::pair("left camera, ", leftState()), std::pair("right camera, ", rightState())}) {
    for (const auto& words : unlockedInWords(state)) all.push_back(side + words);
    for (const auto& note : state.notes) all.push_back(side + note);
  }
  const PairTiming now = timing();
  if (std::abs(now.right_late_s) > kNoteworthyDelay_s)
    all.push_back(
        formatted("the right picture is taken %.1f ms %s the left one: the cameras have no common trigger",
                  1e3 * std::abs(now.right_late_s), now.right_late_s > 0 ? "after" : "before"));
  return all;
}

PairTiming LivePair::timing() const {
  const std::lock_guard lock(mutex_);
  return matcher_.timing();
}

}  // namespace

std::unique_ptr<CameraPairSource> openCameraPair(const cameras::StereoRig& rig, std::unique_ptr<Camera> left,
                                                 std::unique_ptr<Camera> right,
                                                 const PairSettings& settings) {
  if (isSameCamera(left->identity(), right->identity()))
    throw Error("left and right are the same camera", inWords(left->identity()),
                "choose two different cameras");
  if (left->isFromFiles() && right->isFromFiles())
    return openFilePair(rig, std::move(left), std::move(right), settings);
  return std::make_unique<LivePair>(rig, std::move(left), std::move(right), settings);
}

}  // namespace facenav::capture
