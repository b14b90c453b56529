#pragma once
// Facts of this computer and of the FaceNav on it that help to find a fault. No names: no host, no user, no
// path.

#include <nlohmann/json.hpp>

namespace facenav::app {

/// Version, commit, parts with their versions, and which programs and data files are there.
nlohmann::ordered_json programFacts();
/// System, kernel, processor, memory, graphics drivers, models of the connected cameras.
nlohmann::ordered_json machineFacts();

}  // namespace facenav::app
