#include "facenav/casefile/edited_brain.h"

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/volume/nifti.h"

namespace facenav::casefile {
namespace fs = std::filesystem;
namespace {

constexpr char kInForce[] = "brain_mask.nii.gz", kAutomatic[] = "brain_mask_auto.nii.gz",
               kDraft[] = "brain_mask_draft.nii.gz";

/// Copies the automatic mask. Written whole: an interrupted copy leaves no file under the final name.
void keepAutomatic(const CaseStore& store) {
  if (hasEditedBrainMask(store)) return;
  writeWholeFile(store.folder() / kAutomatic, readWholeFile(store.folder() / kInForce),
                 FileAccess::owner_only);
}

}  // namespace

bool hasEditedBrainMask(const CaseStore& store) { return fs::is_regular_file(store.folder() / kAutomatic); }

void requireNoEditsIn(const fs::path& folder) {
  const bool is_edited = fs::exists(folder / kAutomatic);
  if (!is_edited && !fs::exists(folder / kDraft)) return;
  throw Error(is_edited ? "the case holds a brain mask corrected by hand, which would be lost"
                        : "the case holds an unfinished correction of the brain mask, which would be lost",
              folder.string(), "choose another folder, or --discard-edits");
}

std::optional<volume::Mask> automaticBrainMask(const CaseStore& store) {
  if (hasEditedBrainMask(store)) return volume::readMask(store.folder() / kAutomatic);
  return store.brainMask();
}

void saveEditedBrainMask(const CaseStore& store, const volume::Mask& mask) {
  const auto present = store.brainMask();
  if (!present)
    throw Error("the case has no brain mask to correct", store.folder().string(), "prepare the case again");
  if (!present->grid.matches(mask.grid))
    throw Error("the corrected mask lies on another grid than the scan", store.folder().string(),
                "correct this case's own mask");
  keepAutomatic(store);
  volume::writeMask(mask, store.folder() / kInForce, FileAccess::owner_only);
}

void revertToAutomaticBrainMask(const CaseStore& store) {
  if (!hasEditedBrainMask(store)) return;
  fs::rename(store.folder() / kAutomatic, store.folder() / kInForce);
}

void saveBrainModel(const CaseStore& store, const surface::BrainModel& brain,
                    const surface::DetailedCortex* cortex) {
  const fs::path vtp = store.folder() / "brain.vtp", texture = store.folder() / "brain_texture.png";
  surface::writeBrain(brain, vtp, texture, FileAccess::owner_only);
  std::error_code absent;  // it shows the previous mask
  fs::remove(store.folder() / "surface_distance.png", absent);
  const fs::path folded = store.folder() / "cortex.vtp";
  if (!cortex) {
    fs::remove(folded);
    return;
  }
  surface::writeCortex(*cortex, folded, FileAccess::owner_only);
}

bool hasBrainDraft(const CaseStore& store) { return fs::exists(store.folder() / kDraft); }

std::optional<volume::Mask> brainDraft(const CaseStore& store) {
  if (!hasBrainDraft(store)) return std::nullopt;
  return volume::readMask(store.folder() / kDraft);
}

void saveBrainDraft(const CaseStore& store, const volume::Mask& mask) {
  volume::writeMask(mask, store.folder() / kDraft, FileAccess::owner_only);
}

void removeBrainDraft(const CaseStore& store) {
  std::error_code absent;
  fs::remove(store.folder() / kDraft, absent);
}

}  // namespace facenav::casefile
