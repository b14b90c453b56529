#include "facenav/pictures/camera_overlay.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "camera_view.h"
#include "skin_over.h"
#include "to_rgb.h"

namespace facenav::pictures {
namespace {

void drawCorners(CameraView& view, const cv::Rect& box) {
  const int arm = std::max(6, box.width / 7);
  for (int corner = 0; corner < 4; ++corner) {
    const int sx = corner & 1 ? -1 : 1, sy = corner & 2 ? -1 : 1;
    const cv::Point at(corner & 1 ? box.br().x : box.x, corner & 2 ? box.br().y : box.y);
    cv::line(view.image, at, at + cv::Point(sx * arm, 0), kBlue, view.thickness(2), cv::LINE_AA);
    cv::line(view.image, at, at + cv::Point(0, sy * arm), kBlue, view.thickness(2), cv::LINE_AA);
  }
}

void drawFeatures(CameraView& view, const head_tracking::HeadPose& head, bool is_left) {
  const bool are_few = head.features.size() <= 20;  // few features: rings; hundreds of patches: dots
  for (const auto& feature : head.features) {
    const Eigen::Vector2d& px = is_left ? feature.left_px : feature.right_px;
    if (!px.allFinite() || px.cwiseAbs().maxCoeff() > 20000.0) continue;
    const double w = std::min(1.0, std::max(0.0, feature.weight));
    const cv::Scalar colour = kOrange * (1 - w) + kBlue * w;
    if (are_few) {
      cv::circle(view.image, CameraView::fixed(px), int(16 * 6 * view.unit), colour, view.thickness(1.6),
                 cv::LINE_AA, 4);
      cv::circle(view.image, CameraView::fixed(px), int(16 * 1.2 * view.unit), colour, cv::FILLED,
                 cv::LINE_AA, 4);
    } else {
      cv::circle(view.image, CameraView::fixed(px), int(16 * 1.6 * view.unit), colour, cv::FILLED,
                 cv::LINE_AA, 4);
    }
  }
}

void drawMarker(CameraView& view, const std::array<Eigen::Vector2d, 4>& corners) {
  std::vector<cv::Point> outline;
  for (const auto& corner : corners) outline.push_back(CameraView::fixed(corner));
  polyline(view, outline, true, kOrange, 2.2);
  cv::circle(view.image, outline[0], int(16 * 4 * view.unit), kOrange, cv::FILLED, cv::LINE_AA,
             4);  // marker's top-left corner
}

std::string caption(const session::NavigationState& state, bool is_left) {
  std::string words = is_left ? "left camera" : "right camera";
  for (const std::string& title : session::lossTitles(state)) words += "   " + title;
  return words;
}

RgbImage drawView(CameraView view, const session::NavigationState& state,
                  const std::optional<guidance::Target>& target,
                  const std::optional<AlignmentShown>& alignment, bool is_left) {
  if (alignment && state.camera_T_mri) drawSkinOver(view, *state.camera_T_mri, *alignment->skin);
  if (state.head && !alignment) {
    if (is_left && state.head->face_left) drawCorners(view, *state.head->face_left);
    drawFeatures(view, *state.head, is_left);
  }
  if (state.coil) drawMarker(view, is_left ? state.coil->left_corners_px : state.coil->right_corners_px);
  if (state.camera_T_mri && target) drawTarget(view, *state.camera_T_mri, *target);
  if (state.camera_T_coil) drawAxis(view, *state.camera_T_coil);
  if (state.camera_T_coil && alignment) drawTip(view, *state.camera_T_coil * alignment->tip, kOrange);
  if (state.camera_T_mri && alignment && alignment->spot)
    drawTip(view, *state.camera_T_mri * *alignment->spot, kWhite);
  drawCaption(view, caption(state, is_left), !state.head || !state.coil);
  return toRgb(view.image);
}

}  // namespace

CameraOverlay drawOverlay(const cameras::StereoRig& rig, const session::NavigationState& state,
                          const std::optional<guidance::Target>& target,
                          const std::optional<AlignmentShown>& alignment) {
  CameraOverlay overlay;
  if (!state.images) return overlay;
  const auto& images = *state.images;
  if (images.left.type() == CV_8UC1 && !images.left.empty())
    overlay.left = drawView(makeView(images.left, rig.left, Eigen::Isometry3d::Identity()), state, target,
                            alignment, true);
  if (images.right.type() == CV_8UC1 && !images.right.empty())
    overlay.right = drawView(makeView(images.right, rig.right, rig.right_T_left.isometry()), state, target,
                             alignment, false);
  return overlay;
}

}  // namespace facenav::pictures
