#pragma once
// The correction of the brain mask: opened, edited (module editing), put into force with both of the brain's
// surfaces made anew. The window edits stroke by stroke, the command line a list of edits; both begin and
// save here. Places are Mri, mm. A saved correction makes an earlier sign-off void.

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "facenav/casefile/case_store.h"
#include "facenav/editing/mask_editor.h"
#include "facenav/editing/whole_mask_tools.h"
#include "facenav/workflow/brain_surfaces.h"

namespace facenav::workflow {

inline constexpr double kGrowReach_mm = 20.0;  // of a region grown from one place
inline constexpr double kSmooth_mm = 1.5;      // of the Gaussian that smooths the mask

struct BrainCorrection {
  std::shared_ptr<editing::MaskEditor> editor;
  bool has_draft = false;  // the editor goes on from an unfinished correction
};
/// Begins from the unfinished correction where there is one, else from `in_force` (the case's brain mask;
/// null: it has none, then from an empty mask on `grid`). Throws Error for a damaged file.
BrainCorrection beginCorrection(const casefile::CaseStore& store, const volume::VoxelGrid& grid,
                                const volume::Mask* in_force);

/// Puts `mask` into force: the mask, both surfaces and the picture of their distance are written, the draft
/// is removed. Throws Error: the case has no brain mask, another grid, an empty mask, disk full.
BrainSurfaces saveCorrection(const casefile::CaseStore& store, const volume::Volume& mri,
                             const volume::Mask& mask, TaskMonitor& monitor);

/// Edits of a whole correction, done in the order of the members.
struct BrainEdits {
  bool discards_draft = false;    // not from the unfinished correction
  bool starts_automatic = false;  // from the mask that prepare made
  std::optional<std::filesystem::path> drawn =
      {};  // a mask (NIfTI) on the scan's grid, in place of the start
  std::vector<editing::Ball> added = {}, removed = {};
  std::vector<Point<Mri>> grown = {};  // what hangs together with the place and looks like it
  bool fills_holes = false, smooths = false;
};
struct CorrectedBrain {
  double before_ml = 0, after_ml = 0;
  std::size_t added_voxels = 0, removed_voxels = 0;  // against the mask that was in force
  bool had_draft = false;                            // the edits went on from an unfinished correction
  bool isChanged() const { return added_voxels + removed_voxels > 0; }
};
/// Applies the edits and saves. Nothing is written where the mask stays the one in force, but a discarded or
/// finished draft is removed. Throws Error: no brain mask, a place outside the scan, a mask on another grid.
CorrectedBrain correctBrain(const casefile::CaseStore& store, const BrainEdits& edits, TaskMonitor& monitor);

}  // namespace facenav::workflow
