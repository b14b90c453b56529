#include "scene_camera.h"

#include <vtkCamera.h>

#include <Eigen/Geometry>
#include <cmath>

#include "facenav/geometry/rotation.h"

namespace facenav::scene {
namespace {

constexpr double kDistance_mm = 540.0;  // a head of 110 mm half height fills the view
constexpr double kViewAngle_deg = 28.0;
const Eigen::Vector3d kLeftFront(-0.75, 0.8, 0.42);

}  // namespace

SceneCamera::SceneCamera(vtkCamera* camera) : camera_(camera) { camera_->SetViewAngle(kViewAngle_deg); }

void SceneCamera::fit(const surface::TriangleMesh& scalp) {
  if (scalp.vertices_mm.empty()) return;
  Eigen::AlignedBox3d box;
  for (const auto& v : scalp.vertices_mm) box.extend(v);
  // Limits the height, so that neck and shoulders in the scan do not make the head smaller.
  box.min().z() = std::max(box.min().z(), box.max().z() - 235.0);
  centre_mm_ = box.center();
  radius_mm_ = std::max(40.0, 0.5 * box.sizes().maxCoeff());
}

void SceneCamera::place(const Eigen::Vector3d& from, const Eigen::Vector3d& up, const Eigen::Vector3d& at_mm,
                        double distance) {
  const Eigen::Vector3d position = at_mm + from.normalized() * distance * kDistance_mm * radius_mm_ / 110.0;
  camera_->SetViewAngle(kViewAngle_deg);
  camera_->SetFocalPoint(at_mm.data());
  camera_->SetPosition(position.data());
  camera_->SetViewUp(up.data());
  camera_->OrthogonalizeViewUp();
}

void SceneCamera::placeOverTarget(const guidance::Target& target) {
  // The view is oblique to the coil's axis and from the front, so that axis, ring and face are all visible.
  const Eigen::Vector3d out = -target.mri_T_target.rotation().col(2);
  const Eigen::Vector3d at_mm = centre_mm_ + 0.28 * radius_mm_ * out;  // leaves room for the coil
  place(out * 0.35 + Eigen::Vector3d(out.x() < 0 ? -0.62 : 0.62, 0.85, 0.0), {0, 0, 1}, at_mm, 1.05);
}

void SceneCamera::place(ViewPreset preset, const std::optional<guidance::Target>& active) {
  const auto from = [this](const Eigen::Vector3d& direction, const Eigen::Vector3d& up = {0, 0, 1}) {
    place(direction, up, centre_mm_, 1.0);
  };
  switch (preset) {  // Mri: x right, y anterior, z superior
    case ViewPreset::front:
      return from({0, 1, 0.05});
    case ViewPreset::back:
      return from({0, -1, 0.05});
    case ViewPreset::left:
      return from({-1, 0, 0.05});
    case ViewPreset::right:
      return from({1, 0, 0.05});
    case ViewPreset::top:
      return from({0, 0, 1}, {0, 1, 0});
    case ViewPreset::right_front:
      return from({0.75, 0.8, 0.42});
    case ViewPreset::left_front:
      return from(kLeftFront);
    case ViewPreset::target:
      return active ? placeOverTarget(*active) : from(kLeftFront);
  }
}

void SceneCamera::placeInCamera() {
  camera_->SetPosition(0, 0, 0);
  camera_->SetFocalPoint(0, 0, 1);
  camera_->SetViewUp(0, -1, 0);  // Camera's y points down
  camera_->SetViewAngle(angle_rad_ * kDegPerRad);
}

}  // namespace facenav::scene
