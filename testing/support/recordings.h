#pragma once
// Small recordings for tests: noise images whose content identifies side and frame.

#include <filesystem>
#include <opencv2/core.hpp>

#include "facenav/capture/recording.h"
#include "support/stereo_rigs.h"

namespace facenav::testing {

inline cameras::StereoRig smallRig() {
  cameras::StereoRig rig = convergingRig();
  rig.width_px = 64;
  rig.height_px = 48;
  return rig;
}

inline cv::Mat noiseImage(int seed, int width_px = 64, int height_px = 48) {
  cv::Mat image(height_px, width_px, CV_8U);
  cv::RNG random(std::uint64_t(seed) * 7919 + 1);
  random.fill(image, cv::RNG::UNIFORM, 0, 256);
  return image;
}

inline cameras::StereoFrame noiseFrame(std::int64_t number, double t_s) {
  cameras::StereoFrame frame;
  frame.left = noiseImage(int(2 * number));
  frame.right = noiseImage(int(2 * number + 1));
  frame.number = number;
  frame.captured = {t_s};
  return frame;
}

/// Writes `count` frames starting at number `start`, 50 per second, with a capture pair.
inline void writeSmallRecording(const std::filesystem::path& folder, int count = 4, int start = 0) {
  capture::RecordingWriter writer(folder, smallRig());
  for (int i = 0; i < count; ++i) writer.add(noiseFrame(start + i, 0.02 * i));
  writer.setCapture({noiseFrame(500, 0), noiseFrame(600, 0)});
  writer.close();
}

}  // namespace facenav::testing
