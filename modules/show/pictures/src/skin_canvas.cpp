#include "skin_canvas.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <opencv2/imgproc.hpp>

#include "drawn_words.h"

namespace facenav::pictures {
namespace {

using Eigen::Vector3d;

constexpr double kCanvasPixelsPerMm = 2.0;

/// Draws shaded triangles, far ones first.
void drawFacets(SkinCanvas& canvas, const surface::TriangleMesh& mesh) {
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

}  // namespace

cv::Point SkinCanvas::at(const Vector3d& p_mm) const {
  const Vector3d d = p_mm - corner_mm;
  return {int(std::lround(kCanvasPixelsPerMm * view.right.dot(d))),
          int(std::lround(kCanvasPixelsPerMm * view.down.dot(d)))};
}

SkinCanvas drawSkin(const SkinView& view, const surface::TriangleMesh& mesh, double height_mm) {
  constexpr double kMargin_mm = 30;
  double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
  for (const auto& v : mesh.vertices_mm) {
    left = std::min(left, view.right.dot(v)), right = std::max(right, view.right.dot(v));
    top = std::min(top, view.down.dot(v)), bottom = std::max(bottom, view.down.dot(v));
  }
  bottom = std::min(bottom, top + height_mm);
  SkinCanvas canvas;
  canvas.view = view;
  canvas.corner_mm = (left - kMargin_mm) * view.right + (top - kMargin_mm) * view.down;
  const auto pixels = [&](double mm) { return int(kCanvasPixelsPerMm * (mm + 2 * kMargin_mm)); };
  canvas.image = cv::Mat(pixels(bottom - top), pixels(right - left), CV_8UC3, cv::Scalar(18, 20, 24));
  drawFacets(canvas, mesh);
  return canvas;
}

void drawDot(SkinCanvas& canvas, const Vector3d& p_mm, const std::string& word, const cv::Scalar& colour) {
  const cv::Point p = canvas.at(p_mm);
  cv::circle(canvas.image, p, 4, cv::Scalar(0, 0, 0), cv::FILLED, cv::LINE_AA);
  cv::circle(canvas.image, p, 3, colour, cv::FILLED, cv::LINE_AA);
  drawFileWords(canvas.image, word, p + cv::Point(6, -4), {0.36, cv::Scalar(0, 0, 0), 2});
  drawFileWords(canvas.image, word, p + cv::Point(6, -4), {0.36, colour});
}

void drawTitle(SkinCanvas& canvas) {
  drawFileWords(canvas.image, canvas.view.title, {8, canvas.image.rows - 8},
                {0.5, cv::Scalar(200, 205, 215)});
}

RgbImage sideBySide(const std::vector<SkinCanvas>& canvases) {
  int width = 0, height = 0;
  for (const SkinCanvas& canvas : canvases) {
    width += canvas.image.cols;
    height = std::max(height, canvas.image.rows);
  }
  RgbImage picture(width, height);
  int left = 0;
  for (const SkinCanvas& canvas : canvases) {
    for (int v = 0; v < canvas.image.rows; ++v)
      std::memcpy(picture.pixel(left, v), canvas.image.ptr(v), std::size_t(canvas.image.cols) * 3);
    left += canvas.image.cols;
  }
  return picture;
}

}  // namespace facenav::pictures
