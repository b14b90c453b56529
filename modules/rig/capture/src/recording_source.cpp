#include "recording_frames.h"

namespace facenav::capture {
namespace {

class RecordingSource : public FrameSource {
 public:
  explicit RecordingSource(const Recording& recording)
      : rig_(recording.rig), frames_(openFrames(recording.folder)) {
    requireFrames(frames_, recording.folder);
  }
  const cameras::StereoRig& rig() const override { return rig_; }
  std::optional<std::int64_t> frameCount() const override { return std::int64_t(frames_.numbers.size()); }
  bool isFromFiles() const override { return true; }
  std::shared_ptr<const cameras::StereoFrame> next() override {
    auto pair = frames_.pairs->next();
    if (!pair) return nullptr;
    requireRigSize(rig_, pair->left, pair->right, pair->where);
    auto frame = std::make_shared<cameras::StereoFrame>();
    frame->left = pair->left;
    frame->right = pair->right;
    frame->number = frames_.numbers[at_];
    frame->captured = {frames_.times_s[at_]};
    frame->right_late_s = frames_.right_late_s[at_];
    ++at_;
    return frame;
  }

 private:
  cameras::StereoRig rig_;
  RecordingFrames frames_;
  std::size_t at_ = 0;
};

}  // namespace

std::unique_ptr<FrameSource> makeSource(const Recording& recording) {
  return std::make_unique<RecordingSource>(recording);
}

}  // namespace facenav::capture
