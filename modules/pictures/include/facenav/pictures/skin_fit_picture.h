#pragma once
// The map of the skin's fit as people look at it: the measured points on the left camera's image, orange
// where the live skin lies outside the MRI's, blue where inside, grey where a point did not count (hair, a
// hand), with a scale.

#include "facenav/core/rgb_image.h"
#include "facenav/registration/aligner.h"
#include "facenav/stereo/face_cloud.h"

namespace facenav::pictures {

/// `plain_left`: 8-bit, 1 channel, the capture's left image without dots. Full colour at `full_mm`.
RgbImage drawSkinFit(const cv::Mat& plain_left, const stereo::FaceCloud& face,
                     const registration::AlignmentResult& alignment, double full_mm = 1.5);

}  // namespace facenav::pictures
