#include "landmarks.h"

#include <dlib/image_processing/shape_predictor.h>
#include <dlib/opencv.h>

#include <mutex>
#include <opencv2/imgproc.hpp>
#include <opencv2/objdetect.hpp>

#include "facenav/core/error.h"
#include "facenav/room/room_rig.h"
#include "optics/ray_scene.h"

namespace facenav::room {
namespace {

const char* const kPredictor = "/usr/share/dlib/shape_predictor_68_face_landmarks.dat";
const char* const kCascade = "/usr/share/opencv4/haarcascades/haarcascade_frontalface_default.xml";
constexpr int kSize_px = 480;         // of the frontal rendering
constexpr double kScale_mm_px = 0.7;  // of its pixels (parallel projection)

const dlib::shape_predictor& predictor() {
  static const dlib::shape_predictor loaded = [] {
    dlib::shape_predictor model;
    try {
      dlib::deserialize(kPredictor) >> model;
    } catch (const dlib::error&) {
      throw Error("face landmark model cannot be read", kPredictor, "install the package libdlib-data");
    }
    return model;
  }();
  return loaded;
}

std::optional<cv::Rect> findFace(const cv::Mat& grey) {
  cv::CascadeClassifier cascade;
  if (!cascade.load(kCascade))
    throw Error("face cascade cannot be read", kCascade, "install the package opencv-data");
  std::vector<cv::Rect> faces;
  cascade.detectMultiScale(grey, faces, 1.05, 3, 0, {grey.cols / 8, grey.cols / 8});
  if (faces.empty()) return std::nullopt;
  return *std::max_element(faces.begin(), faces.end(), [](auto& a, auto& b) { return a.area() < b.area(); });
}

std::vector<Eigen::Vector2d> predict(const cv::Mat& grey, const cv::Rect& face) {
  const dlib::cv_image<unsigned char> image(grey);
  const auto shape =
      predictor()(image, dlib::rectangle(face.x, face.y, face.x + face.width, face.y + face.height));
  std::vector<Eigen::Vector2d> points;
  for (unsigned long i = 0; i < shape.num_parts(); ++i)
    points.emplace_back(double(shape.part(i).x()), double(shape.part(i).y()));
  return points;
}

/// Parallel view along -y (from the patient's front) centred on the upper front of the head.
struct FrontView {
  Eigen::Vector3d top_left_mm;

  Eigen::Vector3d origin(double x_px, double y_px) const {
    return top_left_mm + kScale_mm_px * Eigen::Vector3d(-x_px, 0.0, -y_px);
  }
};

FrontView frontView(const surface::TriangleMesh& skin) {
  Eigen::Vector3d low = skin.vertices_mm.front(), high = low;
  for (const auto& p : skin.vertices_mm) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const double half = 0.5 * kSize_px * kScale_mm_px;
  return {{0.5 * (low.x() + high.x()) + half, high.y() + 100.0, high.z() - 115.0 + half}};
}

cv::Mat renderFront(const RayScene& scene, const FrontView& view) {
  cv::Mat grey(kSize_px, kSize_px, CV_8U, cv::Scalar(40));
  const Eigen::Vector3d light = Eigen::Vector3d(0.0, 0.8, 0.6).normalized();
  for (int y = 0; y < kSize_px; ++y)
    for (int x = 0; x < kSize_px; ++x)
      if (const auto hit = scene.intersect(view.origin(x, y), -Eigen::Vector3d::UnitY()))
        grey.at<std::uint8_t>(y, x) =
            cv::saturate_cast<std::uint8_t>(30.0 + 190.0 * std::max(0.0, hit->normal.dot(light)));
  cv::GaussianBlur(grey, grey, {}, 0.8);
  return grey;
}

}  // namespace

std::optional<std::vector<Eigen::Vector2d>> findPortraitLandmarks(const cv::Mat& grey) {
  const auto face = findFace(grey);
  if (!face) return std::nullopt;
  return predict(grey, *face);
}

std::optional<HeadLandmarks> findHeadLandmarks(const surface::TriangleMesh& skin) {
  RayScene scene;
  scene.add(skin);
  scene.commit();
  const FrontView view = frontView(skin);
  const auto points = findPortraitLandmarks(renderFront(scene, view));
  if (!points) return std::nullopt;
  HeadLandmarks landmarks;
  const Eigen::Vector2d middle = (*points)[30];
  for (Eigen::Vector2d p : *points) {
    // Jaw points may lie just outside the silhouette: they move towards the nose until they hit the head.
    auto hit = scene.intersect(view.origin(p.x(), p.y()), -Eigen::Vector3d::UnitY());
    for (int step = 0; step < 40 && !hit; ++step) {
      p += (middle - p).normalized();
      hit = scene.intersect(view.origin(p.x(), p.y()), -Eigen::Vector3d::UnitY());
    }
    if (!hit) return std::nullopt;
    landmarks.points68_mm.push_back(hit->p_object_mm);
  }
  return landmarks;
}

}  // namespace facenav::room
