#pragma once
// Antialiased lines, circles and the six orientation letters on an RgbImage. Private to scene.

#include <Eigen/Core>

#include "facenav/core/rgb_image.h"
#include "facenav/scene/palette.h"
#include "facenav/volume/slice_plane.h"

namespace facenav::scene {

/// Mixes `colour` into pixel (u, v); ignored outside the image.
void blend(RgbImage& image, int u, int v, const palette::Rgb& colour, double opacity);
void line(RgbImage& image, const Eigen::Vector2d& a_px, const Eigen::Vector2d& b_px,
          const palette::Rgb& colour, double width_px, double opacity);
void circle(RgbImage& image, const Eigen::Vector2d& centre_px, double radius_px, const palette::Rgb& colour,
            double width_px, double opacity);
/// Paints one of R L A P S I, `height_px` tall, centred.
void letter(RgbImage& image, char which, const Eigen::Vector2d& centre_px, double height_px,
            const palette::Rgb& colour);
/// Paints the patient's sides at the image's edges. `from_top`: row of the upper ones, in heights of a
/// letter.
void paintSideLetters(RgbImage& image, const volume::SlicePlane& plane, double text_scale, double from_top);

}  // namespace facenav::scene
