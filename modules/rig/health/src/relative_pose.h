#pragma once
// Refines the right camera's pose relative to the left one so that it best explains matches, up to scale: two
// angles of the baseline's direction and three of rotation, under Student's t, from a rough pose.

#include <Eigen/Geometry>
#include <vector>

namespace facenav::health {

/// One match as rays (x/z, y/z) of the two cameras.
struct RayPair {
  Eigen::Vector2d left, right;
  double sigma = 0;  // across the epipolar line, in the same unit (px / f)
};

/// Normal prior of the right camera's pose around `pose`.
struct PosePrior {
  double turn_sigma_rad = 0, shift_sigma_mm = 0;
};

/// Size of the motion when a camera is knocked.
constexpr PosePrior kKnock{0.02, 3.0};
/// Limit for a reweighting that does not settle.
constexpr int kMostReweightings = 40;

struct RelativePose {
  Eigen::Isometry3d right_T_left;  // its baseline has the given length
  double cost = 0;                 // -2 log likelihood under Student's t and the prior, up to a constant
};

/// Distance of a match from its epipolar lines (Sampson), in its sigmas; infinite where the point would lie
/// behind a camera.
double epipolarDistance(const Eigen::Isometry3d& right_T_left, const RayPair& rays);

/// Signed distance of a match from its epipolar lines, in its sigmas, for any depth.
double signedEpipolarDistance(const Eigen::Isometry3d& right_T_left, const RayPair& rays);

double costOf(const Eigen::Isometry3d& right_T_left, const std::vector<RayPair>& rays);

/// Refines the pose from `start`. `prior`: around `start`; null: no prior.
RelativePose refinePose(const Eigen::Isometry3d& start, const std::vector<RayPair>& rays,
                        const PosePrior* prior = nullptr);

}  // namespace facenav::health
