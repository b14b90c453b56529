#pragma once
// Two slices through the MRI along the coil's axis, one along its handle and one across it, with the coil's
// plate, its beam, the target and the error's 95 % bound. They follow the planned or the live coil. Computed
// without a display. Coil frame: +z into the head, +y away from the handle.

#include <optional>

#include "facenav/guidance/coil_plate.h"
#include "facenav/scene/slice_scene.h"

namespace facenav::scene {

enum class CoilCut { along_handle, across_handle };

/// The coil that the slices follow.
struct SlicedCoil {
  RigidTransform<Mri, Coil> mri_T_coil;
  guidance::CoilPlate plate = guidance::figureOfEight();
  /// 95 % bound of the alignment's error at the target, mm; nothing: unknown, and not drawn.
  std::optional<double> bound95_mm;
};

constexpr double kCoilSliceAbove_mm = 22, kCoilSliceDepth_mm = 88;  // shown above and below the contact face

/// Plane through the coil's axis. The image's down is into the head (+z). Along the handle: the handle is on
/// the left. Across: as seen by the person who holds the handle, so the coil's +x is on the left. The coil's
/// centre lies on the image's middle column; `zoom` enlarges about a point 40 mm under it.
volume::SlicePlane coilPlane(const RigidTransform<Mri, Coil>& mri_T_coil, CoilCut cut, int width_px,
                             int height_px, double zoom = 1.0);

/// Draws a slice. MRI, window, contours, overlays and active target are those of `scene`; its crosshair is
/// drawn if it lies on the slice. A ring of the error's bound is drawn on the beam, beside the target's
/// cortex point.
RgbImage coilSlicePicture(const SliceScene& scene, const SlicedCoil& coil, CoilCut cut,
                          const volume::SlicePlane& plane);

/// Position of a point relative to the beam: depth under the contact face and distance from the axis, mm.
struct BeamPassing {
  double depth_mm = 0, miss_mm = 0;
};
BeamPassing beamPassing(const RigidTransform<Mri, Coil>& mri_T_coil, const Point<Mri>& p);

}  // namespace facenav::scene
