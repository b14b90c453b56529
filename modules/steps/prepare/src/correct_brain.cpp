#include "facenav/prepare/correct_brain.h"

#include <algorithm>
#include <cstdio>

#include "facenav/casefile/edited_brain.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/editing/region_grow.h"
#include "facenav/prepare/case_pictures.h"
#include "facenav/volume/nifti.h"
#include "facenav/volume/regrid.h"

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

/// Describes how `other` differs from the scan's grid: in its size, or by how many mm it lies beside it.
std::string differenceOf(const volume::VoxelGrid& other, const volume::VoxelGrid& grid) {
  if (other.size != grid.size) {
    const auto size = [](const volume::VoxelGrid& g) {
      return formatted("%d x %d x %d voxels", g.size[0], g.size[1], g.size[2]);
    };
    return "it has " + size(other) + ", the scan " + size(grid);
  }
  double least_mm = 1e9, most_mm = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d ijk((corner & 1) * grid.size[0], (corner >> 1 & 1) * grid.size[1],
                              (corner >> 2) * grid.size[2]);
    const double off_mm = (other.toMri(ijk).mm - grid.toMri(ijk).mm).norm();
    least_mm = std::min(least_mm, off_mm), most_mm = std::max(most_mm, off_mm);
  }
  return most_mm - least_mm < 0.05 ? formatted("it lies %.1f mm beside the scan", most_mm)
                                   : formatted("it lies %.1f to %.1f mm beside the scan", least_mm, most_mm);
}

/// True if the mask would fit by its qform, where the sform was used.
bool fitsByQform(const std::filesystem::path& path, const volume::VoxelGrid& grid) {
  try {
    const auto read = volume::readNifti(path, volume::NiftiTransform::qform);
    return volume::reordered(volume::maskOf(read.volume), grid).has_value();
  } catch (const Error&) {  // it has no qform
    return false;
  }
}

volume::Mask drawnMask(const std::filesystem::path& path, const volume::VoxelGrid& grid,
                       std::vector<std::string>& notes) {
  const auto read = volume::readNifti(path);
  const auto mask = volume::maskOf(read.volume);
  if (read.warning) notes.push_back("the mask's " + *read.warning);
  if (auto fitting = volume::reordered(mask, grid)) return *std::move(fitting);
  const bool fits = read.volume.orientation_source == "sform" && fitsByQform(path, grid);
  throw Error("the mask lies on another grid than the case's scan: " + differenceOf(mask.grid, grid) +
                  (fits ? " by its sform; by its qform it fits" : ""),
              path.string(),
              fits ? "write its qform into its sform, if that is right" : "draw it on the case's mri.nii.gz");
}

void paintBalls(editing::MaskEditor& editor, const std::vector<editing::Ball>& balls, bool is_brain) {
  for (const auto& ball : balls) {
    requireInScan(editor.mask().grid, ball.centre);
    editor.apply("sphere", editing::paint(editor.mask(), {ball.centre, ball.centre},
                                          {ball.radius_mm, std::nullopt}, is_brain));
  }
}

void applyAll(const BrainEdits& edits, const volume::Volume& mri, editing::MaskEditor& editor,
              std::vector<std::string>& notes) {
  if (edits.starts_automatic) editor.resetToAutomatic();
  if (edits.drawn)
    editor.apply("import",
                 editing::difference(editor.mask(), drawnMask(*edits.drawn, editor.mask().grid, notes)));
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
  std::vector<std::string> notes;
  applyAll(edits, mri, *correction.editor, notes);
  auto result = compared(*before, correction.editor->mask());
  result.notes = std::move(notes);
  result.had_draft = correction.has_draft && !edits.starts_automatic && !edits.drawn;
  if (result.isChanged()) saveCorrection(store, mri, correction.editor->mask(), monitor);
  casefile::removeBrainDraft(store);
  return result;
}

}  // namespace facenav::steps
