#pragma once
// SceneCamera: the viewpoint of the 3-D picture, in the head's own axes or at the left camera's position.
// Private to scene.

#include <optional>

#include "facenav/guidance/target.h"
#include "facenav/scene/navigation_scene.h"
#include "facenav/surface/triangle_mesh.h"

class vtkCamera;

namespace facenav::scene {

class SceneCamera {
 public:
  explicit SceneCamera(vtkCamera* camera);
  /// Sets centre and size of the scene; an empty mesh changes nothing.
  void fit(const surface::TriangleMesh& scalp);
  void setAngle(double vertical_rad) { angle_rad_ = vertical_rad; }
  /// Places the camera for a preset; World = Mri.
  void place(ViewPreset preset, const std::optional<guidance::Target>& active);
  /// Places the camera at the left camera's position, with its angle of view; World = Camera.
  void placeInCamera();

 private:
  void place(const Eigen::Vector3d& from, const Eigen::Vector3d& up, const Eigen::Vector3d& at_mm,
             double distance);
  void placeOverTarget(const guidance::Target& target);

  vtkCamera* camera_;
  double angle_rad_ = 0.58, radius_mm_ = 110.0;
  Eigen::Vector3d centre_mm_ = Eigen::Vector3d::Zero();
};

}  // namespace facenav::scene
