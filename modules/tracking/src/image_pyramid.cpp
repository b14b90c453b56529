#include "image_pyramid.h"

#include <opencv2/imgproc.hpp>

namespace facenav::tracking {

ImagePyramid::ImagePyramid(const cv::Mat& grey) {
  const cv::Mat1f kernel = (cv::Mat1f(1, 5) << 0.0270f, 0.2334f, 0.4792f, 0.2334f, 0.0270f);  // sigma 0.85 px
  cv::sepFilter2D(grey, level[0], CV_32F, kernel, kernel);
  cv::Mat half = grey;
  for (int l = 1; l < kLevels; ++l) {
    cv::pyrDown(half, half);
    half.convertTo(level[l], CV_32F);
  }
}

}  // namespace facenav::tracking
