#include <cmath>
#include <opencv2/imgproc.hpp>

#include "facenav/face/face_landmarks.h"
#include "facenav/geometry/rotation.h"

namespace facenav::face {
namespace {

// Height of usable forehead by the distance from brow to base of the nose.
constexpr double kForeheadShare = 0.7;

cv::Point toPoint(const Eigen::Vector2d& p) { return {int(std::lround(p.x())), int(std::lround(p.y()))}; }

}  // namespace

std::vector<cv::Point> outlineOf(const FaceLandmarks& face) {
  std::vector<cv::Point> outline;
  const auto& points = face.points68;
  if (points.size() != 68) {
    const cv::Point centre(face.face.x + face.face.width / 2, face.face.y + face.face.height / 2);
    cv::ellipse2Poly(centre, {int(0.36 * face.face.width), int(0.45 * face.face.height)},
                     int(std::lround(face.roll_rad * kDegPerRad)), 0, 360, 10, outline);
    return outline;
  }
  const Eigen::Vector2d brow = 0.5 * (points[21] + points[22]), up = kForeheadShare * (brow - points[33]);
  std::vector<cv::Point> around;
  for (int i = 0; i <= 16; ++i) around.push_back(toPoint(points[i]));
  for (int i = 17; i <= 26; ++i) around.push_back(toPoint(points[i] + up));
  cv::convexHull(around, outline);
  return outline;
}

}  // namespace facenav::face
