#include "camera_view.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "drawn_words.h"

namespace facenav::pictures {

std::optional<cv::Point> CameraView::toPixel(const Eigen::Vector3d& p_camera_mm) const {
  const Eigen::Vector3d p = view_T_camera * p_camera_mm;
  if (p.z() < 10.0) return std::nullopt;
  const Eigen::Vector2d px = cameras::project(*camera, p);
  if (!px.allFinite() || px.cwiseAbs().maxCoeff() > 20000.0) return std::nullopt;
  return fixed(px);
}

cv::Point CameraView::fixed(const Eigen::Vector2d& px) {
  return {int(std::lround(px.x() * 16)), int(std::lround(px.y() * 16))};
}

int CameraView::thickness(double width) const { return std::max(1, int(std::lround(width * unit))); }

CameraView makeView(const cv::Mat& grey, const cameras::CameraModel& camera,
                    const Eigen::Isometry3d& view_T_camera) {
  CameraView view{{}, &camera, view_T_camera, grey.rows / 480.0};
  cv::cvtColor(grey, view.image, cv::COLOR_GRAY2RGB);
  return view;
}

void polyline(CameraView& view, const std::vector<cv::Point>& points, bool is_closed,
              const cv::Scalar& colour, double width) {
  cv::polylines(view.image, points, is_closed, colour, view.thickness(width), cv::LINE_AA, 4);
}

void drawLine(CameraView& view, const Eigen::Vector3d& a_mm, const Eigen::Vector3d& b_mm,
              const cv::Scalar& colour, double width) {
  const auto a = view.toPixel(a_mm), b = view.toPixel(b_mm);
  if (a && b) cv::line(view.image, *a, *b, colour, view.thickness(width), cv::LINE_AA, 4);
}

void drawTarget(CameraView& view, const RigidTransform<Camera, Mri>& camera_T_mri,
                const guidance::Target& target) {
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

void drawAxis(CameraView& view, const RigidTransform<Camera, Coil>& camera_T_coil) {
  drawLine(view, (camera_T_coil * Point<Coil>(0, 0, -30)).mm, (camera_T_coil * Point<Coil>(0, 0, 45)).mm,
           kBlue, 2.5);
}

void drawCaption(CameraView& view, const std::string& words, bool is_lost) {
  const Letters letters{0.52 * view.unit, is_lost ? kOrange : kGrey, view.thickness(1),
                        cv::FONT_HERSHEY_DUPLEX};
  const cv::Size size = sizeOfWords(words, letters);
  const int pad = int(7 * view.unit);
  cv::Mat band =
      view.image(cv::Rect(0, 0, view.image.cols, std::min(view.image.rows, size.height + 3 * pad)));
  cv::addWeighted(band, 0.30, cv::Mat(band.size(), band.type(), kDark), 0.70, 0, band);
  drawShownWords(view.image, words, {pad + pad / 2, size.height + pad + pad / 2}, letters);
}

}  // namespace facenav::pictures
