#include "facenav/capture/recording_pictures.h"

#include <algorithm>

#include "recording_frames.h"

namespace facenav::capture {

struct RecordingPictures::Implementation {
  Recording recording;
  RecordingFrames frames;
};

RecordingPictures::RecordingPictures(const std::filesystem::path& recording)
    : implementation_(std::make_unique<Implementation>()) {
  implementation_->recording = openRecording(recording);
  implementation_->frames = openFrames(recording);
  requireFrames(implementation_->frames, recording);
}

RecordingPictures::~RecordingPictures() = default;
RecordingPictures::RecordingPictures(RecordingPictures&&) noexcept = default;
RecordingPictures& RecordingPictures::operator=(RecordingPictures&&) noexcept = default;

const cameras::StereoRig& RecordingPictures::rig() const { return implementation_->recording.rig; }

const std::vector<std::int64_t>& RecordingPictures::numbers() const {
  return implementation_->frames.numbers;
}
const std::vector<double>& RecordingPictures::times_s() const { return implementation_->frames.times_s; }

std::shared_ptr<const cameras::StereoFrame> RecordingPictures::frame(std::int64_t number) {
  auto& frames = implementation_->frames;
  const auto found = std::lower_bound(frames.numbers.begin(), frames.numbers.end(), number);
  if (found == frames.numbers.end() || *found != number) return nullptr;
  const auto index = std::size_t(found - frames.numbers.begin());
  frames.pairs->goTo(index);
  auto pair = frames.pairs->next();
  if (!pair) return nullptr;
  requireRigSize(implementation_->recording.rig, pair->left, pair->right, pair->where);
  auto frame = std::make_shared<cameras::StereoFrame>();
  frame->left = std::move(pair->left);
  frame->right = std::move(pair->right);
  frame->number = number;
  frame->captured = {frames.times_s[index]};
  return frame;
}

}  // namespace facenav::capture
