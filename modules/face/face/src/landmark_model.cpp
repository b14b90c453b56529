#include "facenav/face/landmark_model.h"

#include <dlib/image_processing/shape_predictor.h>
#include <dlib/opencv/cv_image.h>

#include "facenav/core/error.h"

namespace facenav::face {

struct LandmarkModel::Predictor {
  dlib::shape_predictor shape;
};

LandmarkModel::LandmarkModel(std::filesystem::path path) : path_(std::move(path)) {}
LandmarkModel::~LandmarkModel() = default;

std::filesystem::path LandmarkModel::defaultPath() {
  return "/usr/share/dlib/shape_predictor_68_face_landmarks.dat";
}

bool LandmarkModel::isInstalled() const { return std::filesystem::exists(path_); }

const LandmarkModel::Predictor* LandmarkModel::predictor() const {
  std::call_once(loaded_, [this] {
    if (!isInstalled()) return;
    auto predictor = std::make_unique<Predictor>();
    try {
      dlib::deserialize(path_.string()) >> predictor->shape;
    } catch (const std::exception&) {
      throw Error("the face landmark model cannot be read", path_.string(),
                  "reinstall the package libdlib-data");
    }
    predictor_ = std::move(predictor);
  });
  return predictor_.get();
}

std::vector<Eigen::Vector2d> LandmarkModel::landmarks(const cv::Mat& grey, const cv::Rect& face) const {
  const Predictor* model = predictor();
  if (!model) return {};
  const dlib::rectangle box(face.x, face.y, face.x + face.width - 1, face.y + face.height - 1);
  const auto shape = model->shape(dlib::cv_image<unsigned char>(grey), box);
  std::vector<Eigen::Vector2d> points;
  for (unsigned long i = 0; i < shape.num_parts(); ++i)
    points.emplace_back(shape.part(i).x(), shape.part(i).y());
  return points;
}

}  // namespace facenav::face
