#include "file_pair.h"

#include <algorithm>
#include <mutex>
#include <thread>

#include "recording_frames.h"

namespace facenav::capture {
namespace {

constexpr std::size_t kMostNamed = 10;    // numbers in one message
constexpr double kLongestPause_s = 1.0;   // a gap in the time stamps is not waited for longer
constexpr double kSamePicture = 0.5;      // share of an interval
constexpr double kDecodeWithin_s = 10.0;  // for one picture

/// One of the two files.
struct FileSide {
  std::unique_ptr<Camera> camera;
  double begun_s = 0.0;
  std::optional<CameraPicture> waiting;
  bool has_ended = false;
  std::int64_t read = 0;
  std::vector<std::int64_t> alone;  // numbers of the pictures without a partner
  std::int64_t paired_to = -1;      // number of the last picture with one

  double stamp_s() const { return waiting->captured.s - begun_s; }
  /// True if the file only goes on where the other one has ended.
  bool isLonger() const { return !alone.empty() && alone.front() > paired_to; }
  void leaveOut() {
    alone.push_back(waiting->sequence);
    waiting.reset();
  }
};

class FilePair : public CameraPairSource {
 public:
  FilePair(const cameras::StereoRig& rig, std::unique_ptr<Camera> left, std::unique_ptr<Camera> right,
           const PairSettings& settings);
  const cameras::StereoRig& rig() const override { return rig_; }
  std::shared_ptr<const cameras::StereoFrame> next() override;
  bool isFromFiles() const override { return true; }
  std::string missingPairs() const override;
  std::vector<std::string> cautions() const override;
  PairTiming timing() const override;
  PictureCounts leftCounts() const override { return countsOf(left_); }
  PictureCounts rightCounts() const override { return countsOf(right_); }
  CameraState leftState() const override { return left_.camera->state(); }
  CameraState rightState() const override { return right_.camera->state(); }

 private:
  PictureCounts countsOf(const FileSide& side) const {
    const std::lock_guard lock(mutex_);
    return side.camera->counts();
  }
  bool findPair();
  void waitFor(double stamp_s);

