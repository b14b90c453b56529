#pragma once
// PreviewFrames: the pictures of a running live preview as a frame source for a task.

#include <chrono>
#include <memory>
#include <thread>

#include "facenav/capture/frame_source.h"
#include "facenav/capture/live_preview.h"

namespace facenav::ui {

/// Returns each picture once; skips pictures that arrived between calls. Ends if the cameras fail.
class PreviewFrames : public capture::FrameSource {
 public:
  PreviewFrames(const cameras::StereoRig& rig, std::shared_ptr<const capture::LivePreview> preview)
      : rig_(rig), preview_(std::move(preview)) {}
  const cameras::StereoRig& rig() const override { return rig_; }
  std::shared_ptr<const cameras::StereoFrame> next() override {
    constexpr double kGone_s = 3.0;  // time without a new picture
    while (preview_->failure().empty() && !preview_->hasEnded() && preview_->age_s() < kGone_s) {
      const auto frame = preview_->latest();
      if (frame && (!last_ || frame->number != last_->number)) return last_ = frame;
      std::this_thread::sleep_for(std::chrono::milliseconds(3));
    }
    return nullptr;
  }

 private:
  cameras::StereoRig rig_;
  std::shared_ptr<const capture::LivePreview> preview_;
  std::shared_ptr<const cameras::StereoFrame> last_;
};

}  // namespace facenav::ui
