#pragma once
// PLAN: overlays of a case (casefile/overlays_file.h): adds a file of another program, removes it, loads all
// of them into Mri. The window and `facenav plan --overlay` use the same functions.

#include <optional>
#include <string>
#include <vector>

#include "facenav/casefile/case_store.h"
#include "facenav/casefile/overlays_file.h"
#include "facenav/scene/overlay.h"

namespace facenav::steps {

struct NewOverlay {
  std::filesystem::path file;  // NIfTI, .trk .tck .trx, .ply .stl .obj .vtk .vtp
  /// Space of its coordinates. Nothing: native; but a file marked as in a template's space is then refused,
  /// because a group's map fits no individual head.
  std::optional<casefile::OverlaySpace> space;
  std::string name;  // empty: "map 1", "tracts 2", since a file's name may be a patient's
  double opacity = 0.7;
  std::optional<double> threshold, full;  // of a map; absent: 95th percentile and maximum of |value|
};

/// Reads and checks the file, and stores a copy with the case. A NIfTI whose values are 0 and one other is a
/// mask. Throws Error, and then nothing has changed: unreadable, damaged, empty, beside the head, name taken,
/// no atlas for MNI.
casefile::OverlayEntry addOverlay(const casefile::CaseStore& store, const NewOverlay& wanted);
/// Removes an overlay. Throws Error when the case has none of this name.
void removeOverlay(const casefile::CaseStore& store, const std::string& name);
/// Changes opacity, threshold, end of colours, unit and visibility of an overlay; the rest stays. Throws as
/// removeOverlay does.
void changeOverlay(const casefile::CaseStore& store, const casefile::OverlayEntry& entry);

/// Loads one overlay into Mri; a map of MNI space is resampled to a grid of 1.5 mm about the MRI. Throws
/// Error.
scene::Overlay loadOverlay(const casefile::CaseStore& store, const casefile::OverlayEntry& entry,
                           const volume::VoxelGrid& mri);
/// Loads all visible overlays, in order. Throws Error as loadOverlay does.
std::vector<scene::Overlay> loadOverlays(const casefile::CaseStore& store, const volume::VoxelGrid& mri);

}  // namespace facenav::steps
