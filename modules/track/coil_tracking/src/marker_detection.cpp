#include "marker_detection.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "quad_detector.h"

namespace facenav::coil_tracking {
namespace {

// Work, in patch comparisons that take the same time (frame_work.h).
constexpr int kShrunkPixelsPerComparison = 4000, kPixelsPerComparison = 900, kOutlinePointsPerComparison = 8;

Quad inOrderOfPrint(const Quad& quad, int turns) {
  return {quad[turns % 4], quad[(turns + 1) % 4], quad[(turns + 2) % 4], quad[(turns + 3) % 4]};
}

bool isSamePlace(const MarkerDetection& a, const MarkerDetection& b) {
  double apart_px = 0;
  for (int i = 0; i < 4; ++i) apart_px = std::max(apart_px, (a.corners[i] - b.corners[i]).norm());
  return a.marker == b.marker && apart_px < 4.0;
}

/// The image reduced by an integer factor to about 360 columns.
struct SmallImage {
  explicit SmallImage(const cv::Mat& grey) : factor(std::clamp(int(std::lround(grey.cols / 360.0)), 1, 8)) {
    if (factor == 1)
      small = grey;
    else
      cv::resize(grey, small, {grey.cols / factor, grey.rows / factor}, 0, 0, cv::INTER_AREA);
  }
  Quad inFull(Quad quad) const {
    for (auto& corner : quad) corner = factor * corner + Eigen::Vector2d::Constant(0.5 * (factor - 1));
    return quad;
  }
  int factor;
  cv::Mat small;
};

void note(const MarkerDetection& detection, std::vector<MarkerDetection>& markers) {
  const auto same = std::find_if(markers.begin(), markers.end(),
                                 [&](const MarkerDetection& other) { return isSamePlace(other, detection); });
  if (same == markers.end())
    markers.push_back(detection);
  else if (same->match.likeness < detection.match.likeness)
    *same = detection;
}

void detect(const cv::Mat& grey, const SmallImage& small, const std::vector<MarkerPattern>& patterns,
            const Darkness& darkness, DetectedMarkers& found) {
  const FoundQuads quads = findDarkQuads(small.small, darkness);
  found.comparisons += int(small.small.total()) / kPixelsPerComparison +
                       quads.points / kOutlinePointsPerComparison +
                       kMatchComparisons * int(quads.quads.size() * patterns.size());
  for (const Quad& quad_of_small : quads.quads) {
    const Quad quad = small.inFull(quad_of_small);
    for (std::size_t i = 0; i < patterns.size(); ++i)
      if (const auto match = patterns[i].match(grey, quad))
        note({i, inOrderOfPrint(quad, match->turns), *match}, found.markers);
  }
}

}  // namespace

DetectedMarkers detectMarkers(const cv::Mat& grey, const std::vector<MarkerPattern>& patterns,
                              MarkerLight light) {
  const SmallImage small(grey);
  const Darkness bright;
  Darkness dim;
  dim.least_contrast_grey = 10;
  dim.share = 0.33;  // white paper darker than a bright wall behind it must still be light
  DetectedMarkers found;
  found.comparisons = int(grey.total()) / kShrunkPixelsPerComparison;
  if (light != MarkerLight::dim) detect(grey, small, patterns, bright, found);
  if (found.markers.empty() && light != MarkerLight::bright) detect(grey, small, patterns, dim, found);
  return found;
}

bool showsUpright(const cv::Mat& grey, const Quad& corners, const MarkerPattern& pattern) {
  const auto match = pattern.match(grey, corners);
  return match && match->turns == 0;
}

}  // namespace facenav::coil_tracking
