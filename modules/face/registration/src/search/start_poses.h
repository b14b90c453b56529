#pragma once
// Orientations and positions to try without prior knowledge: the geometry of the search, without the cloud.

#include <vector>

#include "facenav/registration/aligner.h"
#include "facenav/registration/scalp_field.h"

namespace facenav::registration {

/// camera_R_mri with the hinted up and right directions; empty without hints.
std::optional<Eigen::Matrix3d> hintedOrientation(const AlignmentStart& start);

/// camera_R_mri of patients who face the camera, at any roll; `is_fine`: in smaller steps.
std::vector<Eigen::Matrix3d> facingOrientations(bool is_fine);

/// `camera_R_mri` turned by up to `reach_deg` about the head's three axes; the unchanged one comes first.
std::vector<Eigen::Matrix3d> orientationsAround(const Eigen::Matrix3d& camera_R_mri, double reach_deg);

/// The point of the skin that is nearest to a camera in direction `towards_camera` (Mri). At the right pose
/// it lies on the cloud.
Eigen::Vector3d foremostSkin(const ScalpField& scalp, const Eigen::Vector3d& towards_camera);

/// mri_T_camera that brings `p_mri_mm` onto `p_camera_mm`.
Eigen::Isometry3d placed(const Eigen::Matrix3d& camera_R_mri, const Eigen::Vector3d& p_mri_mm,
                         const Eigen::Vector3d& p_camera_mm);

/// True if the camera is in front of the face, not behind the head.
bool seesTheFace(const Eigen::Isometry3d& mri_T_camera, const Eigen::Vector3d& middle_mri_mm);

}  // namespace facenav::registration
