#pragma once
// FaceTemplate: the whole face at once, as some hundred points of skin with their grey values in both cameras
// at a quarter and an eighth of the size. It finds the pose to a few degrees from a start some ten degrees
// and centimetres away. Single patches (pose_fit.h) would then match wrong places; all points together have
// only one best place. Lucas-Kanade over the shape in space (6 degrees of freedom, both images), on images
// evened against light: local mean subtracted, divided by local contrast.

#include <Eigen/Geometry>
#include <array>
#include <opencv2/core.hpp>
#include <vector>

#include "face_region.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/geometry/rotation.h"
#include "head/face_surface.h"
#include "image_pyramid.h"

namespace facenav::head_tracking {

/// A level without the effect of light: deviation from the local mean in local standard deviations.
cv::Mat1f evened(const BlurredImage& level);

/// Both images (left, right) at the two coarsest levels.
struct EvenedPair {
  static constexpr std::array<int, 2> kLevel = {kLevels - 1, kLevels - 2};
  std::array<std::array<cv::Mat1f, 2>, 2> image;  // [index of kLevel][camera]

  EvenedPair() = default;
  explicit EvenedPair(const std::array<ImagePyramid, 2>& now);
};

class FaceTemplate {
 public:
  struct Point {
    Eigen::Vector3d mm, normal;  // Head; normal towards the cameras
  };
  /// Grey values of the points in one pair of images. Weight 0: the camera does not see the point.
  struct Appearance {
    struct Grey {
      float value = 0.f, weight = 0.f;
    };
    std::array<std::array<std::vector<Grey>, 2>, 2> grey;  // [index of EvenedPair::kLevel][camera][point]
  };
  struct Fit {
    Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();  // camera_T_head
    double likeness = 0.0;                                     // correlation over both images, -1 .. 1
  };

  /// Fewer points in view show no face.
  static constexpr std::size_t kFewestPoints = 40;

  FaceTemplate() = default;
  /// Makes it from the reference. `centre_mm`: centre of rotation of the increments, Head.
  FaceTemplate(const cameras::StereoRig& rig, const FaceRegion& region, const FaceSurface& surface,
               const Eigen::Vector3d& centre_mm);

  const std::vector<Point>& points() const { return points_; }
  const Eigen::Vector3d& centre_mm() const { return centre_mm_; }
  /// The points that a camera sees at `camera_T_head`: those that face it and are not hidden by others.
  std::vector<bool> seenBy(const cameras::CameraModel& camera, const Eigen::Isometry3d& camera_T_head) const;
  Appearance appearanceAt(const cameras::StereoRig& rig, const EvenedPair& images,
                          const Eigen::Isometry3d& motion) const;
  Fit fit(const cameras::StereoRig& rig, const Appearance& appearance, const EvenedPair& now,
          const Eigen::Isometry3d& start) const;

 private:
  /// Sums of one step of the fit, over points and cameras.
  struct Sums {
    Matrix6d normal = Matrix6d::Zero();
    Vector6d pull = Vector6d::Zero();
    double product = 0.0, now_squares = 0.0, then_squares = 0.0, seen = 0.0;
    Sums& operator+=(const Sums& other);
  };
  /// The points that one camera should see, with its model linearised near their expected places.
  class ExpectedPoints {
   public:
    void add(const Point& point, const Appearance::Grey& then, const Eigen::Matrix2d& d,
             const Eigen::Vector2d& offset);
    Sums sumsIn(const cv::Mat1f& image, const Eigen::Isometry3d& camera_T_head,
                const Eigen::Vector3d& centre_mm) const;

   private:
    std::vector<float> blocks_;  // blocks of search::TemplateView
    int count_ = 0;
  };
  ExpectedPoints expectedPoints(const cameras::StereoRig& rig, const Appearance& appearance, std::size_t l,
                                int c, const Eigen::Isometry3d& motion) const;

  std::vector<Point> points_;
  Eigen::Vector3d centre_mm_ = Eigen::Vector3d::Zero();
};

}  // namespace facenav::head_tracking
