#include "facenav/scene/colour_scale.h"

#include <algorithm>
#include <cmath>

namespace facenav::scene {
namespace {

// The lightness (CIE L*) rises evenly from about 30 to 95.
constexpr palette::Rgb kStops[] = {
    {0.20, 0.22, 0.62}, {0.55, 0.25, 0.66}, {0.86, 0.34, 0.47}, {0.97, 0.60, 0.30}, {1.00, 0.95, 0.62}};
constexpr int kLast = 4;

}  // namespace

palette::Rgb sequentialColour(double share) {
  const double at = kLast * std::clamp(share, 0.0, 1.0);
  const int i = std::min(kLast - 1, int(at));
  palette::Rgb colour;
  for (std::size_t c = 0; c < 3; ++c) colour[c] = kStops[i][c] + (at - i) * (kStops[i + 1][c] - kStops[i][c]);
  return colour;
}

}  // namespace facenav::scene
