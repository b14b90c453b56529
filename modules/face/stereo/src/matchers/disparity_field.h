#pragma once
// Stage 2 of the "field" matcher: a smooth disparity field, improved by Gauss-Newton steps over the whole
// image (see field_kernel.h).

#include <opencv2/core.hpp>
#include <vector>

#include "facenav/stereo/dense_matcher.h"
#include "kernels/field_kernel.h"
#include "match_images.h"

namespace facenav::stereo {

class DisparityField {
 public:
  /// `images` must outlive it.
  explicit DisparityField(const MatchImages& images);

  /// `nodes`: 32-bit float, the disparity of each 2 x 2 pixels; no NaN.
  void start(const cv::Mat& nodes);
  /// One Gauss-Newton step with a Gaussian window.
  void step(double window_sigma_px);
  /// A step with a smaller window. Each node keeps only the part above its noise, so that creases and edges
  /// get sharper and smooth skin gets no noisier.
  void addDetail(double window_sigma_px);
  /// The field at each accepted pixel.
  DisparityMap map(const MatchOptions& options) const;

 private:
  void estimate(double window_sigma_px, cv::Mat& change, cv::Mat& sigma, cv::Mat& correlation) const;

  const ImageRows& images_;
  field::Nodes nodes_;
  field::Kernel kernel_;
  cv::Mat disparity_, sigma_, correlation_;  // one value per node
};

}  // namespace facenav::stereo
