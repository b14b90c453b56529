#pragma once
// A brain mask corrected by hand. brain_mask.nii.gz is always the mask in force, so that every other tool
// reads the right one; the automatic mask is kept beside it as brain_mask_auto.nii.gz from the first
// correction on, and either can be shown again. A correction makes an earlier sign-off void (sign_off.h).

#include "facenav/casefile/case_store.h"

namespace facenav::casefile {

bool hasEditedBrainMask(const CaseStore& store);
/// As prepare made it, edited or not; nothing where the case has no brain.
std::optional<volume::Mask> automaticBrainMask(const CaseStore& store);
/// Throws Error where `folder` holds a case with a corrected mask or a correction under way: what nobody
/// asked to lose.
void requireNoEditsIn(const std::filesystem::path& folder);
/// Puts `mask` into force. Whole files, 0600; the automatic mask is put aside before. Throws Error: the case
/// has no brain mask, another grid, disk full.
void saveEditedBrainMask(const CaseStore& store, const volume::Mask& mask);
/// The automatic mask is in force again; the edited one is gone. Nothing happens where there is none.
void revertToAutomaticBrainMask(const CaseStore& store);
/// brain.vtp, brain_texture.png and cortex.vtp anew, for the mask in force (workflow/brain_surfaces.h makes
/// them). Without a cortex the old one is removed, and surface_distance.png always (draw it anew): they show
/// another mask.
void saveBrainModel(const CaseStore& store, const surface::BrainModel& brain,
                    const surface::DetailedCortex* cortex = nullptr);

/// A correction under way (brain_mask_draft.nii.gz, 0600), saved now and then; the mask in force is as
/// before.
bool hasBrainDraft(const CaseStore& store);
std::optional<volume::Mask> brainDraft(const CaseStore& store);
void saveBrainDraft(const CaseStore& store, const volume::Mask& mask);
void removeBrainDraft(const CaseStore& store);

}  // namespace facenav::casefile
