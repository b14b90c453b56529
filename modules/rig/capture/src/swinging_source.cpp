#include "facenav/capture/swinging_source.h"

#include <cmath>

#include "facenav/capture/recording_pictures.h"

namespace facenav::capture {
namespace {

class SwingingSource : public FrameSource {
 public:
  SwingingSource(const Recording& recording, int passes)
      : rig_(recording.rig), pictures_(recording.folder), last_(lastFrame(passes)) {}
  const cameras::StereoRig& rig() const override { return rig_; }
  std::optional<std::int64_t> frameCount() const override {
    return last_ ? std::optional(*last_ + 1) : std::nullopt;
  }

  std::shared_ptr<const cameras::StereoFrame> next() override {
    if (last_ && number_ > *last_) return nullptr;
    const auto at = std::size_t(swungFrame(number_, std::int64_t(pictures_.numbers().size())));
    const double t_s = pictures_.times_s()[at];
    time_s_ = number_ == 0 ? t_s : time_s_ + std::abs(t_s - before_s_);
    before_s_ = t_s;
    const auto picture = pictures_.frame(pictures_.numbers()[at]);
    if (!picture) return nullptr;
    auto frame = std::make_shared<cameras::StereoFrame>(*picture);
    frame->number = number_++;
    frame->captured = {time_s_};
    return frame;
  }

 private:
  std::optional<std::int64_t> lastFrame(int passes) const {
    const auto steps = std::int64_t(pictures_.numbers().size()) - 1;
    if (passes <= 0) return std::nullopt;
    return steps * passes;
  }

  cameras::StereoRig rig_;
  RecordingPictures pictures_;
  std::optional<std::int64_t> last_;  // nullopt: without end
  std::int64_t number_ = 0;
  double time_s_ = 0, before_s_ = 0;
};

}  // namespace

std::int64_t swungFrame(std::int64_t number, std::int64_t frames_of_recording) {
  if (frames_of_recording < 2) return 0;
  const std::int64_t steps = frames_of_recording - 1, in_swing = number % (2 * steps);
  return in_swing <= steps ? in_swing : 2 * steps - in_swing;
}

std::unique_ptr<FrameSource> makeSwingingSource(const Recording& recording, int passes) {
  return std::make_unique<SwingingSource>(recording, passes);
}

}  // namespace facenav::capture
