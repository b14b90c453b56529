#include "facenav/pictures/surface_distance_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "drawn_words.h"
#include "to_rgb.h"

namespace facenav::pictures {
namespace {

using Eigen::Vector3d;

constexpr double kDistancePixelsPerMm = 2.0;
constexpr int kFiner = 2;    // scale of drawing before averaging
constexpr int kDisc_px = 2;  // half width of a vertex' square; vertices are up to 1.4 mm apart
constexpr int kMargin_px = 12, kTitle_px = 16, kLegendHeight_px = 74;

/// One orthographic view: image right, image down, towards the viewer; Mri directions.
struct BrainSide {
  const char* title;
  Vector3d right, down, toward;
};

const std::array<BrainSide, 6>& views() {
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  static const std::array<BrainSide, 6> all{{{"left side", -y, -z, -x},
                                             {"right side", y, -z, x},
                                             {"from above (right on the right)", x, -y, z},
                                             {"front (right on the left)", -x, -z, y},
                                             {"back (right on the right)", x, -z, -y},
                                             {"from below (right on the left)", -x, -y, -z}}};
  return all;
}

/// Draws vertices as small squares shaded by their normals; the one nearest to the viewer is visible.
cv::Mat drawn(const BrainSide& view, const surface::DetailedCortex& cortex,
              const std::vector<cv::Vec3b>& colours) {
  const auto& mesh = cortex.mesh;
  const double scale = kDistancePixelsPerMm * kFiner;
  Eigen::Array2d low(1e9, 1e9), high(-1e9, -1e9);
  for (const Vector3d& p : mesh.vertices_mm) {
    const Eigen::Array2d at(view.right.dot(p), view.down.dot(p));
    low = low.min(at), high = high.max(at);
  }
  const Eigen::Array2i size = ((high - low) * scale).cast<int>() + 2 * (kMargin_px * kFiner) +
                              Eigen::Array2i(1, 1 + kTitle_px * kFiner);
  cv::Mat image(size[1], size[0], CV_8UC3, cv::Scalar(18, 20, 24));
  cv::Mat depth(size[1], size[0], CV_32F, cv::Scalar(-std::numeric_limits<float>::max()));
  const Vector3d light = (view.toward - 0.45 * view.down - 0.3 * view.right).normalized();
  for (std::size_t v = 0; v < mesh.vertices_mm.size(); ++v) {
    const Vector3d& p = mesh.vertices_mm[v];
    if (view.toward.dot(mesh.normals[v]) < 0) continue;
    const int u = int((view.right.dot(p) - low[0]) * scale) + kMargin_px * kFiner,
              w = int((view.down.dot(p) - low[1]) * scale) + (kMargin_px + kTitle_px) * kFiner;
    const auto near = float(view.toward.dot(p));
    const double shade = 0.35 + 0.65 * std::max(0.0, mesh.normals[v].dot(light));
    const cv::Vec3b colour(cv::saturate_cast<uchar>(shade * colours[v][0]),
                           cv::saturate_cast<uchar>(shade * colours[v][1]),
                           cv::saturate_cast<uchar>(shade * colours[v][2]));
    for (int r = w - kDisc_px; r <= w + kDisc_px; ++r)
      for (int c = u - kDisc_px; c <= u + kDisc_px; ++c)
        if (float& deepest = depth.at<float>(r, c); near > deepest)
          deepest = near, image.at<cv::Vec3b>(r, c) = colour;
  }
  cv::Mat small;
  cv::resize(image, small, {}, 1.0 / kFiner, 1.0 / kFiner, cv::INTER_AREA);
  drawFileWords(small, view.title, {8, 14}, {0.42, cv::Scalar(200, 205, 215)});
  return small;
}

cv::Vec3b bytes(const std::array<double, 3>& colour) {
  return {uchar(std::lround(255 * colour[0])), uchar(std::lround(255 * colour[1])),
          uchar(std::lround(255 * colour[2]))};
}

void drawLegend(cv::Mat strip, const surface::ModelDistance& figures, double full_mm,
                const DistanceColour& colour) {
  const cv::Scalar ink(215, 220, 228);
  const auto write = [&](const std::string& text, const cv::Point& at) {
    drawFileWords(strip, text, at, {0.42, ink});
  };
  constexpr int kLeft = 14, kWidth = 360, kTop = 12, kBottom = 30;
  for (int c = 0; c <= kWidth; ++c) {
    const cv::Vec3b of = bytes(colour((2.0 * c / kWidth - 1) * full_mm));
    cv::line(strip, {kLeft + c, kTop}, {kLeft + c, kBottom}, cv::Scalar(of[0], of[1], of[2]));
  }
  char text[160];
  for (const double share : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
    std::snprintf(text, sizeof text, "%+.0f", share * full_mm);
    const int middle = kLeft + int((share + 1) / 2 * kWidth);
    write(share == 0 ? "0 mm" : text, {std::max(2, middle - 14), kBottom + 15});
  }
  write("within the phi-theta surface", {kLeft, kBottom + 34});
  write("outside it", {kLeft + kWidth - 66, kBottom + 34});
  const auto line = [&](const char* what, const surface::SurfaceDistance& d, int row) {
    std::snprintf(text, sizeof text, "%s: median %.1f mm, 95 %% below %.1f mm", what, d.median_mm, d.p95_mm);
    write(text, {kLeft + kWidth + 50, kTop + 14 + 22 * row});
  };
  line("cortex (folds included) to the phi-theta surface", figures.cortex_to_model, 0);
  line("phi-theta surface to the cortex", figures.model_to_cortex, 1);
}

}  // namespace

RgbImage drawSurfaceDistance(const surface::DetailedCortex& cortex, const surface::ModelDistance& figures,
                             double full_mm, const DistanceColour& colour) {
  if (cortex.mesh.vertices_mm.empty()) return {};
  std::vector<cv::Vec3b> colours;
  for (const float d : cortex.distance_mm) colours.push_back(bytes(colour(d)));
  std::array<cv::Mat, 6> tiles;
  int width = 0, height = 0;
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    tiles[t] = drawn(views()[t], cortex, colours);
    width = std::max(width, tiles[t].cols), height = std::max(height, tiles[t].rows);
  }
  cv::Mat sheet(2 * height + kLegendHeight_px, 3 * width, CV_8UC3, cv::Scalar(18, 20, 24));
  for (int t = 0; t < 6; ++t)
    tiles[std::size_t(t)].copyTo(sheet(
        cv::Rect((t % 3) * width, (t / 3) * height, tiles[std::size_t(t)].cols, tiles[std::size_t(t)].rows)));
  drawLegend(sheet.rowRange(2 * height, sheet.rows), figures, full_mm, colour);
  return toRgb(sheet);
}

}  // namespace facenav::pictures
