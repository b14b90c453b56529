#pragma once
// The MRI's skin over the camera pictures, where the head's pose puts it: its occluding contour (the rim of
// head, nose, chin and ears as each camera sees them), points of the skin, and named places. A person sees at
// a glance whether they lie on the live face. This measures nothing.

#include <memory>
#include <vector>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/pictures/camera_picture.h"
#include "facenav/surface/named_place.h"
#include "facenav/surface/triangle_mesh.h"

namespace facenav::pictures {

/// What is drawn, made once for a case.
struct AlignedSkin {
  surface::TriangleMesh mesh;     // Mri; thinned, so that it is drawn in milliseconds
  std::vector<std::size_t> dots;  // vertices that are drawn as points, about kDots_mm apart
  std::vector<surface::NamedPlace> places;

  static constexpr double kMesh_mm = 3.0, kDots_mm = 12.0;
};

/// `scalp`: Mri, with normals. Its vertices are joined within cubes of AlignedSkin::kMesh_mm; the contour
/// moves by 0.1 mm or less on skin with a radius of 10 mm.
AlignedSkin makeAlignedSkin(const surface::TriangleMesh& scalp, std::vector<surface::NamedPlace> places);

/// The skin on both pictures; `frame`: 8-bit, 1 channel, of the rig's size.
CameraOverlay drawAlignedSkin(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                              const RigidTransform<Camera, Mri>& camera_T_mri, const AlignedSkin& skin);

/// One piece of the occluding contour in a camera's picture, px.
struct ContourPiece {
  Eigen::Vector2d from_px, to_px;
};
/// The contour as one camera sees it. `view_T_mri`: Mri in the camera's frame. Hidden parts are left out.
std::vector<ContourPiece> occludingContour(const surface::TriangleMesh& mesh,
                                           const Eigen::Isometry3d& view_T_mri,
                                           const cameras::CameraModel& lens, int width_px, int height_px);

}  // namespace facenav::pictures
