#include "facenav/pictures/pose_overlay.h"

#include <algorithm>
#include <cstdint>
#include <opencv2/imgproc.hpp>

#include "camera_view.h"
#include "to_rgb.h"

namespace facenav::pictures {
namespace {

constexpr double kHandleEnd_mm = 110;

/// Draws the outline of the scalp's silhouette: fills the mesh on an empty picture and draws its edge, so
/// that hidden folds leave no lines.
void drawScalp(CameraView& view, const RigidTransform<Camera, Mri>& camera_T_mri,
               const surface::TriangleMesh& scalp) {
  std::vector<std::optional<cv::Point>> px(scalp.vertices_mm.size());
  for (std::size_t i = 0; i < px.size(); ++i)
    px[i] = view.toPixel((camera_T_mri * Point<Mri>(scalp.vertices_mm[i])).mm);
  cv::Mat inside = cv::Mat::zeros(view.image.size(), CV_8UC1);
  for (const auto& triangle : scalp.triangles) {
    const auto &a = px[std::size_t(triangle[0])], &b = px[std::size_t(triangle[1])],
               &c = px[std::size_t(triangle[2])];
    if (!a || !b || !c) continue;
    const cv::Point ab = *b - *a, ac = *c - *a;
    if (std::int64_t(ab.x) * ac.y - std::int64_t(ab.y) * ac.x > 0) continue;  // seen from behind
    const cv::Point corners[3] = {*a, *b, *c};
    cv::fillConvexPoly(inside, corners, 3, cv::Scalar(255), cv::LINE_8, 4);
  }
  std::vector<std::vector<cv::Point>> rims;
  cv::findContours(inside, rims, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  cv::drawContours(view.image, rims, -1, kBlue, view.thickness(1.2), cv::LINE_AA);
}

/// Draws the plate's outline on the contact face, the handle behind it, and the axis.
void drawCoil(CameraView& view, const RigidTransform<Camera, Coil>& camera_T_coil,
              const guidance::CoilPlate& plate) {
  std::vector<cv::Point> outline;
  double back_mm = 0;
  for (const auto& corner : plate.outline_mm) {
    const auto px = view.toPixel((camera_T_coil * Point<Coil>(corner.x(), corner.y(), 0)).mm);
    if (!px) return;
    outline.push_back(*px);
    back_mm = std::min(back_mm, corner.y());
  }
  polyline(view, outline, true, kOrange, 2);
  drawLine(view, (camera_T_coil * Point<Coil>(0, back_mm, 0)).mm,
           (camera_T_coil * Point<Coil>(0, -kHandleEnd_mm, 0)).mm, kOrange, 2);
  drawAxis(view, camera_T_coil);
}

RgbImage drawPosesIn(CameraView view, const char* name, const StoredPoses& poses,
                     const surface::TriangleMesh& scalp, const guidance::CoilPlate& plate) {
  if (poses.camera_T_mri) drawScalp(view, *poses.camera_T_mri, scalp);
  if (poses.camera_T_mri && poses.target) drawTarget(view, *poses.camera_T_mri, *poses.target);
  if (poses.camera_T_coil) drawCoil(view, *poses.camera_T_coil, plate);
  drawCaption(view, name + (poses.loss.empty() ? std::string() : "   " + poses.loss), !poses.loss.empty());
  return toRgb(view.image);
}

}  // namespace

CameraOverlay drawPoses(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                        const StoredPoses& poses, const surface::TriangleMesh& scalp,
                        const guidance::CoilPlate& plate) {
  CameraOverlay overlay;
  if (frame.left.type() == CV_8UC1 && !frame.left.empty())
    overlay.left = drawPosesIn(makeView(frame.left, rig.left, Eigen::Isometry3d::Identity()), "left camera",
                               poses, scalp, plate);
  if (frame.right.type() == CV_8UC1 && !frame.right.empty())
    overlay.right = drawPosesIn(makeView(frame.right, rig.right, rig.right_T_left.isometry()), "right camera",
                                poses, scalp, plate);
  return overlay;
}

}  // namespace facenav::pictures
