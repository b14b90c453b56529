#include "facenav/pictures/aligned_skin.h"

#include <cmath>
#include <map>
#include <opencv2/imgproc.hpp>
#include <tuple>

#include "skin_over.h"
#include "to_rgb.h"

namespace facenav::pictures {
namespace {

using Cell = std::tuple<int, int, int>;

Cell cellOf(const Eigen::Vector3d& p_mm, double edge_mm) {
  const Eigen::Vector3d at = (p_mm / edge_mm).array().floor();
  return {int(at.x()), int(at.y()), int(at.z())};
}

/// Joins the vertices of each cube into their mean.
surface::TriangleMesh thinnedSkin(const surface::TriangleMesh& mesh, double edge_mm) {
  surface::TriangleMesh thin;
  std::map<Cell, int> cells;
  std::vector<int> new_index, counts;
  for (std::size_t i = 0; i < mesh.vertices_mm.size(); ++i) {
    const auto [found, is_new] =
        cells.try_emplace(cellOf(mesh.vertices_mm[i], edge_mm), int(thin.vertices_mm.size()));
    new_index.push_back(found->second);
    if (is_new) {
      thin.vertices_mm.emplace_back(Eigen::Vector3d::Zero());
      thin.normals.emplace_back(Eigen::Vector3d::Zero());
      counts.push_back(0);
    }
    thin.vertices_mm[std::size_t(found->second)] += mesh.vertices_mm[i];
    thin.normals[std::size_t(found->second)] += mesh.normals[i];
    ++counts[std::size_t(found->second)];
  }
  for (std::size_t i = 0; i < thin.vertices_mm.size(); ++i) {
    thin.vertices_mm[i] /= counts[i];
    thin.normals[i].normalize();
  }
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3i joined(new_index[std::size_t(t[0])], new_index[std::size_t(t[1])],
                                 new_index[std::size_t(t[2])]);
    if (joined[0] != joined[1] && joined[1] != joined[2] && joined[2] != joined[0])
      thin.triangles.push_back(joined);
  }
  return thin;
}

CameraView skinOnly(CameraView view, const RigidTransform<Camera, Mri>& camera_T_mri, const AlignedSkin& skin,
                    const char* name) {
  drawSkinOver(view, camera_T_mri, skin);
  drawCaption(view, name, false);
  return view;
}

}  // namespace

AlignedSkin makeAlignedSkin(const surface::TriangleMesh& scalp, std::vector<surface::NamedPlace> places) {
  AlignedSkin skin{thinnedSkin(scalp, AlignedSkin::kMesh_mm), {}, std::move(places)};
  std::map<Cell, bool> taken;
  for (std::size_t i = 0; i < skin.mesh.vertices_mm.size(); ++i)
    if (taken.try_emplace(cellOf(skin.mesh.vertices_mm[i], AlignedSkin::kDots_mm), true).second)
      skin.dots.push_back(i);
  return skin;
}

CameraOverlay drawAlignedSkin(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                              const RigidTransform<Camera, Mri>& camera_T_mri, const AlignedSkin& skin) {
  CameraOverlay overlay;
  if (frame.left.type() == CV_8UC1 && !frame.left.empty())
    overlay.left = toRgb(skinOnly(makeView(frame.left, rig.left, Eigen::Isometry3d::Identity()), camera_T_mri,
                                  skin, "left camera")
                             .image);
  if (frame.right.type() == CV_8UC1 && !frame.right.empty())
    overlay.right = toRgb(skinOnly(makeView(frame.right, rig.right, rig.right_T_left.isometry()),
                                   camera_T_mri, skin, "right camera")
                              .image);
  return overlay;
}

}  // namespace facenav::pictures
