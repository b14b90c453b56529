#include "facenav/treat/served_tracker.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "facenav/core/error.h"
#include "facenav/core/json_reader.h"
#include "facenav/core/log.h"
#include "facenav/geometry/json_transform.h"
#include "facenav/links/igtl_client.h"

namespace facenav::steps {
namespace {

// No coil lies nearer to a tracker's origin. A pose in metres does.
constexpr double kNearestCoil_mm = 5.0;

/// Readings of one server, taken once a frame for all trackers.
class ServedTools {
 public:
  ServedTools(const links::ServedPose& server, std::vector<std::string> names)
      : client_(server.host, server.port), names_(std::move(names)), told_(names_.size()) {}

  /// Reading of a tool for this frame. A new fault is logged.
  const links::IgtlReading& at(std::int64_t frame, std::size_t tool) {
    if (frame != frame_ || names_.size() == 1) readings_ = client_.read(names_);
    frame_ = frame;
    auto& reading = readings_[tool];
    if (reading.fault != told_[tool]) {
      told_[tool] = reading.fault;
      if (!reading.fault.empty()) logWarning("tracker: the pose " + names_[tool] + ": " + reading.fault);
    }
    return reading;
  }
  /// Refuses a tool's pose of this frame for a reason that the client does not know.
  void refuse(std::size_t tool, const std::string& fault) {
    readings_[tool].pose.reset();
    readings_[tool].fault = fault;
    if (fault == told_[tool]) return;
    told_[tool] = fault;
    logWarning("tracker: the pose " + names_[tool] + ": " + fault);
  }

 private:
  links::IgtlClient client_;
  std::vector<std::string> names_, told_;
  std::vector<links::IgtlReading> readings_;
  std::int64_t frame_ = -1;
};

class ServedCoilTracker : public coil_tracking::CoilTracker {
 public:
  ServedCoilTracker(std::shared_ptr<ServedTools> tools, std::size_t tool,
                    const Eigen::Isometry3d& camera_T_tracker)
      : tools_(std::move(tools)), tool_(tool), camera_T_tracker_(camera_T_tracker) {}
  void start(const cameras::StereoRig&, const coil_tracking::CoilModel& coil) override {
    coil_T_marker_ = coil.markers.empty() ? RigidTransform<Coil, Marker>() : coil.marker_T_coil().inverse();
  }
  coil_tracking::CoilResult track(const cameras::StereoFrame& frame,
                                  const coil_tracking::CoilContext&) override {
    const auto tracker_T_coil = tools_->at(frame.number, tool_).pose;
    if (!tracker_T_coil) return Lost{LostReason::no_marker};
    if (tracker_T_coil->translation().norm() < kNearestCoil_mm) {
      tools_->refuse(tool_, "lies within 5 mm of the tracker's origin: are its lengths metres?");
      return Lost{LostReason::no_marker};
    }
    const auto camera_T_coil =
        RigidTransform<Camera, Coil>::fromIsometry(camera_T_tracker_ * *tracker_T_coil);
    coil_tracking::CoilPose pose;
    pose.camera_T_marker = camera_T_coil * coil_T_marker_;
    return Tracked<coil_tracking::CoilPose>(pose, 1.0);
  }

 private:
  std::shared_ptr<ServedTools> tools_;
  std::size_t tool_;
  Eigen::Isometry3d camera_T_tracker_;
  RigidTransform<Coil, Marker> coil_T_marker_;
};

class ServedHeadTracker : public head_tracking::HeadTracker {
 public:
  explicit ServedHeadTracker(std::shared_ptr<ServedTools> tools) : tools_(std::move(tools)) {}
  void start(const cameras::StereoRig&, const head_tracking::HeadReference&, head_tracking::Pace) override {}
  head_tracking::HeadResult track(const cameras::StereoFrame& frame,
                                  const head_tracking::HeadContext&) override {
    const auto& tracker_T_head = tools_->at(frame.number, 1).pose;
    if (!tracker_T_head) return Lost{LostReason::no_face};
    head_tracking::HeadPose pose;
    pose.camera_T_head = RigidTransform<Camera, Head>::fromIsometry(*tracker_T_head);
    pose.face_centre = Point<Camera>(tracker_T_head->translation());
    return Tracked<head_tracking::HeadPose>(pose, 1.0);
  }

 private:
  std::shared_ptr<ServedTools> tools_;
};

class FramesWithoutPictures : public capture::FrameSource {
 public:
  FramesWithoutPictures() : next_(std::chrono::steady_clock::now()) {
    constexpr double kSize_px = 16;  // what the session's own checks of a frame need
    rig_.width_px = rig_.height_px = int(kSize_px);
    rig_.left.k = rig_.right.k = cv::Matx33d(kSize_px, 0, kSize_px / 2, 0, kSize_px, kSize_px / 2, 0, 0, 1);
    rig_.right_T_left = {Eigen::Quaterniond::Identity(), {-100, 0, 0}};
  }
  const cameras::StereoRig& rig() const override { return rig_; }
  std::shared_ptr<const cameras::StereoFrame> next() override {
    constexpr std::chrono::microseconds kPeriod(16667);
    next_ = std::max(next_ + kPeriod, std::chrono::steady_clock::now());
    std::this_thread::sleep_until(next_);
    auto frame = std::make_shared<cameras::StereoFrame>();
    frame->left = frame->right = cv::Mat::zeros(rig_.height_px, rig_.width_px, CV_8UC1);
    frame->number = number_++;
    frame->captured = Timestamp::now();
    return frame;
  }

 private:
  cameras::StereoRig rig_;
  std::chrono::steady_clock::time_point next_;
  std::int64_t number_ = 0;
};

}  // namespace

Eigen::Isometry3d readTrackerPose(const std::filesystem::path& path) {
  const auto json = JsonReader::readFile(path);
  return readTransform<Camera, Camera>(json.at("camera_T_tracker")).isometry();
}

std::unique_ptr<coil_tracking::CoilTracker> makeServedCoilTracker(const std::string& words,
                                                                  const Eigen::Isometry3d& camera_T_tracker) {
  const auto served = links::servedPoseFrom(words);
  const auto tools = std::make_shared<ServedTools>(served, std::vector<std::string>{served.name});
  return std::make_unique<ServedCoilTracker>(tools, 0, camera_T_tracker);
}

ServedTrackers makeServedTrackers(const std::string& words, const std::string& head,
                                  const std::string& second_coil) {
  const auto served = links::servedPoseFrom(words);
  if (served.name == head || second_coil == head || second_coil == served.name)
    throw Error("two tools have the same name at the tracker", words, "name the pose of each");
  std::vector<std::string> names{served.name, head};
  if (!second_coil.empty()) names.push_back(second_coil);
  const auto tools = std::make_shared<ServedTools>(served, names);
  const auto coil = [&](std::size_t tool) {
    return std::make_unique<ServedCoilTracker>(tools, tool, Eigen::Isometry3d::Identity());
  };
  return {std::make_unique<ServedHeadTracker>(tools), coil(0), second_coil.empty() ? nullptr : coil(2)};
}

std::unique_ptr<capture::FrameSource> makeFramesWithoutPictures() {
  return std::make_unique<FramesWithoutPictures>();
}

}  // namespace facenav::steps
