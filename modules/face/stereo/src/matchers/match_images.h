#pragma once
// MatchImages: a rectified pair prepared for the "field" matcher.

#include <opencv2/core.hpp>
#include <vector>

#include "facenav/stereo/rectification.h"
#include "kernels/image_rows.h"

namespace facenav::stereo {

class MatchImages {
 public:
  MatchImages(const Rectification& rectification, const RectifiedPair& pair);
  MatchImages(const MatchImages&) = delete;
  MatchImages& operator=(const MatchImages&) = delete;

  const ImageRows& rows() const { return rows_; }

 private:
  cv::Mat left_, right_;
  std::vector<std::int32_t> left_first_, left_end_, right_first_, right_end_;
  ImageRows rows_;
};

}  // namespace facenav::stereo
