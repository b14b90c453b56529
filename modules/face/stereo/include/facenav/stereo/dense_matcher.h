#pragma once
// DenseMatcher: rectified pair -> disparity of each left pixel.
//   field  the default. Blocks of 4 x 4 pixels are searched at whole pixels over all disparities. Then a grid
//          of planes is fitted to the whole image at once by Gauss-Newton, with gain, offset and slopes.
//          Without slopes a cheek seen at 45 degrees is off by tenths of a pixel. Gain and offset absorb that
//          the cameras see the skin from different sides. `details` sharpens creases.
//   ssd    the paper's method (section 7.1: 11 x 11 SSD) made sub-pixel by a fit at each pixel; to compare.
//          Needs projected dots.
//   sgm    semi-global matching of census costs. It finds weakly textured and half hidden places, but is an
//          order less exact: the start of "field" on plain skin. Holes are filled from the background, with a
//          stated deviation of 1 px; `largest_sigma_px` decides whether they are kept.

#include <memory>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "facenav/core/field.h"
#include "facenav/stereo/rectification.h"

namespace facenav::stereo {

struct MatchOptions {
  double window_sigma_px = 3.0;  // field: standard deviation of the Gaussian window
  int steps = 1;                 // field: Gauss-Newton steps over the whole image
  int growths = 0;               // field: steps that extend the surface over steep skin, by one block each
  int details = 0;  // field: further steps with smaller windows, kept if the change exceeds its noise
  /// field: a surface known beforehand, correct to half a pixel, which replaces the search. One disparity for
  /// each 4 x 4 pixels of the rectified left image (32-bit float, no NaN).
  cv::Mat predicted_px;
  int window_px = 11;  // odd, 5 .. 11
  /// Predicted standard deviation of the disparity above which a pixel is dropped. 0.4 covers creases; 0.15
  /// keeps only smooth skin.
  double largest_sigma_px = 0.4;
  double least_correlation = 0.75;  // correlation of the fitted windows
  double largest_slope = 1.0;       // largest accepted |d(disparity)/dx|
  /// Largest distance of the window's texture centre from its middle. Beyond it, the fit depends on texture
  /// beside the pixel.
  double largest_lever_px = 4.0;
  double least_centre_texture = 0.1;  // least squared gradient of the middle 5 x 5, relative to the window's
  int refinements = 1;  // further fits that use the surface's own shape in the window instead of a plane
  int refined_window_px = 7;    // side of the window in those fits
  int smallest_patch_px = 150;  // smaller connected patches, in pixels, are dropped as speckles

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(Field{"window_sigma_px", "field: standard deviation of the window", 1, 5}, self.window_sigma_px);
    visitor(Field{"steps", "field: Gauss-Newton steps", 1, 20}, self.steps);
    visitor(Field{"growths", "field: blocks that the surface is grown by over steep skin", 0, 20},
            self.growths);
    visitor(Field{"details", "field: steps with smaller windows, kept where they exceed their noise", 0, 4},
            self.details);
    visitor(Field{"window_px", "side of the matching window, odd", 5, 11}, self.window_px);
    visitor(Field{"largest_sigma_px", "predicted deviation above which a pixel is dropped", 0.01, 2},
            self.largest_sigma_px);
    visitor(Field{"least_correlation", "least correlation of the fitted windows", 0, 1},
            self.least_correlation);
    visitor(Field{"largest_slope", "steepest disparity slope accepted", 0.1, 2}, self.largest_slope);
    visitor(Field{"largest_lever_px", "farthest centre of texture from the window's middle", 0.5, 6},
            self.largest_lever_px);
    visitor(Field{"least_centre_texture", "texture of the window's middle by that of all of it", 0, 1},
            self.least_centre_texture);
    visitor(Field{"refined_window_px", "side of the window in the refinement, odd", 5, 11},
            self.refined_window_px);
    visitor(Field{"refinements", "fits with the surface's own shape in the window", 0, 5}, self.refinements);
    visitor(Field{"smallest_patch_px", "smaller connected patches are dropped", 0, 100000},
            self.smallest_patch_px);
  }
};

struct DisparityMap {
  cv::Mat disparity_px;      // 32-bit float, NaN if unknown; defined as in Rectification
  cv::Mat slope_x, slope_y;  // 32-bit float: derivative along x and y (empty if the matcher computes none)
  cv::Mat sigma_px;          // 32-bit float: predicted standard deviation
};

class DenseMatcher {
 public:
  virtual ~DenseMatcher() = default;
  /// True if it uses MatchOptions::predicted_px. The other matchers search, for which plain skin has too
  /// little texture.
  virtual bool startsFromPrediction() const { return false; }
  virtual DisparityMap match(const Rectification& rectification, const RectifiedPair& pair,
                             const MatchOptions& options) const = 0;
};

constexpr const char* kDefaultMatcher = "field";

/// Makes one of denseMatcherNames(). Throws Error for another name, listing these.
std::unique_ptr<DenseMatcher> makeDenseMatcher(const std::string& name);
std::vector<std::string> denseMatcherNames();
std::string denseMatcherList();  // "field, ssd, sgm", for messages and help

}  // namespace facenav::stereo
