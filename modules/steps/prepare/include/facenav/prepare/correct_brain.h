#pragma once
// Correction of the brain mask: opens it, edits it (module editing), makes it the mask in force and builds
// both surfaces of the brain again. The window edits stroke by stroke, the command line by a list of edits;
// both begin and save here. Points are in Mri, mm. A saved correction makes an earlier sign-off void.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/casefile/case_store.h"
#include "facenav/editing/mask_editor.h"
#include "facenav/editing/whole_mask_tools.h"
#include "facenav/prepare/brain_surfaces.h"

namespace facenav::steps {

inline constexpr double kGrowReach_mm = 20.0;  // largest distance of a grown region from its seed
inline constexpr double kSmooth_mm = 1.5;      // sigma of the Gaussian that smooths the mask

struct BrainCorrection {
  std::shared_ptr<editing::MaskEditor> editor;
  bool has_draft = false;  // the editor continues an unfinished correction
};
/// Continues the unfinished correction if there is one, else starts from `in_force` (the case's brain mask;
/// null if the case has none: then from an empty mask on `grid`). Throws Error for a damaged file.
BrainCorrection beginCorrection(const casefile::CaseStore& store, const volume::VoxelGrid& grid,
                                const volume::Mask* in_force);

/// Makes `mask` the mask in force: writes the mask, both surfaces and the picture of their distance. The
/// draft stays, because it may be newer than `mask`; the editor removes it (casefile::removeBrainDraft).
/// Throws Error: the case has no brain mask, another grid, an empty mask, disk full.
BrainSurfaces saveCorrection(const casefile::CaseStore& store, const volume::Volume& mri,
                             const volume::Mask& mask, TaskMonitor& monitor);

/// Edits of a correction, applied in the order of the members.
struct BrainEdits {
  bool discards_draft = false;    // do not continue an unfinished correction
  bool starts_automatic = false;  // start from the mask that prepare made
  // A mask (NIfTI) on the scan's grid to start from; the order and direction of its axes do not matter.
  std::optional<std::filesystem::path> drawn = {};
  std::vector<editing::Ball> added = {}, removed = {};
  std::vector<Point<Mri>> grown = {};  // adds the connected region of similar values around each point
  bool fills_holes = false, smooths = false;
};
struct CorrectedBrain {
  double before_ml = 0, after_ml = 0;
  std::size_t added_voxels = 0, removed_voxels = 0;  // compared with the mask that was in force
  std::vector<std::string> notes;                    // on the drawn mask: its two maps to world disagree
  bool had_draft = false;                            // the edits continued an unfinished correction
  bool isChanged() const { return added_voxels + removed_voxels > 0; }
};
/// Applies the edits and saves. If the mask does not change, nothing is written, but a discarded or finished
/// draft is removed. Throws Error: no brain mask, a point outside the scan, a mask on another grid.
CorrectedBrain correctBrain(const casefile::CaseStore& store, const BrainEdits& edits, TaskMonitor& monitor);

}  // namespace facenav::steps
