#include <algorithm>
#include <cmath>
#include <filesystem>
#include <mutex>
#include <opencv2/imgproc.hpp>
#include <opencv2/objdetect.hpp>

#include "facenav/core/error.h"
#include "facenav/face/face_landmarks.h"
#include "facenav/face/landmark_model.h"
#include "facenav/geometry/rotation.h"

namespace facenav::face {
namespace {

// Rolls in the order tried, upright first. The last three are for cameras mounted on their side or upside
// down.
constexpr double kRolls_deg[] = {0, 20, -20, 40, -40, 60, -60, 90, -90, 180};
constexpr int kDetectionEdge_px = 400;  // edge of the reduced image that the cascade searches
constexpr int kSmallestFace_px = 44;    // size of the smallest face in the reduced image
constexpr int kLeastSupport = 4;  // overlapping windows that agree on a face; real faces have 10 and more
constexpr int kSureSupport = 12;  // support with which the other rolls are skipped

std::string cascadePath() {
  for (const char* folder : {"/usr/share/opencv4/haarcascades", "/usr/share/opencv/haarcascades",
                             "/usr/local/share/opencv4/haarcascades"}) {
    const auto path = std::filesystem::path(folder) / "haarcascade_frontalface_alt2.xml";
    if (std::filesystem::exists(path)) return path.string();
  }
  throw Error("the face cascade haarcascade_frontalface_alt2.xml is not installed", {},
              "install the package opencv-data");
}

// Maps image pixels to pixels of a copy in which a face with roll `roll_rad` is upright.
cv::Matx23d uprightFromImage(const cv::Size& size, double roll_rad, double scale) {
  const double c = scale * std::cos(roll_rad), s = scale * std::sin(roll_rad);
  const double half = 0.5 * scale * std::hypot(size.width, size.height);
  const bool is_upright = roll_rad == 0.0;
  const double cx = is_upright ? 0.5 * scale * (size.width - 1) : half;
  const double cy = is_upright ? 0.5 * scale * (size.height - 1) : half;
  const double mx = 0.5 * (size.width - 1), my = 0.5 * (size.height - 1);
  return {c, s, cx - c * mx - s * my, -s, c, cy + s * mx - c * my};
}

Eigen::Vector2d apply(const cv::Matx23d& m, const Eigen::Vector2d& p) {
  return {m(0, 0) * p.x() + m(0, 1) * p.y() + m(0, 2), m(1, 0) * p.x() + m(1, 1) * p.y() + m(1, 2)};
}

cv::Rect aroundCentre(const Eigen::Vector2d& centre, double width, double height) {
  return {static_cast<int>(std::lround(centre.x() - width / 2)),
          static_cast<int>(std::lround(centre.y() - height / 2)), static_cast<int>(std::lround(width)),
          static_cast<int>(std::lround(height))};
}

struct Upright {
  cv::Mat image;
  cv::Matx23d upright_from_image, image_from_upright;
};

Upright makeUpright(const cv::Mat& grey, double roll_rad, double scale) {
  Upright upright;
  upright.upright_from_image = uprightFromImage(grey.size(), roll_rad, scale);
  const double diagonal = scale * std::hypot(grey.cols, grey.rows);
  const cv::Size size = roll_rad == 0.0
                            ? cv::Size(std::lround(scale * grey.cols), std::lround(scale * grey.rows))
                            : cv::Size(std::lround(diagonal), std::lround(diagonal));
  if (roll_rad == 0.0)
    cv::resize(grey, upright.image, size, 0, 0, scale < 1 ? cv::INTER_AREA : cv::INTER_LINEAR);
  else
    cv::warpAffine(grey, upright.image, upright.upright_from_image, size, cv::INTER_LINEAR);
  cv::invertAffineTransform(upright.upright_from_image, upright.image_from_upright);
  return upright;
}

class HaarFaceDetector : public FaceDetector {
 public:
  explicit HaarFaceDetector(std::shared_ptr<const LandmarkModel> landmarks)
      : landmarks_(std::move(landmarks)) {
    if (!cascade_.load(cascadePath()))
      throw Error("the face cascade cannot be read", cascadePath(), "reinstall the package opencv-data");
  }

  std::optional<FaceLandmarks> detect(const cv::Mat& grey) const override {
    const double scale = std::min(1.0, double(kDetectionEdge_px) / std::max(grey.cols, grey.rows));
    for (double pass_scale : {scale, 1.0}) {
      std::optional<Candidate> best;
      for (double roll_deg : kRolls_deg) {
        const auto found = search(grey, roll_deg * kRadPerDeg, pass_scale, kSmallestFace_px, 0);
        if (found && (!best || found->support > best->support)) best = found;
        if (best && best->support >= kSureSupport) break;
      }
      if (best) return finished(grey, *best);
      if (scale == 1.0) break;
    }
    return std::nullopt;
  }

  std::optional<FaceLandmarks> detectAtRoll(const cv::Mat& grey, double roll_rad) const override {
    const double scale = std::min(1.0, double(kDetectionEdge_px) / std::max(grey.cols, grey.rows));
    const auto found = search(grey, roll_rad, scale, kSmallestFace_px, 0);
    return found ? std::optional(finished(grey, *found)) : std::nullopt;
  }

