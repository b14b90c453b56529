#pragma once
// FaceSurface: the skin's depth over the left reference image, from the dense cloud or from passive stereo of
// the reference pair. It uses inverse depth, which is an affine function of the pixel for a plane.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "face_region.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/head_tracking/head_tracker.h"

namespace facenav::head_tracking {

/// Skin whose normal has a smaller cosine with the view is not used: its pixels cover too much of it.
constexpr double kGrazing_cos = 0.25;

/// A quadric in inverse depth near one pixel.
struct LocalSurface {
  Eigen::Vector2d centre_px = Eigen::Vector2d::Zero();
  Eigen::Matrix<double, 6, 1> c =
      Eigen::Matrix<double, 6, 1>::Zero();  // of 1, u, v, u^2, u v, v^2 (px from the centre)
  double rms_mm = 0.0;                      // robust spread of the points about it
  double roughness_mm = 0.0;  // rms of all points about it: larger at a step (hairline, nostril, lid)

  double inverseDepth(const Eigen::Vector2d& px) const;
};

class FaceSurface {
 public:
  /// `least_radius_px`: smallest neighbourhood that a quadric is fitted to; larger for noisy depths.
  FaceSurface(const std::vector<Eigen::Vector2f>& left_px, const std::vector<float>& depth_mm, cv::Size size,
              double least_radius_px = 0.0);

  /// The quadric through the points within `radius_px`, without outliers. Returns nothing if they are too
  /// few, on one side only, or too rough.
  std::optional<LocalSurface> around(const Eigen::Vector2d& px, double radius_px) const;

 private:
  std::vector<int> near(const Eigen::Vector2d& px, double radius_px) const;

  static constexpr int kCell_px = 8;
  int columns_, rows_;
  double least_radius_px_;
  std::vector<std::vector<int>> cells_;
  std::vector<Eigen::Vector2f> px_;
  std::vector<float> inverse_depth_;
};

/// Makes it from the reference's cloud, or by passiveSurface() without a cloud.
FaceSurface measureSurface(const cameras::StereoRig& rig, const HeadReference& reference,
                           const FaceRegion& region, double start_depth_mm);

}  // namespace facenav::head_tracking
