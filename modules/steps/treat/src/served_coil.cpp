#include "facenav/treat/served_coil.h"

#include "facenav/core/json_reader.h"
#include "facenav/geometry/json_transform.h"
#include "facenav/links/igtl_client.h"

namespace facenav::steps {
namespace {

class ServedCoilTracker : public coil_tracking::CoilTracker {
 public:
  ServedCoilTracker(const links::ServedPose& served, const Eigen::Isometry3d& camera_T_tracker)
      : client_(served.host, served.port), name_(served.name), camera_T_tracker_(camera_T_tracker) {}
  void start(const cameras::StereoRig&, const coil_tracking::CoilModel& coil) override {
    coil_T_marker_ = coil.markers.empty() ? RigidTransform<Coil, Marker>() : coil.marker_T_coil().inverse();
  }
  coil_tracking::CoilResult track(const cameras::StereoFrame&, const coil_tracking::CoilContext&) override {
    const auto tracker_T_coil = client_.pose(name_);
    if (!tracker_T_coil) return Lost{LostReason::no_marker};
    const auto camera_T_coil =
        RigidTransform<Camera, Coil>::fromIsometry(camera_T_tracker_ * *tracker_T_coil);
    coil_tracking::CoilPose pose;
    pose.camera_T_marker = camera_T_coil * coil_T_marker_;
    return Tracked<coil_tracking::CoilPose>(pose, 1.0);
  }

 private:
  links::IgtlClient client_;
  std::string name_;
  Eigen::Isometry3d camera_T_tracker_;
  RigidTransform<Coil, Marker> coil_T_marker_;
};

}  // namespace

Eigen::Isometry3d readTrackerPose(const std::filesystem::path& path) {
  const auto json = JsonReader::readFile(path);
  return readTransform<Camera, Camera>(json.at("camera_T_tracker")).isometry();
}

std::unique_ptr<coil_tracking::CoilTracker> makeServedCoilTracker(const std::string& words,
                                                                  const Eigen::Isometry3d& camera_T_tracker) {
  return std::make_unique<ServedCoilTracker>(links::servedPoseFrom(words), camera_T_tracker);
}

}  // namespace facenav::steps
