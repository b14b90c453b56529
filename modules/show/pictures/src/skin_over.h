#pragma once
// Draws the MRI's skin into one camera's view: contour, points, named places. Private to pictures.

#include "camera_view.h"
#include "facenav/pictures/aligned_skin.h"

namespace facenav::pictures {

void drawSkinOver(CameraView& view, const RigidTransform<Camera, Mri>& camera_T_mri, const AlignedSkin& skin);
/// Draws the coil's tip, or a picked spot: a ring with a cross.
void drawTip(CameraView& view, const Point<Camera>& tip, const cv::Scalar& colour);

}  // namespace facenav::pictures
