#pragma once
// A measured face as an open surface: vertices are the means of a few points each. Data flow: face cloud of a
// pair or a film -> surface (Mri) with its measuring errors, which later captures are aligned to.

#include "facenav/registration/scalp_field.h"
#include "facenav/stereo/face_cloud.h"
#include "facenav/surface/scalp_surface.h"

namespace facenav::measured_face {

/// Surface of the points that are measured well and face the camera. `scalp`: an MRI's skin, may be null;
/// then only points on it are used (no hair or clothes). The measurement's `size` is not set.
surface::ScalpSurface faceSurface(const cameras::StereoRig& rig, const stereo::FaceCloud& face,
                                  const RigidTransform<Mri, Camera>& mri_T_camera,
                                  const registration::ScalpField* scalp);

/// Throws Error if too small a part of the face was measured.
void requireWholeFace(const surface::TriangleMesh& mesh);

}  // namespace facenav::measured_face
