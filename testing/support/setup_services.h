#pragma once
// Services of the window with two cameras that see the set-up's room, and a store of rigs in memory.

#include <memory>
#include <vector>

#include "shell/services.h"
#include "support/setup_room.h"

namespace facenav::testing {

inline ui::Services setupServices(std::shared_ptr<SetupRoom> room,
                                  std::shared_ptr<std::vector<capture::RigEntry>> rigs) {
  ui::Services services;
  services.listCameras = [](capture::Search) {
    std::vector<capture::FoundCamera> found(2);
    found[0].identity = {"v4l2", "/dev/video0", "Webcam", "A", "1-1"};
    found[1].identity = {"v4l2", "/dev/video2", "Webcam", "B", "1-2"};
    return found;
  };
  services.openNewCameras = [room](const std::string&, const std::string&, int, int) {
    ui::NewCameras cameras{
        std::make_unique<SetupRoomSource>(room, coil_tracking::testing::roomRig()), {}, {}};
    cameras.left.identity = {"v4l2", "/dev/video0", "Webcam", "A", "1-1"};
    cameras.right.identity = {"v4l2", "/dev/video2", "Webcam", "B", "1-2"};
    return cameras;
  };
  services.listRigs = [rigs] { return *rigs; };
  services.keepRig = [rigs](const capture::NamedRig& rig, Existing) {
    *rigs = {{rig.name, "/rigs/" + rig.name, rig, ""}};
  };
  services.noteRig = [](const std::string&, const capture::RigCheckNote&) {};
  services.keepLearnt = [](const std::string&, const steps::CamerasLearnt&) {};
  services.makeSetupMethods = [] { return setupMethods(); };
  return services;
}

}  // namespace facenav::testing
