#include "detected_face.h"

#include <algorithm>

#include "upright_image.h"

namespace facenav::face {
namespace {

constexpr double kDlibWidth = 0.9, kDlibBelow = 0.05;  // dlib's box in widths of the cascade's
constexpr double kLandmarkFace_px = 240;               // the landmarks are predicted on a face of that width

// The box that dlib's own detector would give for these landmarks: brows to chin, square.
cv::Rect boxOf(const std::vector<Eigen::Vector2d>& points) {
  Eigen::Vector2d low = points.front(), high = points.front();
  for (const auto& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const double edge = 0.5 * (high - low).sum();
  return aroundCentre(0.5 * (low + high), edge, edge);
}

}  // namespace

cv::Rect dlibBox(const cv::Rect& box) {
  return aroundCentre(centreOf(box) + Eigen::Vector2d(0, kDlibBelow * box.height), kDlibWidth * box.width,
                      kDlibWidth * box.height);
}

cv::Rect cascadeBox(const cv::Rect& box) {
  const double width = box.width / kDlibWidth, height = box.height / kDlibWidth;
  return aroundCentre(centreOf(box) - Eigen::Vector2d(0, kDlibBelow * height), width, height);
}

FaceLandmarks withLandmarks(const LandmarkModel& model, const cv::Mat& grey, const DetectedFace& detected) {
  FaceLandmarks found;
  found.face = detected.face;
  found.roll_rad = detected.roll_rad;
  found.score = detected.score;
  if (!model.isInstalled()) return found;
  const double scale = std::min(1.0, kLandmarkFace_px / found.face.width);
  const UprightImage upright = makeUpright(grey, found.roll_rad, scale);
  const cv::Rect box = aroundCentre(apply(upright.upright_from_image, centreOf(found.face)),
                                    found.face.width * scale, found.face.height * scale);
  auto points = model.landmarks(upright.image, dlibBox(box));
  points = model.landmarks(upright.image, boxOf(points));
  for (const auto& p : points) found.points68.push_back(apply(upright.image_from_upright, p));
  return found;
}

std::vector<FaceLandmarks> landmarkReadings(const LandmarkModel& model, const cv::Mat& grey,
                                            const FaceLandmarks& face) {
  // Steps of the detector's own boxes, in position and scale; its box may be off by half a step.
  constexpr double kScales[] = {0.86, 1.0, 1.16};
  constexpr double kShifts[][2] = {{0, 0}, {-0.08, 0}, {0.08, 0}, {0, -0.08}, {0, 0.08}};
  const SearchWindow window = windowAround(grey, face, face.face.width);
  if (window.part.empty() || !model.isInstalled()) return {face};
  const cv::Mat part = grey(window.part);
  const Eigen::Vector2d centre = centreOf(face.face) - Eigen::Vector2d(window.part.x, window.part.y);
  std::vector<FaceLandmarks> readings;
  for (const double scale : kScales)
    for (const auto& shift : kShifts) {
      const Eigen::Vector2d at = centre + face.face.width * Eigen::Vector2d(shift[0], shift[1]);
      readings.push_back(withLandmarks(
          model, part,
          {aroundCentre(at, scale * face.face.width, scale * face.face.height), face.roll_rad, face.score}));
      moveBy(window.part.tl(), readings.back());
      readings.back().face = face.face;
    }
  return readings;
}

SearchWindow windowAround(const cv::Mat& grey, const FaceLandmarks& last, double width_px) {
  const int margin = last.face.width / 2;
  const cv::Rect window(last.face.x - margin, last.face.y - margin, last.face.width + 2 * margin,
                        last.face.height + 2 * margin);
  return {window & cv::Rect(0, 0, grey.cols, grey.rows), width_px / std::max(1, last.face.width)};
}

void moveBy(const cv::Point& corner, FaceLandmarks& face) {
  face.face += corner;
  for (auto& p : face.points68) p += Eigen::Vector2d(corner.x, corner.y);
}

}  // namespace facenav::face
