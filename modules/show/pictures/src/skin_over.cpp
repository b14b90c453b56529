#include "skin_over.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "drawn_words.h"
#include "skin_depth.h"

namespace facenav::pictures {
namespace {

constexpr int kDepthStep_px = 2;
// Slack of the depth test. At the rim the skin runs along the line of sight, so its depth is uncertain there.
constexpr double kRimSlack_mm = 5.0, kDotSlack_mm = 3.0;
constexpr double kOutside_px = 1.5 * kDepthStep_px;
constexpr double kLeastFacing = 0.3;  // cosine; hides the crowded points at the rim

/// Computes where the view grazes the smooth surface: the normals' slope towards the eye is interpolated over
/// each triangle (Hertzmann & Zorin 2000), and the contour is the line where it is 0.
std::vector<ContourPiece> contourOf(const surface::TriangleMesh& mesh, const Eigen::Matrix3d& turn,
                                    const SkinDepth& depth) {
  std::vector<double> facing;
  for (std::size_t i = 0; i < mesh.normals.size(); ++i)
    facing.push_back(-(turn * mesh.normals[i]).dot(depth.point_mm(i)));
  std::vector<ContourPiece> pieces;
  for (const auto& t : mesh.triangles) {
    Eigen::Vector2d ends[2];
    double depth_mm = 0;
    int found = 0;
    for (int side = 0; side < 3 && found < 2; ++side) {
      const auto a = std::size_t(t[side]), b = std::size_t(t[(side + 1) % 3]);
      if ((facing[a] > 0) == (facing[b] > 0)) continue;
      const double share = facing[a] / (facing[a] - facing[b]);
      ends[found++] = (1 - share) * depth.pixel(a) + share * depth.pixel(b);
      depth_mm += 0.5 * ((1 - share) * depth.point_mm(a).z() + share * depth.point_mm(b).z());
    }
    if (found < 2 || !ends[0].allFinite() || !ends[1].allFinite()) continue;
    // Tests a point just outside the rim: on the rim, the map contains skin in front of it, by centimetres on
    // a sphere.
    const Eigen::Vector3d normal = turn * (mesh.normals[std::size_t(t[0])] + mesh.normals[std::size_t(t[1])] +
                                           mesh.normals[std::size_t(t[2])]);
    const Eigen::Vector2d outside = kOutside_px * normal.head<2>().normalized();
    if (depth.isOpen(0.5 * (ends[0] + ends[1]) + outside, depth_mm, kRimSlack_mm))
      pieces.push_back({ends[0], ends[1]});
  }
  return pieces;
}

void drawDots(CameraView& view, const AlignedSkin& skin, const Eigen::Matrix3d& turn,
              const SkinDepth& depth) {
  const int radius = std::max(12, int(16 * 1.1 * view.unit));
  for (const std::size_t i : skin.dots) {
    const Eigen::Vector3d &p_mm = depth.point_mm(i), n = turn * skin.mesh.normals[i];
    if (!depth.pixel(i).allFinite() || -n.dot(p_mm) < kLeastFacing * p_mm.norm()) continue;
    if (!depth.isOpen(depth.pixel(i), p_mm.z(), kDotSlack_mm)) continue;
    cv::circle(view.image, CameraView::fixed(depth.pixel(i)), radius, kBlue, cv::FILLED, cv::LINE_AA, 4);
  }
}

void drawPlace(CameraView& view, const RigidTransform<Camera, Mri>& camera_T_mri,
               const surface::NamedPlace& place, const SkinDepth& depth) {
  constexpr double kPlaceSlack_mm = 6.0;
  const Eigen::Vector3d p_mm = view.view_T_camera * (camera_T_mri * place.point).mm;
  const auto px = view.toPixel((camera_T_mri * place.point).mm);
  if (!px) return;
  const Eigen::Vector2d at(px->x / 16.0, px->y / 16.0);
  if (!depth.isOpen(at, p_mm.z(), kPlaceSlack_mm)) return;
  const int arm = int(16 * 5 * view.unit);
  for (const cv::Point way : {cv::Point(arm, 0), cv::Point(0, arm)})
    cv::line(view.image, *px - way, *px + way, kOrange, view.thickness(1.4), cv::LINE_AA, 4);
  const cv::Point base_px(px->x / 16 + int(7 * view.unit), px->y / 16 - int(5 * view.unit));
  drawShownWords(
      view.image, place.name, base_px,
      {0.45 * view.unit, kOrange, view.thickness(0.9), cv::FONT_HERSHEY_DUPLEX, cv::LINE_AA, kDark});
}

}  // namespace

std::vector<ContourPiece> occludingContour(const surface::TriangleMesh& mesh,
                                           const Eigen::Isometry3d& view_T_mri,
                                           const cameras::CameraModel& lens, int width_px, int height_px) {
  const SkinDepth depth(mesh, view_T_mri, lens, {width_px, height_px}, kDepthStep_px);
  return contourOf(mesh, view_T_mri.linear(), depth);
}

void drawSkinOver(CameraView& view, const RigidTransform<Camera, Mri>& camera_T_mri,
                  const AlignedSkin& skin) {
  const Eigen::Isometry3d view_T_mri = view.view_T_camera * camera_T_mri.isometry();
  const SkinDepth depth(skin.mesh, view_T_mri, *view.camera, view.image.size(), kDepthStep_px);
  drawDots(view, skin, view_T_mri.linear(), depth);
  for (const auto& piece : contourOf(skin.mesh, view_T_mri.linear(), depth))
    cv::line(view.image, CameraView::fixed(piece.from_px), CameraView::fixed(piece.to_px), kBlue,
             view.thickness(1.8), cv::LINE_AA, 4);
  for (const auto& place : skin.places) drawPlace(view, camera_T_mri, place, depth);
}

void drawTip(CameraView& view, const Point<Camera>& tip, const cv::Scalar& colour) {
  const auto px = view.toPixel(tip.mm);
  if (!px) return;
  const int radius = int(16 * 7 * view.unit), gap = radius / 2;
  cv::circle(view.image, *px, radius, kDark, view.thickness(4), cv::LINE_AA, 4);
  cv::circle(view.image, *px, radius, colour, view.thickness(2), cv::LINE_AA, 4);
  for (const cv::Point way : {cv::Point(1, 0), cv::Point(0, 1), cv::Point(-1, 0), cv::Point(0, -1)})
    cv::line(view.image, *px + way * gap, *px + way * (radius + gap), colour, view.thickness(2), cv::LINE_AA,
             4);
}

}  // namespace facenav::pictures
