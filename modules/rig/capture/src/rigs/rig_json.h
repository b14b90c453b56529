#pragma once
// rig.json <-> NamedRig, without its calibration.

#include <filesystem>
#include <string>

#include "facenav/capture/rig_store.h"

namespace facenav::capture {

std::string toRigJson(const NamedRig& rig);
/// Throws Error naming file and key.
NamedRig readRigJson(const std::filesystem::path& path);

}  // namespace facenav::capture
