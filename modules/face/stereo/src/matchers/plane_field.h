#pragma once
// Stage 2 of the "field" matcher: the surface as a grid of planes, improved by Gauss-Newton steps over the
// whole image (see plane_kernel.h).

#include <opencv2/core.hpp>
#include <vector>

#include "facenav/stereo/dense_matcher.h"
#include "kernels/plane_kernel.h"
#include "match_images.h"

namespace facenav::stereo {

class PlaneField {
 public:
  /// `images` must outlive it.
  explicit PlaneField(const MatchImages& images, const planes::Kernel& kernel = planes::kernel());

  /// `blocks`: 32-bit float, the disparity of each 4 x 4 pixels; no NaN.
  void start(const cv::Mat& blocks);
  /// One Gauss-Newton step with a window of about this standard deviation.
  void step(double window_sigma_px);
  /// Extends accepted planes by one block into neighbours that are not accepted, then does a step. Search
  /// windows fail on steep skin, where the disparity changes by pixels inside them; the surface grows into it
  /// from its sides.
  void grow(double window_sigma_px, const MatchOptions& options);
  /// The surface at each 2 x 2 pixels, accepted or not.
  cv::Mat nodes() const;
  /// The surface at each accepted pixel.
  DisparityMap map(const MatchOptions& options) const;

 private:
  struct Planes {
    cv::Mat d, a, b, a_prior, b_prior, offset, gain, sigma, correlation;
    explicit Planes(cv::Size size = {});
    planes::Field view();
  };
  void run(double window_sigma_px, bool is_fit);
  void setPriors();
  bool isAccepted(int x, int y, const MatchOptions& options) const;
  void carryOn(int x, int y, const cv::Mat& accepted);

  const ImageRows& images_;
  planes::Kernel kernel_;
  mutable Planes now_, next_;
};

}  // namespace facenav::stereo
