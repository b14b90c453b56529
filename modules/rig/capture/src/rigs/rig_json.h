#pragma once
// Conversion of rig.json to NamedRig and back, without its calibration.

#include <filesystem>
#include <string>

#include "facenav/capture/rig_store.h"

namespace facenav::capture {

std::string toRigJson(const NamedRig& rig);
/// Reads rig.json. Throws Error naming file and key.
NamedRig readRigJson(const std::filesystem::path& path);

}  // namespace facenav::capture
