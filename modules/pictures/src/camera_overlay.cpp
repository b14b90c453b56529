#include "facenav/pictures/camera_overlay.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "to_rgb.h"

namespace facenav::pictures {
namespace {

const cv::Scalar kBlue(84, 178, 255), kOrange(255, 160, 51), kGrey(175, 180, 188),
    kDark(12, 14, 18);  // R, G, B

struct View {
  cv::Mat image;  // 8-bit RGB
  const cameras::CameraModel* camera;
  Eigen::Isometry3d view_T_camera;
  double unit;  // scale of line widths and letters: 1 at 480 rows

  std::optional<cv::Point> toPixel(const Eigen::Vector3d& p_camera_mm) const {
    const Eigen::Vector3d p = view_T_camera * p_camera_mm;
    if (p.z() < 10.0) return std::nullopt;
    const Eigen::Vector2d px = cameras::project(*camera, p);
    if (!px.allFinite() || px.cwiseAbs().maxCoeff() > 20000.0) return std::nullopt;
    return fixed(px);
  }
  /// In 1/16 px, for cv's drawing with shift 4.
  static cv::Point fixed(const Eigen::Vector2d& px) {
    return {int(std::lround(px.x() * 16)), int(std::lround(px.y() * 16))};
  }
  int thickness(double width) const { return std::max(1, int(std::lround(width * unit))); }
};

View makeView(const cv::Mat& grey, const cameras::CameraModel& camera,
              const Eigen::Isometry3d& view_T_camera) {
  View view{{}, &camera, view_T_camera, grey.rows / 480.0};
  cv::cvtColor(grey, view.image, cv::COLOR_GRAY2RGB);
  return view;
}

void polyline(View& view, const std::vector<cv::Point>& points, bool is_closed, const cv::Scalar& colour,
              double width) {
  cv::polylines(view.image, points, is_closed, colour, view.thickness(width), cv::LINE_AA, 4);
}

void drawCorners(View& view, const cv::Rect& box) {
  const int arm = std::max(6, box.width / 7);
  for (int corner = 0; corner < 4; ++corner) {
    const int sx = corner & 1 ? -1 : 1, sy = corner & 2 ? -1 : 1;
    const cv::Point at(corner & 1 ? box.br().x : box.x, corner & 2 ? box.br().y : box.y);
    cv::line(view.image, at, at + cv::Point(sx * arm, 0), kBlue, view.thickness(2), cv::LINE_AA);
    cv::line(view.image, at, at + cv::Point(0, sy * arm), kBlue, view.thickness(2), cv::LINE_AA);
  }
}

void drawFeatures(View& view, const head_tracking::HeadPose& head, bool is_left) {
  const bool are_few = head.features.size() <= 20;  // few features: rings; hundreds of patches: dots
  for (const auto& feature : head.features) {
    const Eigen::Vector2d& px = is_left ? feature.left_px : feature.right_px;
    if (!px.allFinite() || px.cwiseAbs().maxCoeff() > 20000.0) continue;
    const double w = std::min(1.0, std::max(0.0, feature.weight));
    const cv::Scalar colour = kOrange * (1 - w) + kBlue * w;
    if (are_few) {
      cv::circle(view.image, View::fixed(px), int(16 * 6 * view.unit), colour, view.thickness(1.6),
                 cv::LINE_AA, 4);
      cv::circle(view.image, View::fixed(px), int(16 * 1.2 * view.unit), colour, cv::FILLED, cv::LINE_AA, 4);
    } else {
      cv::circle(view.image, View::fixed(px), int(16 * 1.6 * view.unit), colour, cv::FILLED, cv::LINE_AA, 4);
    }
  }
}

void drawMarker(View& view, const std::array<Eigen::Vector2d, 4>& corners) {
  std::vector<cv::Point> outline;
  for (const auto& corner : corners) outline.push_back(View::fixed(corner));
  polyline(view, outline, true, kOrange, 2.2);
  cv::circle(view.image, outline[0], int(16 * 4 * view.unit), kOrange, cv::FILLED, cv::LINE_AA,
             4);  // marker's top-left corner
}

void drawLine(View& view, const Eigen::Vector3d& a_mm, const Eigen::Vector3d& b_mm, const cv::Scalar& colour,
              double width) {
  const auto a = view.toPixel(a_mm), b = view.toPixel(b_mm);
  if (a && b) cv::line(view.image, *a, *b, colour, view.thickness(width), cv::LINE_AA, 4);
}

void drawTarget(View& view, const RigidTransform<Camera, Mri>& camera_T_mri, const guidance::Target& target) {
  const Eigen::Isometry3d place = (camera_T_mri * target.mri_T_target).isometry();
  std::vector<cv::Point> ring;
  for (int i = 0; i < 48; ++i) {
    const double angle = 2 * M_PI * i / 48;
    if (const auto px = view.toPixel(place * Eigen::Vector3d(9 * std::cos(angle), 9 * std::sin(angle), 0)))
      ring.push_back(*px);
  }
  if (ring.size() == 48) polyline(view, ring, true, kOrange, 2);
  drawLine(view, place.translation(), (camera_T_mri * target.cortex_point).mm, kOrange, 1.5);
}

void drawCaption(View& view, const std::string& words, bool is_lost) {
  const double scale = 0.52 * view.unit;
  int below = 0;
  const cv::Size size = cv::getTextSize(words, cv::FONT_HERSHEY_DUPLEX, scale, view.thickness(1), &below);
  const int pad = int(7 * view.unit);
  cv::Mat band =
      view.image(cv::Rect(0, 0, view.image.cols, std::min(view.image.rows, size.height + 3 * pad)));
  cv::addWeighted(band, 0.30, cv::Mat(band.size(), band.type(), kDark), 0.70, 0, band);
  cv::putText(view.image, words, {pad + pad / 2, size.height + pad + pad / 2}, cv::FONT_HERSHEY_DUPLEX, scale,
              is_lost ? kOrange : kGrey, view.thickness(1), cv::LINE_AA);
}

std::string caption(const session::NavigationState& state, bool is_left) {
  std::string words = is_left ? "left camera" : "right camera";
  for (const std::string& title : session::lossTitles(state)) words += "   " + title;
  return words;
}

RgbImage drawView(View view, const session::NavigationState& state,
                  const std::optional<guidance::Target>& target, bool is_left) {
  if (state.head) {
    if (is_left && state.head->face_left) drawCorners(view, *state.head->face_left);
    drawFeatures(view, *state.head, is_left);
  }
  if (state.coil) drawMarker(view, is_left ? state.coil->left_corners_px : state.coil->right_corners_px);
  if (state.camera_T_mri && target) drawTarget(view, *state.camera_T_mri, *target);
  if (state.camera_T_coil)
    drawLine(view, (*state.camera_T_coil * Point<Coil>(0, 0, -30)).mm,
             (*state.camera_T_coil * Point<Coil>(0, 0, 45)).mm, kBlue, 2.5);
  drawCaption(view, caption(state, is_left), !state.head || !state.coil);
  return toRgb(view.image);
}

}  // namespace

CameraOverlay drawOverlay(const cameras::StereoRig& rig, const session::NavigationState& state,
                          const std::optional<guidance::Target>& target) {
  CameraOverlay overlay;
  if (!state.images) return overlay;
  const auto& images = *state.images;
  if (images.left.type() == CV_8UC1 && !images.left.empty())
    overlay.left =
        drawView(makeView(images.left, rig.left, Eigen::Isometry3d::Identity()), state, target, true);
  if (images.right.type() == CV_8UC1 && !images.right.empty())
    overlay.right =
        drawView(makeView(images.right, rig.right, rig.right_T_left.isometry()), state, target, false);
  return overlay;
}

}  // namespace facenav::pictures
