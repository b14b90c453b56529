#pragma once
// LandmarkModel: dlib's 68-point shape predictor (Kazemi & Sullivan 2014) from Debian's libdlib-data. The
// file has 100 MB. It is read at first use, and all users share one object (shared_ptr).

#include <Eigen/Core>
#include <filesystem>
#include <memory>
#include <mutex>
#include <opencv2/core.hpp>
#include <vector>

namespace facenav::face {

class LandmarkModel {
 public:
  explicit LandmarkModel(std::filesystem::path path = defaultPath());
  ~LandmarkModel();
  static std::filesystem::path defaultPath();

  /// False when the file is not installed; landmarks() is then empty.
  bool isInstalled() const;
  /// The iBUG 68 points (px) of the upright face in the box `face`; 8-bit grey. Thread-safe.
  std::vector<Eigen::Vector2d> landmarks(const cv::Mat& grey, const cv::Rect& face) const;

 private:
  struct Predictor;
  const Predictor* predictor() const;

  std::filesystem::path path_;
  mutable std::once_flag loaded_;
  mutable std::unique_ptr<Predictor> predictor_;
};

}  // namespace facenav::face
