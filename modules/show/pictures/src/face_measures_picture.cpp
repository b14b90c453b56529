#include "facenav/pictures/face_measures_picture.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "skin_canvas.h"

namespace facenav::pictures {
namespace {

using Eigen::Vector3d;

std::vector<SkinView> viewsOf(const surface::FaceLandmarks& landmarks) {
  const Vector3d r = landmarks.right.v, f = landmarks.front.v, u = landmarks.up.v;
  return {{"right side", f, -u, r}, {"front", -r, -u, f}, {"left side", -f, -u, -r}};
}

/// True if the landmark is visible in this view: on its side of the head, or near the midline and in front.
bool isSeen(const SkinView& view, const surface::FaceLandmark& landmark, const surface::FaceLandmarks& all) {
  const std::string& name = landmark.name;
  const bool is_right = name.size() > 2 && name.substr(name.size() - 2) == " R";
  const bool is_left = name.size() > 2 && name.substr(name.size() - 2) == " L";
  const bool is_ear = name.rfind("tragion", 0) == 0;
  const double turned = view.toward.dot(all.right.v);
  if (std::abs(turned) < 0.5) return !is_ear && name != "opisthocranion" && name != "inion";
  return turned > 0 ? !is_left : !is_right;
}

void drawMeasures(SkinCanvas& canvas, const surface::FaceLandmarks& landmarks,
                  const std::vector<surface::FaceMeasure>& measures) {
  for (const auto& measure : measures) {
    const auto a = landmarks.find(measure.from), b = landmarks.find(measure.to);
    if (!a || !b || measure.name.rfind("circumference", 0) == 0) continue;
    if (isSeen(canvas.view, *a, landmarks) && isSeen(canvas.view, *b, landmarks))
      cv::line(canvas.image, canvas.at(a->point.mm), canvas.at(b->point.mm), cv::Scalar(120, 170, 235), 1,
               cv::LINE_AA);
  }
  for (const auto& landmark : landmarks.points) {
    if (!isSeen(canvas.view, landmark, landmarks)) continue;
    const cv::Scalar colour = landmark.is_cut ? cv::Scalar(255, 150, 0) : cv::Scalar(60, 230, 90);
    drawDot(canvas, landmark.point.mm, landmark.name, colour);
  }
  drawTitle(canvas);
}

}  // namespace

RgbImage drawFaceMeasures(const surface::ScalpSurface& scalp, const surface::FaceLandmarks& landmarks,
                          const std::vector<surface::FaceMeasure>& measures) {
  std::vector<SkinCanvas> canvases;
  for (const SkinView& view : viewsOf(landmarks)) {
    canvases.push_back(drawSkin(view, scalp.mesh));
    drawMeasures(canvases.back(), landmarks, measures);
  }
  return sideBySide(canvases);
}

}  // namespace facenav::pictures
