#pragma once
// Draws the skin fit: the measured points on the left camera's image, with a scale. Orange: the live skin is
// outside the MRI's; blue: inside; grey: the point was not used (hair, a hand).

#include "facenav/core/rgb_image.h"
#include "facenav/registration/aligner.h"
#include "facenav/stereo/face_cloud.h"

namespace facenav::pictures {

/// Draws the picture. `plain_left`: 8-bit, 1 channel, the capture's left image without projected dots. Full
/// colour at `full_mm`.
RgbImage drawSkinFit(const cv::Mat& plain_left, const stereo::FaceCloud& face,
                     const registration::AlignmentResult& alignment, double full_mm = 1.5);

}  // namespace facenav::pictures
