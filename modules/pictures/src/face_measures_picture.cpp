#include "facenav/pictures/face_measures_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <opencv2/imgproc.hpp>

namespace facenav::pictures {
namespace {

using Eigen::Vector3d;

constexpr double kPixelsPerMm = 2.0;

/// One orthographic view: image right, image down, towards the viewer; Mri directions.
struct FaceSide {
  const char* title;
  Vector3d right, down, toward;
};

std::vector<FaceSide> viewsOf(const surface::FaceLandmarks& landmarks) {
  const Vector3d r = landmarks.right.v, f = landmarks.front.v, u = landmarks.up.v;
  return {{"right side", f, -u, r}, {"front", -r, -u, f}, {"left side", -f, -u, -r}};
}

struct Canvas {
  FaceSide view;
  cv::Mat image;  // 8-bit, 3 channels, R G B
  Vector3d corner_mm;

  cv::Point at(const Vector3d& p_mm) const {
    const Vector3d d = p_mm - corner_mm;
    return {int(std::lround(kPixelsPerMm * view.right.dot(d))),
            int(std::lround(kPixelsPerMm * view.down.dot(d)))};
  }
};

/// Shaded triangles, far ones drawn first.
void drawSkin(Canvas& canvas, const surface::TriangleMesh& mesh) {
  struct Facet {
    double depth_mm;
    std::size_t triangle;
  };
  std::vector<Facet> facets;
  const auto corner = [&](std::size_t t, int k) -> const Vector3d& {
    return mesh.vertices_mm[std::size_t(mesh.triangles[t][k])];
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vector3d normal = (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0));
    if (canvas.view.toward.dot(normal) > 0) facets.push_back({canvas.view.toward.dot(corner(t, 0)), t});
  }
  std::sort(facets.begin(), facets.end(),
            [](const Facet& a, const Facet& b) { return a.depth_mm < b.depth_mm; });
  const Vector3d light =
      (canvas.view.toward - 0.5 * canvas.view.down - 0.35 * canvas.view.right).normalized();
  for (const Facet& facet : facets) {
    cv::Point outline[3];
    Vector3d normal = Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      outline[k] = canvas.at(corner(facet.triangle, k));
      normal += mesh.normals[std::size_t(mesh.triangles[facet.triangle][k])];
    }
    const double shade = 50 + 175 * std::max(0.0, normal.normalized().dot(light));
    cv::fillConvexPoly(canvas.image, outline, 3, cv::Scalar(shade, 0.93 * shade, 0.86 * shade), cv::LINE_8);
  }
}

Canvas makeCanvas(const FaceSide& view, const surface::TriangleMesh& mesh) {
  constexpr double kMargin_mm = 30, kHeadHeight_mm = 260;
  double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
  for (const auto& v : mesh.vertices_mm) {
    left = std::min(left, view.right.dot(v)), right = std::max(right, view.right.dot(v));
    top = std::min(top, view.down.dot(v)), bottom = std::max(bottom, view.down.dot(v));
  }
  bottom = std::min(bottom, top + kHeadHeight_mm);
  Canvas canvas;
  canvas.view = view;
  canvas.corner_mm = (left - kMargin_mm) * view.right + (top - kMargin_mm) * view.down;
  const auto pixels = [&](double mm) { return int(kPixelsPerMm * (mm + 2 * kMargin_mm)); };
  canvas.image = cv::Mat(pixels(bottom - top), pixels(right - left), CV_8UC3, cv::Scalar(18, 20, 24));
  drawSkin(canvas, mesh);
  return canvas;
}

/// True if the landmark is visible in this view: on its side of the head, or near the midline and in front.
bool isSeen(const FaceSide& view, const surface::FaceLandmark& landmark, const surface::FaceLandmarks& all) {
  const std::string& name = landmark.name;
  const bool is_right = name.size() > 2 && name.substr(name.size() - 2) == " R";
  const bool is_left = name.size() > 2 && name.substr(name.size() - 2) == " L";
  const bool is_ear = name.rfind("tragion", 0) == 0;
  const double turned = view.toward.dot(all.right.v);
  if (std::abs(turned) < 0.5) return !is_ear && name != "opisthocranion";
  return turned > 0 ? !is_left : !is_right;
}

void drawMeasures(Canvas& canvas, const surface::FaceLandmarks& landmarks,
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
    const cv::Point p = canvas.at(landmark.point.mm);
    const cv::Scalar colour = landmark.is_cut ? cv::Scalar(255, 150, 0) : cv::Scalar(60, 230, 90);
    cv::circle(canvas.image, p, 4, cv::Scalar(0, 0, 0), cv::FILLED, cv::LINE_AA);
    cv::circle(canvas.image, p, 3, colour, cv::FILLED, cv::LINE_AA);
    cv::putText(canvas.image, landmark.name, p + cv::Point(6, -4), cv::FONT_HERSHEY_SIMPLEX, 0.36,
                cv::Scalar(0, 0, 0), 2, cv::LINE_AA);
    cv::putText(canvas.image, landmark.name, p + cv::Point(6, -4), cv::FONT_HERSHEY_SIMPLEX, 0.36, colour, 1,
                cv::LINE_AA);
  }
  cv::putText(canvas.image, canvas.view.title, {8, canvas.image.rows - 8}, cv::FONT_HERSHEY_SIMPLEX, 0.5,
              cv::Scalar(200, 205, 215), 1, cv::LINE_AA);
}

}  // namespace

RgbImage drawFaceMeasures(const surface::ScalpSurface& scalp, const surface::FaceLandmarks& landmarks,
                          const std::vector<surface::FaceMeasure>& measures) {
  std::vector<Canvas> canvases;
  int width = 0, height = 0;
  for (const FaceSide& view : viewsOf(landmarks)) {
    canvases.push_back(makeCanvas(view, scalp.mesh));
    drawMeasures(canvases.back(), landmarks, measures);
    width += canvases.back().image.cols;
    height = std::max(height, canvases.back().image.rows);
  }
  RgbImage picture(width, height);
  int left = 0;
  for (const Canvas& canvas : canvases) {
    for (int v = 0; v < canvas.image.rows; ++v)
      std::memcpy(picture.pixel(left, v), canvas.image.ptr(v), std::size_t(canvas.image.cols) * 3);
    left += canvas.image.cols;
  }
  return picture;
}

}  // namespace facenav::pictures
