#pragma once
// Draws the MRI's skin over the camera pictures at the head's pose: its occluding contour (the rim of head,
// nose, chin and ears in each camera), points of the skin, and named places. A person checks at a glance
// whether they lie on the live face. This measures nothing.

#include <memory>
#include <vector>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/pictures/camera_picture.h"
#include "facenav/surface/named_place.h"
#include "facenav/surface/triangle_mesh.h"

namespace facenav::pictures {

/// Skin to draw; made once for a case.
struct AlignedSkin {
  surface::TriangleMesh mesh;     // Mri; thinned, so that drawing takes milliseconds
  std::vector<std::size_t> dots;  // vertices that are drawn as points, about kDots_mm apart
  std::vector<surface::NamedPlace> places;

  static constexpr double kMesh_mm = 3.0, kDots_mm = 12.0;
};

/// Thins the scalp. `scalp`: Mri, with normals. Its vertices are joined within cubes of
/// AlignedSkin::kMesh_mm; this moves the contour by 0.1 mm or less on skin with a radius of 10 mm.
AlignedSkin makeAlignedSkin(const surface::TriangleMesh& scalp, std::vector<surface::NamedPlace> places);

/// Draws the skin on both pictures; `frame`: 8-bit, 1 channel, of the rig's size.
CameraOverlay drawAlignedSkin(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                              const RigidTransform<Camera, Mri>& camera_T_mri, const AlignedSkin& skin);

/// One piece of the occluding contour in a camera's picture, px.
struct ContourPiece {
  Eigen::Vector2d from_px, to_px;
};
/// Occluding contour in one camera. `view_T_mri`: Mri in the camera's frame. Hidden parts are left out.
std::vector<ContourPiece> occludingContour(const surface::TriangleMesh& mesh,
                                           const Eigen::Isometry3d& view_T_mri,
                                           const cameras::CameraModel& lens, int width_px, int height_px);

}  // namespace facenav::pictures
