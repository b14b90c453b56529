#pragma once
// PatchModel: the face as some hundred small patches of skin, with their shape in space and their appearance
// in both cameras, all from one key frame. Used to fit the pose in the images (pose_fit.h) by the inverse
// compositional scheme (Baker & Matthews 2004): all derivatives belong to the key frame and are computed
// once.
//
// Each patch of each camera is compared without gain and offset (as in NCC), so lamps may change and move.
// Filters that model noise and shading (patch_filters.h) replace the derivative images. They are orthogonal
// to the template and to a constant, so that the image sums of a patch give its displacement without further
// correction.

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "face_region.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/geometry/rotation.h"
#include "head/face_surface.h"
#include "image_pyramid.h"
#include "patch_kernel.h"

namespace facenav::head_tracking {

/// A patch as one camera saw it in the key frame. Displacements are in pixels of the level in the key frame.
struct PatchView {
  bool is_usable = false;
  Eigen::Vector2d px = Eigen::Vector2d::Zero();                 // place of the centre, full resolution
  Eigen::Matrix2d structure_inverse = Eigen::Matrix2d::Zero();  // inverse of the sum of derivative products
  Eigen::Matrix2d covariance =
      Eigen::Matrix2d::Zero();  // of the displacement: noise and sampling, independent in each camera
  Eigen::Matrix2d shading =
      Eigen::Matrix2d::Zero();  // of the displacement, per unit of shading relative to the grey level
  Eigen::Vector3d ray = Eigen::Vector3d::Zero();  // from camera to patch in the key frame, Head
  Eigen::Matrix<double, 2, 6> jacobian = Eigen::Matrix<double, 2, 6>::Zero();  // d(displacement) / d(xi)
  Eigen::Matrix2d ramp =
      Eigen::Matrix2d::Zero();       // change of the image sums per relative slope of brightness
  float contrast = 0.f, mean = 0.f;  // of the template: sum of squares about its mean; mean grey
};

/// Least area of a patch in an image, relative to its area in the left key image.
constexpr double kLeastArea = 0.2;

struct Patch {
  Eigen::Vector3d centre_mm, normal;  // Camera at the reference, i.e. Head
  Eigen::Vector3d right_mm, down_mm;  // along the skin, per pixel of the level in the left key image
  double rigidity = 1.0;              // prior weight
  double depth_sigma_mm = 0.0;        // of its shape, along the key frame's ray
  double normal_spread_rad = 0.0;     // of the skin's normals within it
  std::array<PatchView, 2> view;      // left, right
  int region = 0;                     // part of the face, 0 .. PatchModel::regions - 1
};

/// The patches of one pyramid level; samples lie one patch after the other.
struct PatchLevel {
  int level = 0;
  std::vector<Patch> patches;
  std::vector<float> x, y, z;  // Head, mm
  struct Appearance {
    std::vector<float> grey, d_u, d_v;  // centred template; filters in place of its derivatives
  };
  std::array<Appearance, 2> appearance;

  patch::Samples samples(int camera) const;
};

using PatchLevels = std::array<PatchLevel, kLevels>;

/// A neighbouring patch; light is assumed to change evenly over all of them.
struct Neighbour {
  int patch = 0;
  float right_px = 0.f, down_px = 0.f;  // in the left key image
};

struct PatchModel {
  Eigen::Vector3d centre_mm =
      Eigen::Vector3d::Zero();  // of the patches, Head: centre of rotation of the increments
  PatchLevels level;
  std::vector<std::vector<Neighbour>> neighbours;  // per patch of level 0
  int regions = 1;
  double noise_grey = 1.5;  // of the sensor, measured in the key frame
  double variance_factor =
      1.0;  // factor on a pose's variance; 4 (measured) if the depth comes from the plain pair
};

/// Shading that gain, offset and ramps leave in a patch, relative to its grey level. `light_change`: relative
/// change of light over the face since the key frame, standard deviation.
double shadingSigma(double light_change, double normal_spread_rad);

/// Learns the patches from a key frame taken at the reference pose.
PatchModel learnPatches(const cameras::StereoRig& rig, const cameras::StereoFrame& key_frame,
                        const std::array<ImagePyramid, 2>& key, const FaceRegion& region,
                        const FaceSurface& surface);

}  // namespace facenav::head_tracking