  std::optional<FaceLandmarks> detectNear(const cv::Mat& grey, const FaceLandmarks& last) const override {
    const int margin = last.face.width / 2;
    const cv::Rect window(last.face.x - margin, last.face.y - margin, last.face.width + 2 * margin,
                          last.face.height + 2 * margin);
    const cv::Rect inside = window & cv::Rect(0, 0, grey.cols, grey.rows);
    if (inside.width < kSmallestFace_px || inside.height < kSmallestFace_px) return std::nullopt;
    const double scale = std::min(1.0, 100.0 / last.face.width);
    const cv::Mat part = grey(inside).clone();
    const auto found = search(part, last.roll_rad, scale, 70 * last.face.width * scale / 100,
                              140 * last.face.width * scale / 100);
    if (!found) return std::nullopt;
    FaceLandmarks face = finished(part, *found);
    face.face += inside.tl();
    for (auto& p : face.points68) p += Eigen::Vector2d(inside.x, inside.y);
    return face;
  }

 private:
  struct Candidate {
    cv::Rect face;
    double roll_rad = 0.0;
    int support = 0;
  };

  std::optional<Candidate> search(const cv::Mat& grey, double roll_rad, double scale, double smallest_px,
                                  double largest_px) const {
    const Upright upright = makeUpright(grey, roll_rad, scale);
    auto found = bestFace(upright.image, smallest_px, largest_px);
    if (!found) return std::nullopt;
    const cv::Rect box = found->face;
    const Eigen::Vector2d centre(box.x + 0.5 * (box.width - 1), box.y + 0.5 * (box.height - 1));
    found->face =
        aroundCentre(apply(upright.image_from_upright, centre), box.width / scale, box.height / scale);
    found->roll_rad = roll_rad;
    return found;
  }

  // The largest of the faces with enough support.
  std::optional<Candidate> bestFace(const cv::Mat& image, double smallest_px, double largest_px) const {
    std::vector<cv::Rect> faces;
    std::vector<int> support;
    const cv::Size least(std::lround(smallest_px), std::lround(smallest_px));
    const cv::Size most(std::lround(largest_px), std::lround(largest_px));
    {
      std::lock_guard lock(cascade_mutex_);
      cascade_.detectMultiScale(image, faces, support, 1.1, kLeastSupport, 0, least, most);
    }
    if (faces.empty()) return std::nullopt;
    const int most_support = *std::max_element(support.begin(), support.end());
    Candidate best;
    for (std::size_t i = 0; i < faces.size(); ++i)
      if (2 * support[i] >= most_support && faces[i].area() > best.face.area())
        best = {faces[i], 0.0, support[i]};
    return best;
  }

  FaceLandmarks finished(const cv::Mat& grey, const Candidate& candidate) const {
    FaceLandmarks found;
    found.face = candidate.face;
    found.roll_rad = candidate.roll_rad;
    if (landmarks_->isInstalled()) addLandmarks(grey, found);
    return found;
  }

  // Landmarks in the upright copy, predicted twice. The second time starts from the box of the first
  // landmarks: it is steadier than the cascade's box, which has coarse steps of position and scale.
  void addLandmarks(const cv::Mat& grey, FaceLandmarks& found) const {
    const double scale = std::min(1.0, 240.0 / found.face.width);
    const Upright upright = makeUpright(grey, found.roll_rad, scale);
    const Eigen::Vector2d centre =
        apply(upright.upright_from_image, Eigen::Vector2d(found.face.x + 0.5 * (found.face.width - 1),
                                                          found.face.y + 0.5 * (found.face.height - 1)));
    auto points = landmarks_->landmarks(
        upright.image, aroundCentre(centre + Eigen::Vector2d(0, 0.05 * found.face.height * scale),
                                    0.9 * found.face.width * scale, 0.9 * found.face.height * scale));
    points = landmarks_->landmarks(upright.image, boxOf(points));
    for (const auto& p : points) found.points68.push_back(apply(upright.image_from_upright, p));
  }

  // The box that dlib's own detector would give for these landmarks: brows to chin, square.
  static cv::Rect boxOf(const std::vector<Eigen::Vector2d>& points) {
    Eigen::Vector2d low = points.front(), high = points.front();
    for (const auto& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
    const double edge = 0.5 * (high - low).sum();
    return aroundCentre(0.5 * (low + high), edge, edge);
  }

  std::shared_ptr<const LandmarkModel> landmarks_;
  mutable std::mutex cascade_mutex_;
  mutable cv::CascadeClassifier cascade_;
};

}  // namespace

std::unique_ptr<FaceDetector> makeFaceDetector(std::shared_ptr<const LandmarkModel> landmarks) {
  return std::make_unique<HaarFaceDetector>(std::move(landmarks));
}

std::unique_ptr<FaceDetector> makeFaceDetector() {
  return makeFaceDetector(std::make_shared<LandmarkModel>());
}

}  // namespace facenav::face