  const cameras::StereoRig rig_;
  mutable std::mutex mutex_;  // guards the members below against missingPairs() and timing()
  FileSide left_, right_;
  double interval_s_;
  PairTiming timing_;
  std::optional<double> last_stamp_s_;
  double returned_s_ = 0.0;
};

FileSide begun(std::unique_ptr<Camera> camera, CameraSettings settings, const cameras::StereoRig& rig) {
  settings.width_px = rig.width_px;
  settings.height_px = rig.height_px;
  settings.is_paced = false;
  camera->configure(settings);
  camera->start();
  FileSide side;
  side.camera = std::move(camera);
  return side;
}

FilePair::FilePair(const cameras::StereoRig& rig, std::unique_ptr<Camera> left, std::unique_ptr<Camera> right,
                   const PairSettings& settings)
    : rig_(rig),
      left_(begun(std::move(left), settings.left, rig)),
      right_(begun(std::move(right), settings.right, rig)) {
  const double rate_hz = std::max(left_.camera->state().frames_per_s, right_.camera->state().frames_per_s);
  interval_s_ = 1.0 / (rate_hz > 0 ? rate_hz : settings.left.frames_per_s);
}

/// Reads the next picture, unless one waits already or the file is at its end.
void readAhead(FileSide& side) {
  try {
    const double until_s = Timestamp::now().s + kDecodeWithin_s;
    while (!side.waiting && !side.has_ended && Timestamp::now().s < until_s)
      if (auto picture = side.camera->next(kDecodeWithin_s)) {
        if (side.read++ == 0) side.begun_s = picture->captured.s;
        side.waiting = std::move(picture);
      }
  } catch (const CameraError& error) {
    if (error.fault() != CameraFault::ended) throw;
    side.has_ended = true;
  }
}

/// Moves both files to the next pair; false at the end of both.
bool FilePair::findPair() {
  for (;;) {
    readAhead(left_);
    readAhead(right_);
    if (!left_.waiting && !right_.waiting) return false;
    const double late_s = !left_.waiting ? -1e9 : !right_.waiting ? 1e9 : right_.stamp_s() - left_.stamp_s();
    if (std::abs(late_s) <= kSamePicture * interval_s_) return true;
    (late_s > 0 ? left_ : right_).leaveOut();
  }
}

/// Waits as long as passed between the last pair and this one, less the time since next() returned.
void FilePair::waitFor(double stamp_s) {
  if (last_stamp_s_) {
    const double until_s = returned_s_ + std::min(stamp_s - *last_stamp_s_, kLongestPause_s);
    const double wait_s = until_s - Timestamp::now().s;
    if (wait_s > 0) std::this_thread::sleep_for(std::chrono::duration<double>(wait_s));
  }
  last_stamp_s_ = stamp_s;
  returned_s_ = Timestamp::now().s;
}

std::shared_ptr<const cameras::StereoFrame> FilePair::next() {
  auto frame = std::make_shared<cameras::StereoFrame>();
  double stamp_s = 0.0;
  {
    const std::lock_guard lock(mutex_);
    if (!findPair()) return nullptr;
    stamp_s = left_.stamp_s();
    frame->right_late_s = timing_.right_late_s = right_.stamp_s() - stamp_s;
    frame->captured = left_.waiting->captured;
    frame->number = left_.waiting->sequence;
    left_.paired_to = left_.waiting->sequence;
    right_.paired_to = right_.waiting->sequence;
    frame->left = left_.waiting->grey;
    frame->right = right_.waiting->grey;
    left_.waiting.reset();
    right_.waiting.reset();
    ++timing_.pairs;
  }
  waitFor(stamp_s);
  requireRigSize(rig_, frame->left, frame->right,
                 inWords(left_.camera->identity()) + "; " + inWords(right_.camera->identity()));
  return frame;
}

std::string namedPictures(const std::vector<std::int64_t>& numbers) {
  std::string words = numbers.size() == 1 ? "picture " : "pictures ";
  for (std::size_t i = 0; i < std::min(numbers.size(), kMostNamed); ++i)
    words += (i == 0 ? "" : ", ") + std::to_string(numbers[i]);
  if (numbers.size() > kMostNamed) words += " and " + std::to_string(numbers.size() - kMostNamed) + " more";
  return words;
}

std::string FilePair::missingPairs() const {
  const std::lock_guard lock(mutex_);
  const std::size_t missing = left_.alone.size() + right_.alone.size();
  if (missing == 0) return {};
  std::string words = missing == 1 ? "1 pair is missing" : std::to_string(missing) + " pairs are missing";
  if (!left_.alone.empty()) words += ": the right file has no partner for left " + namedPictures(left_.alone);
  if (!right_.alone.empty())
    words += std::string(left_.alone.empty() ? ":" : ";") + " the left file has no partner for right " +
             namedPictures(right_.alone);
  // Files without true time stamps show a picture lost in between only by their length.
  if ((left_.isLonger() && right_.has_ended) || (right_.isLonger() && left_.has_ended))
    words += "; one file is shorter: if it lacks a picture in between, later pairs are of two moments";
  return words;
}

std::vector<std::string> FilePair::cautions() const {
  const std::string missing = missingPairs();
  return missing.empty() ? std::vector<std::string>() : std::vector<std::string>{missing};
}

PairTiming FilePair::timing() const {
  const std::lock_guard lock(mutex_);
  PairTiming timing = timing_;
  timing.left_alone = std::int64_t(left_.alone.size());
  timing.right_alone = std::int64_t(right_.alone.size());
  return timing;
}

}  // namespace

std::unique_ptr<CameraPairSource> openFilePair(const cameras::StereoRig& rig, std::unique_ptr<Camera> left,
                                               std::unique_ptr<Camera> right, const PairSettings& settings) {
  return std::make_unique<FilePair>(rig, std::move(left), std::move(right), settings);
}

}  // namespace facenav::capture
