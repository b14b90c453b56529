#pragma once
// RigReader: strict reader of the OpenCV YAML files with calibrated cameras and projectors. A missing or
// malformed key is an Error that names file and key. Private to cameras.

#include <cmath>
#include <filesystem>
#include <opencv2/core/persistence.hpp>
#include <optional>
#include <string>

#include "facenav/cameras/stereo_rig.h"
#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"

namespace facenav::cameras {

class RigReader {
 public:
  /// `advice`: how such a file is made, for messages.
  RigReader(const std::filesystem::path& path, std::string advice)
      : path_(path.string()), advice_(std::move(advice)) {
    const std::string content = readWholeFile(path);
    try {
      if (!storage_.open(content, cv::FileStorage::READ | cv::FileStorage::MEMORY))
        fail("is no OpenCV YAML file");
    } catch (const cv::Exception& exception) {
      fail("is no valid OpenCV YAML file (" + exception.err + ")");
    }
  }

  [[noreturn]] void fail(const std::string& what) const { throw Error(what, path_, advice_); }
  cv::FileNode node(const std::string& key) const {
    const cv::FileNode found = storage_.root().isMap() ? storage_[key] : cv::FileNode();
    if (found.empty()) fail("key '" + key + "' is missing");
    return found;
  }
  std::optional<double> number(const std::string& key) const {
    const cv::FileNode found = storage_[key];
    if (!found.isInt() && !found.isReal()) return std::nullopt;
    return double(found);
  }
  int size(const std::string& key) const {
    const cv::FileNode found = node(key);
    if (!found.isInt() && !found.isReal()) fail("key '" + key + "' is no number");
    const double value = double(found);
    if (!(value >= 1 && value <= 65536) || value != int(value))
      fail("key '" + key + "' is no image size in pixels");
    return int(value);
  }
  cv::Mat matrix(const std::string& key) const {
    const cv::FileNode found = node(key);
    cv::Mat read, values;
    try {
      found >> read;
      if (!read.empty()) read.convertTo(values, CV_64F);
    } catch (const cv::Exception&) {
      fail("key '" + key + "' is no matrix");
    }
    if (!read.empty() && (read.channels() != 1 || read.dims != 2)) fail("key '" + key + "' is no matrix");
    if (!cv::checkRange(values)) fail("key '" + key + "' holds a value that is not finite");
    return values;
  }
  /// Reads an optional matrix; empty if the key is missing or does not contain a square matrix of finite
  /// numbers.
  cv::Mat optionalSquare(const std::string& key) const {
    cv::Mat read, values;
    const cv::FileNode found = storage_[key];
    if (found.empty()) return {};
    try {
      found >> read;
      if (!read.empty()) read.convertTo(values, CV_64F);
    } catch (const cv::Exception&) {
      return {};
    }
    return values.rows == values.cols && values.channels() == 1 && cv::checkRange(values) ? values
                                                                                          : cv::Mat();
  }
  cv::Mat matrix(const std::string& key, int rows, int cols) const {
    const cv::Mat values = matrix(key);
    if (values.rows == rows && values.cols == cols) return values;
    const std::string wanted = std::to_string(rows) + " x " + std::to_string(cols);
    fail("key '" + key + "' is " + std::to_string(values.rows) + " x " + std::to_string(values.cols) + ", " +
         wanted + " was expected");
  }

  /// Pose from the keys R and T, not yet checked to be a rotation.
  Eigen::Matrix4d pose() const {
    const cv::Mat r = matrix("R", 3, 3), t = matrix("T");
    if (t.total() != 3) fail("key 'T' has " + std::to_string(t.total()) + " values, 3 were expected");
    const cv::Mat column = t.reshape(1, 3);
    Eigen::Matrix4d pose = Eigen::Matrix4d::Identity();
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) pose(i, j) = r.at<double>(i, j);
      pose(i, 3) = column.at<double>(i);
    }
    return pose;
  }
  template <class To, class From>
  RigidTransform<To, From> transform() const {
    try {
      return RigidTransform<To, From>::fromMatrix(pose());
    } catch (const Error&) {
      fail("key 'R' is no rotation (orthonormal, determinant +1)");
    }
  }

 private:
  std::string path_, advice_;
  cv::FileStorage storage_;
};

inline CameraModel readCamera(const RigReader& reader, const std::string& side) {
  CameraModel camera;
  camera.k = cv::Matx33d(reader.matrix("K" + side, 3, 3));
  const cv::Matx33d& k = camera.k;
  if (!(k(0, 0) > 0 && k(1, 1) > 0)) reader.fail("key 'K" + side + "' has no positive focal lengths");
  const bool is_camera_matrix = k(1, 0) == 0 && k(2, 0) == 0 && k(2, 1) == 0 && k(2, 2) == 1;
  if (!is_camera_matrix) reader.fail("key 'K" + side + "' is no camera matrix (fx 0 cx; 0 fy cy; 0 0 1)");
  if (std::abs(k(0, 1)) > 1e-6 * k(0, 0)) reader.fail("key 'K" + side + "' has skew, which is not supported");
  const cv::Mat d = reader.matrix("D" + side);
  const std::size_t n = d.total();
  if (n != 0 && n != 4 && n != 5 && n != 8 && n != 12 && n != 14)
    reader.fail("key 'D" + side + "' has " + std::to_string(n) +
                " coefficients, 4, 5, 8, 12 or 14 were expected");
  if (n != 0 && d.rows != 1 && d.cols != 1) reader.fail("key 'D" + side + "' is no row of coefficients");
  if (n != 0) camera.distortion = d.reshape(1, 1).clone();
  return camera;
}

}  // namespace facenav::cameras
