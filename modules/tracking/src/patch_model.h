#pragma once
// PatchModel: the face as some hundred small patches of skin, with their shape in space and their looks in
// both cameras, all taken from one key frame. Its purpose is the fit of the pose in the images (pose_fit.h)
// by the inverse compositional scheme (Baker & Matthews 2004): all derivatives belong to the key frame and
// are made once.
//
// Each patch of each camera is compared after gain and offset are taken off (as NCC does), so lamps may
// change and move. The derivative images are made orthogonal to template and constant, so that the image sums
// of a patch give its displacement with no further correction.

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "face_region.h"
#include "face_surface.h"
#include "facenav/geometry/rotation.h"
#include "facenav/stereo/stereo_rig.h"
#include "image_pyramid.h"

namespace facenav::tracking {

/// A patch as one camera saw it in the key frame. Displacements are in pixels of the level in the key frame.
struct PatchView {
  bool is_usable = false;
  Eigen::Vector2d px = Eigen::Vector2d::Zero();         // of the centre, full resolution
  Eigen::Matrix2d structure = Eigen::Matrix2d::Zero();  // sum of derivative products
  Eigen::Matrix2d structure_inverse = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d information =
      Eigen::Matrix2d::Zero();  // of the displacement: noise and model error together
  Eigen::Matrix<double, 2, 6> jacobian =
      Eigen::Matrix<double, 2, 6>::Zero();  // d(displacement) / d(xi), see fitPose
  float contrast = 0.f;                     // sum of squares of the centred template
};

struct Patch {
  Eigen::Vector3d centre_mm, normal;  // Camera at the reference, i.e. Head
  double rigidity = 1.0;              // prior trust
  std::array<PatchView, 2> view;      // left, right
};

/// The patches of one pyramid level; samples lie one patch after the other.
struct PatchLevel {
  int level = 0, samples = 0;
  std::vector<Patch> patches;
  std::vector<float> x, y, z;  // Head, mm
  struct Looks {
    std::vector<float> grey, d_u, d_v;  // centred template; derivatives orthogonal to it and to 1
  };
  std::array<Looks, 2> looks;
};

struct PatchModel {
  Eigen::Vector3d centre_mm = Eigen::Vector3d::Zero();  // of the patches, Head: increments turn about it
  std::array<PatchLevel, kLevels> level;
  double shape_doubt =
      1.0;  // factor on a pose's variance: 4 where the depth comes from the plain pair (measured)
};

/// Learns the patches from a key frame taken at the reference pose.
PatchModel learnPatches(const stereo::StereoRig& rig, const std::array<ImagePyramid, 2>& key,
                        const FaceRegion& region, const FaceSurface& surface);

}  // namespace facenav::tracking
