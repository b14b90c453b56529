#pragma once
// Matches of one scene in two pictures, found without a rig. They determine whether a rig fits, whether left
// and right are exchanged, and whether both pictures are of one moment. SIFT features (Lowe 2004, IJCV 60:91)
// that agree with their neighbours are the seeds. From these, textured corners are matched with sub-pixel
// precision; each patch is warped by its neighbourhood's motion.

#include <opencv2/core.hpp>
#include <vector>

#include "facenav/health/observation.h"

namespace facenav::health {

/// Matches 8-bit grey images of any size. Gives some hundred matches on a face 300 px wide; few or none where
/// the pictures show different scenes or no texture. About 0.3 s for two pictures of a megapixel: not for
/// each frame.
std::vector<Correspondence> matchPictures(const cv::Mat& left, const cv::Mat& right);

/// Grows matches from those seeds over their surroundings: windows of 29 px, every 10 px of the left image.
/// Each is searched around the place predicted by its neighbours, across the epipolar line as well as along
/// it. Gives about a thousand on a face 400 px wide, also on plain skin. Growth ends where the images show
/// different things. About 0.5 s.
std::vector<Correspondence> growMatches(const cv::Mat& left, const cv::Mat& right,
                                        const std::vector<Correspondence>& seeds);

}  // namespace facenav::health
