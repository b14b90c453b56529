#pragma once
// A brain mask corrected by hand. brain_mask.nii.gz is always the mask in force, so that other tools read the
// right one. From the first correction on, the automatic mask is stored beside it as brain_mask_auto.nii.gz,
// so that it can be shown and restored. A correction makes an earlier sign-off void (sign_off.h).

#include "facenav/casefile/case_store.h"

namespace facenav::casefile {

bool hasEditedBrainMask(const CaseStore& store);
/// Returns the mask as prepare made it; nothing if the case has no brain.
std::optional<volume::Mask> automaticBrainMask(const CaseStore& store);
/// Throws Error if `folder` is a case with a corrected mask or an unfinished correction, which would be lost.
void requireNoEditsIn(const std::filesystem::path& folder);
/// Makes `mask` the mask in force; stores the automatic mask first. Whole files, 0600. Throws Error: the case
/// has no brain mask, another grid, disk full.
void saveEditedBrainMask(const CaseStore& store, const volume::Mask& mask);
/// Makes the automatic mask the mask in force and removes the edited one. Does nothing if there is none.
void revertToAutomaticBrainMask(const CaseStore& store);
/// Replaces brain.vtp, brain_texture.png and cortex.vtp by surfaces of the mask in force (made by
/// prepare/brain_surfaces.h). Without a cortex, the old one is removed. surface_distance.png shows another
/// mask, so it is removed; draw it again.
void saveBrainModel(const CaseStore& store, const surface::BrainModel& brain,
                    const surface::DetailedCortex* cortex = nullptr);

/// Draft of a correction (brain_mask_draft.nii.gz, 0600), saved now and then. The mask in force does not
/// change.
bool hasBrainDraft(const CaseStore& store);
std::optional<volume::Mask> brainDraft(const CaseStore& store);
void saveBrainDraft(const CaseStore& store, const volume::Mask& mask);
void removeBrainDraft(const CaseStore& store);

}  // namespace facenav::casefile
