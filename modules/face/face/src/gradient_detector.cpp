#include <dlib/image_processing/frontal_face_detector.h>
#include <dlib/opencv/cv_image.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "detected_face.h"
#include "facenav/geometry/rotation.h"
#include "upright_image.h"

namespace facenav::face {
namespace {

// dlib finds faces of 80 px and more, and looks at five views: frontal, half left and right, leaning to both
// sides (some 20 degrees).
constexpr double kCoarseEdge_px = 512;     // edge of the image that is searched first
constexpr double kEnlargedEdge_px = 1500;  // images up to this are searched enlarged, for small faces
constexpr double kNearFace_px = 120;       // width of the face when it is searched near its last place
constexpr double kNearLeast = 0.6, kNearMost = 1.6;  // its width then, in widths of the last
constexpr double kLeaning_deg[] = {35, -35, 90, -90, 180};
// Scores of dlib's detector: it was trained so that a face has 0 and more. Between kPossible and 0 two
// cameras that agree make it a face.
constexpr double kPossible = -0.3, kFace = 0.0, kSure = 0.5;

/// A search over the whole image.
struct Pass {
  double scale, roll_deg;
};

std::vector<Pass> passesFor(const cv::Size& size) {
  const double edge = std::max(size.width, size.height), coarse = std::min(1.0, kCoarseEdge_px / edge);
  std::vector<Pass> passes = {{coarse, 0}};
  if (coarse < 1.0) passes.push_back({1.0, 0});
  for (const double roll_deg : kLeaning_deg) passes.push_back({coarse, roll_deg});
  if (2 * edge <= kEnlargedEdge_px) passes.push_back({2.0, 0});
  return passes;
}

class GradientDetector : public FaceDetector {
 public:
  explicit GradientDetector(std::shared_ptr<const LandmarkModel> landmarks)
      : landmarks_(std::move(landmarks)), detector_(dlib::get_frontal_face_detector()) {}

  std::optional<FaceLandmarks> detect(const cv::Mat& grey) const override {
    const auto found = search(grey, passesFor(grey.size()));
    if (found.empty() || found.front().score < kFace) return std::nullopt;
    return withLandmarks(*landmarks_, grey, found.front());
  }

  std::vector<FaceLandmarks> detectAll(const cv::Mat& grey) const override {
    std::vector<FaceLandmarks> faces;
    for (const auto& found : search(grey, passesFor(grey.size())))
      faces.push_back(withLandmarks(*landmarks_, grey, found));
    return faces;
  }

  std::optional<FaceLandmarks> detectAtRoll(const cv::Mat& grey, double roll_rad) const override {
    auto passes = passesFor(grey.size());
    passes.erase(std::remove_if(passes.begin(), passes.end(), [](const Pass& p) { return p.roll_deg != 0; }),
                 passes.end());
    for (auto& pass : passes) pass.roll_deg = roll_rad * kDegPerRad;
    const auto found = search(grey, passes);
    if (found.empty() || found.front().score < kFace) return std::nullopt;
    return withLandmarks(*landmarks_, grey, found.front());
  }

  std::optional<FaceLandmarks> detectNear(const cv::Mat& grey, const FaceLandmarks& last) const override {
    const auto window = windowAround(grey, last, kNearFace_px);
    if (window.part.width < last.face.width / 2 || window.part.height < last.face.height / 2)
      return std::nullopt;
    const cv::Mat part = grey(window.part).clone();
    for (const auto& found : searchAt(part, last.roll_rad, window.scale)) {
      const double width = double(found.face.width) / last.face.width;
      if (found.score < kFace || width < kNearLeast || width > kNearMost) continue;
      FaceLandmarks face = withLandmarks(*landmarks_, part, found);
      moveBy(window.part.tl(), face);
      return face;
    }
    return std::nullopt;
  }

  std::vector<FaceLandmarks> readings(const cv::Mat& grey, const FaceLandmarks& found) const override {
    return landmarkReadings(*landmarks_, grey, found);
  }

 private:
  /// The faces of the first pass that shows a sure one; else those of all passes. The surest comes first.
  std::vector<DetectedFace> search(const cv::Mat& grey, const std::vector<Pass>& passes) const {
    std::vector<DetectedFace> all;
    for (const auto& pass : passes) {
      auto found = searchAt(grey, pass.roll_deg * kRadPerDeg, pass.scale);
      all.insert(all.end(), found.begin(), found.end());
      if (!found.empty() && found.front().score >= kSure) break;
    }
    sortByScore(all);
    return all;
  }

  static void sortByScore(std::vector<DetectedFace>& faces) {
    std::stable_sort(faces.begin(), faces.end(),
                     [](const DetectedFace& a, const DetectedFace& b) { return a.score > b.score; });
  }

  std::vector<DetectedFace> searchAt(const cv::Mat& grey, double roll_rad, double scale) const {
    const UprightImage upright = makeUpright(grey, roll_rad, scale);
    std::vector<dlib::rect_detection> found;
    {
      std::lock_guard lock(mutex_);  // dlib's detector keeps its features in itself
      detector_(dlib::cv_image<unsigned char>(upright.image), found, kPossible);
    }
    std::vector<DetectedFace> faces;
    for (const auto& one : found) {
      const cv::Rect box = cascadeBox(
          {int(one.rect.left()), int(one.rect.top()), int(one.rect.width()), int(one.rect.height())});
      faces.push_back({aroundCentre(apply(upright.image_from_upright, centreOf(box)), box.width / scale,
                                    box.height / scale),
                       roll_rad, one.detection_confidence});
    }
    sortByScore(faces);
    return faces;
  }

  std::shared_ptr<const LandmarkModel> landmarks_;
  mutable std::mutex mutex_;
  mutable dlib::frontal_face_detector detector_;
};

}  // namespace

std::unique_ptr<FaceDetector> makeFaceDetector(std::shared_ptr<const LandmarkModel> landmarks) {
  return std::make_unique<GradientDetector>(std::move(landmarks));
}

std::unique_ptr<FaceDetector> makeFaceDetector() {
  return makeFaceDetector(std::make_shared<LandmarkModel>());
}

}  // namespace facenav::face
