#include "face_region.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace facenav::head_tracking {
namespace {

constexpr int kSkull = 100, kJaw = 60, kMoving = 30;  // rigidity in per cent

cv::Point toPoint(const Eigen::Vector2d& p) { return {int(std::lround(p.x())), int(std::lround(p.y()))}; }

std::vector<cv::Point> hullOf(std::vector<cv::Point> points) {
  std::vector<cv::Point> hull;
  cv::convexHull(points, hull);
  return hull;
}

std::vector<cv::Point> select(const std::vector<Eigen::Vector2d>& points, int first, int last, double grow) {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  for (int i = first; i <= last; ++i) centre += points[i] / double(last - first + 1);
  std::vector<cv::Point> chosen;
  for (int i = first; i <= last; ++i) chosen.push_back(toPoint(centre + grow * (points[i] - centre)));
  return hullOf(chosen);
}

}  // namespace

FaceRegion::FaceRegion(const face::FaceLandmarks& face, cv::Size size) : rigidity_percent_(size, uchar(0)) {
  cv::fillConvexPoly(rigidity_percent_, face::outlineOf(face), kSkull);
  if (face.points68.size() == 68) {
    const auto& p = face.points68;
    const Eigen::Vector2d brow = 0.5 * (p[21] + p[22]), down = p[33] - brow;
    cv::Mat1b lower(size, uchar(0));  // everything below the base of the nose
    const Eigen::Vector2d across = 5.0 * Eigen::Vector2d(-down.y(), down.x()), base = p[33] + 0.05 * down;
    cv::fillConvexPoly(
        lower,
        std::vector<cv::Point>{toPoint(base - across), toPoint(base + across),
                               toPoint(base + across + 5 * down), toPoint(base - across + 5 * down)},
        255);
    rigidity_percent_.setTo(kJaw, lower & (rigidity_percent_ > 0));
    for (const auto& part : {select(p, 36, 41, 1.3), select(p, 42, 47, 1.3), select(p, 48, 59, 1.25)})
      cv::fillConvexPoly(rigidity_percent_, part, kMoving);
  }
  std::vector<cv::Point> inside;
  cv::findNonZero(rigidity_percent_, inside);
  box_ = inside.empty() ? cv::Rect() : cv::boundingRect(inside);
}

FaceRegion::FaceRegion(const std::vector<Eigen::Vector2f>& cloud_px, cv::Size size)
    : rigidity_percent_(size, uchar(0)) {
  for (const auto& px : cloud_px) {
    const cv::Point at = toPoint(px.cast<double>());
    if (cv::Rect({}, size).contains(at)) rigidity_percent_(at) = kSkull;
  }
  const auto disc = [](int radius) {
    return cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * radius + 1, 2 * radius + 1});
  };
  cv::morphologyEx(rigidity_percent_, rigidity_percent_, cv::MORPH_CLOSE, disc(4));
  cv::erode(rigidity_percent_, rigidity_percent_,
            disc(8));  // at the outline the background becomes visible when the head moves
  std::vector<cv::Point> inside;
  cv::findNonZero(rigidity_percent_, inside);
  box_ = inside.empty() ? cv::Rect() : cv::boundingRect(inside);
}

int FaceRegion::partAt(const Eigen::Vector2d& px) const {
  const int column = std::clamp(int(kPartColumns * (px.x() - box_.x) / box_.width), 0, kPartColumns - 1);
  const int row = std::clamp(int(kPartRows * (px.y() - box_.y) / box_.height), 0, kPartRows - 1);
  return row * kPartColumns + column;
}

bool FaceRegion::contains(const Eigen::Vector2d& px) const { return rigidity(px) > 0; }

double FaceRegion::rigidity(const Eigen::Vector2d& px) const {
  const cv::Point at = toPoint(px);
  return cv::Rect({}, rigidity_percent_.size()).contains(at) ? rigidity_percent_(at) / 100.0 : 0.0;
}

}  // namespace facenav::head_tracking
