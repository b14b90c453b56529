#include "facenav/peers/cascade_detector.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <mutex>
#include <opencv2/imgproc.hpp>
#include <opencv2/objdetect.hpp>

#include "detected_face.h"
#include "facenav/core/error.h"
#include "facenav/geometry/rotation.h"
#include "upright_image.h"

namespace facenav::peers {
namespace {

using namespace face;

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

class CascadeDetector : public FaceDetector {
 public:
  explicit CascadeDetector(std::shared_ptr<const LandmarkModel> landmarks)
      : landmarks_(std::move(landmarks)) {
    if (!cascade_.load(cascadePath()))
      throw Error("the face cascade cannot be read", cascadePath(), "reinstall the package opencv-data");
  }

  std::optional<FaceLandmarks> detect(const cv::Mat& grey) const override {
    const double scale = std::min(1.0, double(kDetectionEdge_px) / std::max(grey.cols, grey.rows));
    for (double pass_scale : {scale, 1.0}) {
      std::optional<DetectedFace> best;
      for (double roll_deg : kRolls_deg) {
        const auto found = search(grey, roll_deg * kRadPerDeg, pass_scale, kSmallestFace_px, 0);
        if (found && (!best || found->score > best->score)) best = found;
        if (best && best->score >= kSureSupport) break;
      }
      if (best) return withLandmarks(*landmarks_, grey, *best);
      if (scale == 1.0) break;
    }
    return std::nullopt;
  }

  std::optional<FaceLandmarks> detectAtRoll(const cv::Mat& grey, double roll_rad) const override {
    const double scale = std::min(1.0, double(kDetectionEdge_px) / std::max(grey.cols, grey.rows));
    const auto found = search(grey, roll_rad, scale, kSmallestFace_px, 0);
    return found ? std::optional(withLandmarks(*landmarks_, grey, *found)) : std::nullopt;
  }

  std::optional<FaceLandmarks> detectNear(const cv::Mat& grey, const FaceLandmarks& last) const override {
    const auto window = windowAround(grey, last, 100.0);
    if (window.part.width < kSmallestFace_px || window.part.height < kSmallestFace_px) return std::nullopt;
    const double scale = std::min(1.0, window.scale), width = last.face.width * scale;
    const cv::Mat part = grey(window.part).clone();
    const auto found = search(part, last.roll_rad, scale, 0.7 * width, 1.4 * width);
    if (!found) return std::nullopt;
    FaceLandmarks face = withLandmarks(*landmarks_, part, *found);
    moveBy(window.part.tl(), face);
    return face;
  }

  std::vector<FaceLandmarks> readings(const cv::Mat& grey, const FaceLandmarks& found) const override {
    return landmarkReadings(*landmarks_, grey, found);
  }

 private:
  std::optional<DetectedFace> search(const cv::Mat& grey, double roll_rad, double scale, double smallest_px,
                                     double largest_px) const {
    const UprightImage upright = makeUpright(grey, roll_rad, scale);
    auto found = bestFace(upright.image, smallest_px, largest_px);
    if (!found) return std::nullopt;
    const cv::Rect box = found->face;
    found->face =
        aroundCentre(apply(upright.image_from_upright, centreOf(box)), box.width / scale, box.height / scale);
    found->roll_rad = roll_rad;
    return found;
  }

  // The largest of the faces with enough support.
  std::optional<DetectedFace> bestFace(const cv::Mat& image, double smallest_px, double largest_px) const {
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
    DetectedFace best;
    for (std::size_t i = 0; i < faces.size(); ++i)
      if (2 * support[i] >= most_support && faces[i].area() > best.face.area())
        best = {faces[i], 0.0, double(support[i])};
    return best;
  }

  std::shared_ptr<const LandmarkModel> landmarks_;
  mutable std::mutex cascade_mutex_;
  mutable cv::CascadeClassifier cascade_;
};

}  // namespace

std::unique_ptr<FaceDetector> makeCascadeDetector(std::shared_ptr<const LandmarkModel> landmarks) {
  return std::make_unique<CascadeDetector>(std::move(landmarks));
}

}  // namespace facenav::peers
