#include "paint.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "facenav/scene/slice_scene.h"

namespace facenav::scene {

void blend(RgbImage& image, int u, int v, const palette::Rgb& colour, double opacity) {
  if (u < 0 || v < 0 || u >= image.width_px || v >= image.height_px || opacity <= 0.0) return;
  std::uint8_t* p = image.pixel(u, v);
  for (int c = 0; c < 3; ++c) p[c] = std::uint8_t(std::lround(p[c] + opacity * (255.0 * colour[c] - p[c])));
}

namespace {

/// Paints every pixel of the box by its distance from the stroke's centre line.
template <class Distance>
void stroke(RgbImage& image, Eigen::Array2d low, Eigen::Array2d high, const palette::Rgb& colour,
            double width_px, double opacity, Distance distance) {
  low -= width_px + 1, high += width_px + 1;
  const int u0 = std::max(0, int(low.x())), u1 = std::min(image.width_px - 1, int(high.x()) + 1);
  const int v0 = std::max(0, int(low.y())), v1 = std::min(image.height_px - 1, int(high.y()) + 1);
  for (int v = v0; v <= v1; ++v)
    for (int u = u0; u <= u1; ++u)
      blend(image, u, v, colour,
            opacity * std::clamp(0.5 * width_px + 0.5 - distance(Eigen::Vector2d(u, v)), 0.0, 1.0));
}

}  // namespace

void line(RgbImage& image, const Eigen::Vector2d& a_px, const Eigen::Vector2d& b_px,
          const palette::Rgb& colour, double width_px, double opacity) {
  if (!a_px.allFinite() || !b_px.allFinite()) return;
  const Eigen::Vector2d along = b_px - a_px;
  const double length_squared = std::max(1e-12, along.squaredNorm());
  stroke(image, a_px.cwiseMin(b_px), a_px.cwiseMax(b_px), colour, width_px, opacity,
         [&](const Eigen::Vector2d& p) {
           const double t = std::clamp((p - a_px).dot(along) / length_squared, 0.0, 1.0);
           return (p - a_px - t * along).norm();
         });
}

void circle(RgbImage& image, const Eigen::Vector2d& centre_px, double radius_px, const palette::Rgb& colour,
            double width_px, double opacity) {
  if (!centre_px.allFinite()) return;
  const Eigen::Array2d r(radius_px, radius_px);
  stroke(image, centre_px.array() - r, centre_px.array() + r, colour, width_px, opacity,
         [&](const Eigen::Vector2d& p) { return std::abs((p - centre_px).norm() - radius_px); });
}

void letter(RgbImage& image, char which, const Eigen::Vector2d& centre_px, double height_px,
            const palette::Rgb& colour) {
  using Path = std::vector<Eigen::Vector2d>;  // x right, y down, within -0.35..0.35 by -0.5..0.5
  std::vector<Path> paths;
  switch (which) {
    case 'R':
      paths = {{{-.3, .5}, {-.3, -.5}, {.1, -.5}, {.3, -.35}, {.3, -.15}, {.1, 0}, {-.3, 0}},
               {{0, 0}, {.32, .5}}};
      break;
    case 'L':
      paths = {{{-.28, -.5}, {-.28, .5}, {.3, .5}}};
      break;
    case 'A':
      paths = {{{-.35, .5}, {0, -.5}, {.35, .5}}, {{-.22, .15}, {.22, .15}}};
      break;
    case 'P':
      paths = {{{-.3, .5}, {-.3, -.5}, {.1, -.5}, {.3, -.35}, {.3, -.12}, {.1, .03}, {-.3, .03}}};
      break;
    case 'S':
      paths = {{{.3, -.35},
                {.12, -.5},
                {-.12, -.5},
                {-.3, -.35},
                {-.3, -.15},
                {-.12, 0},
                {.12, 0},
                {.3, .15},
                {.3, .35},
                {.12, .5},
                {-.12, .5},
                {-.3, .35}}};
      break;
    case 'I':
      paths = {{{0, -.5}, {0, .5}}, {{-.18, -.5}, {.18, -.5}}, {{-.18, .5}, {.18, .5}}};
      break;
    default:
      return;
  }
  for (const auto& path : paths)
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
      line(image, centre_px + height_px * path[i], centre_px + height_px * path[i + 1], colour,
           std::max(1.2, height_px / 8), 1.0);
}

void paintSideLetters(RgbImage& image, const volume::SlicePlane& plane, double text_scale, double from_top) {
  const double w = image.width_px, h = image.height_px;
  const double size = std::clamp(0.045 * h * text_scale, 9.0 * text_scale, 18.0 * text_scale);
  const auto word = [&](const Direction<Mri>& side, double u, double v, double anchor) {
    const std::string letters = sideLetters(side);
    double at_u = u - anchor * size * double(letters.size() - 1);
    for (const char each : letters) {
      letter(image, each, {at_u, v}, size, palette::kText);
      at_u += size;
    }
  };
  word(Direction<Mri>(-plane.right.v), size, h / 2, 0.0);
  word(plane.right, w - size, h / 2, 1.0);
  word(Direction<Mri>(-plane.down.v), w / 2, from_top * size, 0.5);
  word(plane.down, w / 2, h - size, 0.5);
}

}  // namespace facenav::scene
