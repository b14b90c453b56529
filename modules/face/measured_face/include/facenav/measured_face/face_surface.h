#pragma once
// A measured face as an open surface: vertices are the means of a few points each. Data flow: face cloud of a
// pair or a film -> surface (Mri) with its measuring errors, which later captures are aligned to.

#include "facenav/registration/scalp_field.h"
#include "facenav/stereo/face_cloud.h"
#include "facenav/surface/scalp_surface.h"

namespace facenav::measured_face {

/// Of the points that are measured well and face the camera. `scalp`: an MRI's skin; then only points on it
/// are taken (hair and clothes are not). May be null. The measurement's `size` is left open.
surface::ScalpSurface faceSurface(const cameras::StereoRig& rig, const stereo::FaceCloud& face,
                                  const RigidTransform<Mri, Camera>& mri_T_camera,
                                  const registration::ScalpField* scalp);

/// Throws Error if too small a part of a face was measured.
void requireWholeFace(const surface::TriangleMesh& mesh);

}  // namespace facenav::measured_face
