#pragma once
// DetailedCortex: the brain's true surface with open sulci (both banks), and how far it lies from the
// phi-theta model, which reaches no fold. PeelTexture: the MRI's grey values under that surface at a depth
// that a slider moves. From tissueShare (segmentation) or any field whose 0.5 level is the cortex; kept in
// the case as cortex.vtp.

#include <filesystem>

#include "facenav/core/file_access.h"
#include "facenav/surface/brain_model.h"
#include "facenav/surface/cortex_surface.h"
#include "facenav/surface/surface_distance.h"

namespace facenav::surface {

struct DetailedCortex {
  TriangleMesh mesh;  // closed, outward, Mri mm
  std::vector<float>
      distance_mm;  // per vertex, to the phi-theta surface: > 0 outside it, < 0 within (in a sulcus)
};

/// The 0.5 level of `tissue` (0 outside the brain, 1 in it), its largest part.
/// Throws Error where nothing reaches 0.5.
TriangleMesh extractCortex(const volume::Volume& tissue, int smoothing_steps, TaskMonitor& monitor);
/// Both ways, since each hides what the other shows: a fold lies far from the model although every part of
/// the model lies close to some crown.
struct ModelDistance {
  SurfaceDistance cortex_to_model, model_to_cortex;
};
ModelDistance distanceBetween(const DetailedCortex& cortex, const BrainModel& model);

/// cortex.vtp: points, normals, triangles, point data "distance_mm". Whole file.
void writeCortex(const DetailedCortex& cortex, const std::filesystem::path& vtp,
                 FileAccess access = FileAccess::by_umask);
/// Throws Error when the file is missing or damaged.
DetailedCortex readCortex(const std::filesystem::path& vtp);

/// Grey values under a surface. Made once per surface (some tenths of a second), asked at every move of a
/// slider (some milliseconds). Safe to ask from several threads.
class PeelTexture {
 public:
  /// `brain`: the mask (sulci closed) whose hull depth is counted from: the way inwards at a vertex leads
  /// away from that hull, so that depths agree on crowns and on sulcal walls. `surface`: DetailedCortex's
  /// mesh or BrainModel's. The arguments need not outlive this.
  PeelTexture(const volume::Volume& mri, const volume::Mask& brain, const TriangleMesh& surface);

  /// One per vertex, 0..255: the MRI `depth_mm` (0..40) below the vertex, trilinear; one window for all
  /// depths (fluid dark, white matter bright).
  std::vector<std::uint8_t> greyAt(double depth_mm) const;

 private:
  volume::Volume mri_;                      // around the brain
  std::vector<Eigen::Vector3f> at_, step_;  // voxels, and voxels per mm inwards
  float low_ = 0, high_ = 1;
};

}  // namespace facenav::surface
