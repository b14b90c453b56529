#pragma once
// simulate: renders a scenario into a recording folder (resources/doc/formats.md) with its truth:
// truth/head.csv, truth/coil.csv, coil.json (the coil's marker mount) and scenario.json (options, seed, the
// event in each frame).

#include <filesystem>
#include <memory>
#include <optional>

#include "facenav/room/scenario.h"

namespace facenav::room {

/// Renders the recording, completely or not at all. `target`: where the scenario `treatment` brings the coil;
/// by default over the left hand area. Throws Error for an unknown scenario (the message lists the known
/// ones), or a folder that cannot be written.
void simulate(const ScenarioOptions& options, std::shared_ptr<const VirtualPatient> patient,
              const std::optional<RigidTransform<Mri, frames::Target>>& target,
              const std::filesystem::path& recording, TaskMonitor& monitor);

}  // namespace facenav::room
