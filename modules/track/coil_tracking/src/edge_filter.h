#pragma once
// EdgeFilter: where a black/white edge crosses a row (or column) of pixels, near the Cramer-Rao bound. It
// uses the row's own pixels: bilinear interpolation would shift an edge along the rows by up to 0.02 px,
// everywhere alike. Least squares of
//   grey(x) = white + contrast * S + a * S' + b * dS/dsigma
// (S: step at the predicted place, blurred by sigma) gives the edge's offset -a / contrast. The last term
// accounts for a blur other than the table's (three taps a side or more). The weights depend only on the
// place within the pixel and are tabulated. Bound of one row: noise / contrast * sqrt(2 sqrt(pi) sigma),
// 0.014 px for 175 grey levels, noise 1.5, sigma 0.8 px.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace facenav::coil_tracking {

constexpr int kFewestTaps = 2, kMostTaps = 4;  // pixels on either side of the edge

struct EdgePoint {
  double offset_px;  // from the predicted place, along the row
  double contrast;   // grey levels, > 0
};

/// Tabulated weights for one number of taps on either side and one blur.
struct EdgeWeights {
  static constexpr int kPhases = 32;  // positions within a pixel
  struct AtPhase {
    std::array<float, 2 * kMostTaps + 1> contrast, a;
  };
  std::array<AtPhase, kPhases + 1> phases;
  int taps = 0;
  float reach_px = 0;  // edges farther away are ignored
};

/// `taps` in kFewestTaps..kMostTaps; `blur_px`: standard deviation of the edge's blur along the row; the
/// nearest tabulated value is used.
const EdgeWeights& edgeWeights(int taps, double blur_px);

/// `first`: pixel 0 of the row; `step`: bytes between pixels. The edge is predicted at `place_px`; with
/// `is_black_after`, black lies on the side of larger pixels. The taps must lie inside the image. Returns
/// nothing if no edge of that polarity has `least_contrast`, or if it is more than 1.5 px + blur away.
std::optional<EdgePoint> locateEdge(const EdgeWeights& weights, const std::uint8_t* first,
                                    std::ptrdiff_t step, double place_px, bool is_black_after,
                                    double least_contrast);

/// The strongest white-to-black step within `reach_px` of the prediction, to about 0.3 px: a start value. The
/// row must have `reach_px + 3` pixels on either side.
std::optional<EdgePoint> searchEdge(const std::uint8_t* first, std::ptrdiff_t step, double place_px,
                                    bool is_black_after, int reach_px, double least_contrast);

}  // namespace facenav::coil_tracking
