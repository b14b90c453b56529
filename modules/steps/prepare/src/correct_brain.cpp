#include "facenav/prepare/correct_brain.h"

#include <cstdio>

#include "facenav/casefile/edited_brain.h"
#include "facenav/core/error.h"
#include "facenav/editing/region_grow.h"
#include "facenav/prepare/case_pictures.h"
#include "facenav/volume/nifti.h"

namespace facenav::steps {
namespace {

volume::Mask emptyMask(const volume::VoxelGrid& grid) {
  volume::Mask mask;
  mask.grid = grid;
  mask.voxels.assign(grid.count(), 0);
  return mask;
}

void requireInScan(const volume::VoxelGrid& grid, const Point<Mri>& p) {
  const Eigen::Vector3d voxel = grid.toVoxel(p);
  const Eigen::Vector3d last(grid.size[0] - 0.5, grid.size[1] - 0.5, grid.size[2] - 0.5);
  if ((voxel.array() >= -0.5).all() && (voxel.array() < last.array()).all()) return;
  char place[96];
  std::snprintf(place, sizeof place, "%.1f %.1f %.1f mm", p.mm.x(), p.mm.y(), p.mm.z());
  throw Error("the place lies outside the scan", place, "give R A S in the patient's MRI");
}

volume::Mask drawnMask(const std::filesystem::path& path, const volume::VoxelGrid& grid) {
  auto mask = volume::readMask(path);
  if (!mask.grid.matches(grid))
    throw Error("the mask lies on another grid than the case's scan", path.string(),
                "draw it on the case's mri.nii.gz");
  return mask;
}

void paintBalls(editing::MaskEditor& editor, const std::vector<editing::Ball>& balls, bool is_brain) {
  for (const auto& ball : balls) {
    requireInScan(editor.mask().grid, ball.centre);
    editor.apply("sphere", editing::paint(editor.mask(), {ball.centre, ball.centre},
                                          {ball.radius_mm, std::nullopt}, is_brain));
  }
}

void applyAll(const BrainEdits& edits, const volume::Volume& mri, editing::MaskEditor& editor) {
  if (edits.starts_automatic) editor.resetToAutomatic();
  if (edits.drawn)
    editor.apply("import", editing::difference(editor.mask(), drawnMask(*edits.drawn, editor.mask().grid)));
  paintBalls(editor, edits.added, true);
  paintBalls(editor, edits.removed, false);
  for (const auto& place : edits.grown) {
    requireInScan(mri.grid, place);
    editor.apply("region grow", editing::growRegion(editor.mask(), mri, place,
                                                    editing::rangeAround(mri, place), kGrowReach_mm, true));
  }
  if (edits.fills_holes) editor.apply("fill holes", editing::fillHoles(editor.mask()));
  if (edits.smooths) editor.apply("smooth", editing::smooth(editor.mask(), kSmooth_mm));
}

CorrectedBrain compared(const volume::Mask& before, const volume::Mask& after) {
  CorrectedBrain result;
  result.before_ml = before.volume_ml();
  result.after_ml = after.volume_ml();
  for (const auto voxel : editing::difference(before, after).voxels)
    ++(after.voxels[voxel] ? result.added_voxels : result.removed_voxels);
  return result;
}

}  // namespace

BrainCorrection beginCorrection(const casefile::CaseStore& store, const volume::VoxelGrid& grid,
                                const volume::Mask* in_force) {
  auto automatic = casefile::automaticBrainMask(store);
  auto edited = casefile::brainDraft(store);
  const bool has_draft = edited.has_value();
  if (!edited && in_force) edited = *in_force;
  return {std::make_shared<editing::MaskEditor>(automatic ? std::move(*automatic) : emptyMask(grid),
                                                std::move(edited)),
          has_draft};
}

BrainSurfaces saveCorrection(const casefile::CaseStore& store, const volume::Volume& mri,
                             const volume::Mask& mask, TaskMonitor& monitor) {
  auto surfaces = buildBrainSurfaces(mri, mask, monitor);
  casefile::saveEditedBrainMask(store, mask);  // the sign-off becomes void here
  casefile::saveBrainModel(store, surfaces.model, &surfaces.cortex);
  writeSurfaceDistance(surfaces.cortex, surfaces.distance, store.folder());
  return surfaces;
}

CorrectedBrain correctBrain(const casefile::CaseStore& store, const BrainEdits& edits, TaskMonitor& monitor) {
  const auto before = store.brainMask();
  if (!before)
    throw Error("the case has no brain mask to correct", store.folder().string(), "prepare the case again");
  if (edits.discards_draft) casefile::removeBrainDraft(store);
  const auto mri = store.mri();
  const auto correction = beginCorrection(store, mri.grid, &*before);
  applyAll(edits, mri, *correction.editor);
  auto result = compared(*before, correction.editor->mask());
  result.had_draft = correction.has_draft && !edits.starts_automatic && !edits.drawn;
  if (result.isChanged()) saveCorrection(store, mri, correction.editor->mask(), monitor);
  casefile::removeBrainDraft(store);
  return result;
}

}  // namespace facenav::steps
