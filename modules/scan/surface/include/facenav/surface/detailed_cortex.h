#pragma once
// DetailedCortex: the brain's surface with open sulci (both banks), and its distance from the phi-theta
// model, which does not follow the folds. PeelTexture: the MRI's grey values below that surface at a depth
// set by a slider. Made from tissueShare (segmentation) or any field whose 0.5 level is the cortex; stored in
// the case as cortex.vtp.

#include <filesystem>

#include "facenav/core/file_access.h"
#include "facenav/surface/brain_model.h"
#include "facenav/surface/cortex_surface.h"
#include "facenav/surface/surface_distance.h"

namespace facenav::surface {

struct DetailedCortex {
  TriangleMesh mesh;               // closed, outward, Mri mm
  std::vector<float> distance_mm;  // distance of each vertex to the phi-theta surface: > 0 outside it, < 0
                                   // inside (in a sulcus)
};

/// Largest part of the 0.5 level of `tissue` (0 outside the brain, 1 inside). Throws Error when no value
/// reaches 0.5.
TriangleMesh extractCortex(const volume::Volume& tissue, int smoothing_steps, TaskMonitor& monitor);
/// Distance in both directions, because each hides something: a fold lies far from the model, although every
/// part of the model lies close to some crown.
struct ModelDistance {
  SurfaceDistance cortex_to_model, model_to_cortex;
};
ModelDistance distanceBetween(const DetailedCortex& cortex, const BrainModel& model);

/// cortex.vtp: points, normals, triangles, point data "distance_mm". Whole file or nothing.
void writeCortex(const DetailedCortex& cortex, const std::filesystem::path& vtp,
                 FileAccess access = FileAccess::owner_only);
/// Reads cortex.vtp. Throws Error if the file is missing or damaged.
DetailedCortex readCortex(const std::filesystem::path& vtp);

/// Grey values below a surface. Made once per surface (some tenths of a second); greyAt() takes some
/// milliseconds, for each move of a slider. Thread-safe.
class PeelTexture {
 public:
  /// `brain`: the mask (sulci closed) whose hull defines the depth. From a vertex, inwards means away from
  /// that hull, so that depths agree on crowns and sulcal walls. `surface`: the mesh of DetailedCortex or
  /// BrainModel. The arguments need not outlive this object.
  PeelTexture(const volume::Volume& mri, const volume::Mask& brain, const TriangleMesh& surface);

  /// Grey value per vertex, 0..255: the MRI `depth_mm` (0..40) below the vertex, trilinear. One grey window
  /// serves all depths (fluid dark, white matter bright).
  std::vector<std::uint8_t> greyAt(double depth_mm) const;

 private:
  volume::Volume mri_;                      // MRI around the brain
  std::vector<Eigen::Vector3f> at_, step_;  // start (voxels) and step (voxels per mm inwards) of each vertex
  float low_ = 0, high_ = 1;
};

}  // namespace facenav::surface
