#pragma once
// Frames for the tests of InVesalius's relay, and waiting.

#include <functional>
#include <thread>

#include "facenav/links/live_output.h"

namespace facenav::links {

constexpr const char* kPosesTopic = "From Neuronavigation: Update tracker poses";
constexpr const char* kTargetTopic = "Neuronavigation to Robot: Set target";
constexpr const char* kNoTargetTopic = "Neuronavigation to Robot: Unset target";

inline std::shared_ptr<LiveFrame> guidedFrame(bool has_target = true, bool is_seen = true) {
  auto frame = std::make_shared<LiveFrame>();
  frame->utc = std::chrono::system_clock::now();
  frame->state = "adjust";
  const Eigen::Isometry3d pose(Eigen::Translation3d(1, 2, 600));
  frame->poses = {{"SubjectToTracker", pose}, {"Coil1ToTracker", pose}, {"SubjectToMri", pose}};
  if (has_target) frame->mri_T_target = pose;
  if (!is_seen) return std::make_shared<LiveFrame>(withoutPoses(*frame, "OUT_OF_VIEW"));
  return frame;
}

inline bool comesWithin(double limit_s, const std::function<bool()>& condition) {
  for (int i = 0; i < int(limit_s * 200) && !condition(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  return condition();
}

}  // namespace facenav::links
