#pragma once
// The appearance of one patch in one camera of the key frame: template, filters in place of derivative
// images, and their errors for the sensor's noise.

#include <array>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "facenav/cameras/stereo_rig.h"
#include "head/face_surface.h"
#include "patch_model.h"

namespace facenav::head_tracking {

/// Points of a patch on the skin, row by row, one level pixel apart in the left key image.
struct PatchPoints {
  std::vector<Eigen::Vector3d> points_mm;  // Head
  Eigen::Vector3d centre_mm, normal;       // normal towards the camera
  Eigen::Vector3d right_mm, down_mm;       // along the skin, per pixel of the level
  double depth_sigma_mm = 0.0;     // the part of the patch's depth error that its surface does not explain
  double normal_spread_rad = 0.0;  // spread of the skin's normals within the patch
};

struct PatchAppearance {
  PatchView view;  // without the jacobian
  std::vector<float> grey, d_u, d_v;
};

/// Points of a patch. Returns nothing if the surface is not known over the whole patch. `centre_px`: pixels
/// of the level.
std::optional<PatchPoints> pointsOf(const cameras::StereoRig& rig, const FaceSurface& surface,
                                    const Eigen::Vector2d& centre_px, int level);

/// `image`: the level, or the needed part of it; `noise_grey`: of the sensor; `camera_T_head`: at the key
/// frame. Unusable if the patch leaves the image, is seen at a grazing angle, or has too large an error of
/// displacement.
PatchAppearance appearanceOf(const cameras::CameraModel& camera, const Eigen::Isometry3d& camera_T_head,
                             const BlurredImage& image, const PatchPoints& points, int level,
                             double noise_grey);

/// Fills d(displacement)/d(xi): the patch's point moves by exp(w)(X - c) + c + v before the key frame sees
/// it.
void addJacobian(const cameras::CameraModel& camera, const Eigen::Isometry3d& camera_T_head,
                 const Eigen::Vector3d& patch_mm, const Eigen::Vector3d& centre_mm, int level,
                 PatchView& view);

/// Standard deviation of the sensor's noise in an 8-bit image (Immerkaer 1996, in the flattest blocks).
double noiseOf(const cv::Mat& grey);
/// Standard deviation of the noise in the level before its last blur: input of appearanceOf().
double noiseBeforeBlur(double noise_grey, int level);
/// Variance of the noise in a blurred image, relative to the sensor's, at one pixel of the level.
double noiseShare(int level);

}  // namespace facenav::head_tracking
