#include "facenav/cameras/stereo_rig.h"

#include <opencv2/core/persistence.hpp>

#include "facenav/cameras/rig_file.h"
#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/geometry/rotation.h"

namespace facenav::cameras {
namespace {

constexpr double kShortestBaseline_mm = 5.0;

class RigReader {
 public:
  explicit RigReader(const std::filesystem::path& path) : path_(path.string()) {
    const std::string content = readWholeFile(path);
    try {
      if (!storage_.open(content, cv::FileStorage::READ | cv::FileStorage::MEMORY))
        fail("is no OpenCV YAML file");
    } catch (const cv::Exception& exception) {
      fail("is no valid OpenCV YAML file (" + exception.err + ")");
    }
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw Error(what, path_, "write it with 'facenav calibrate' or cv::FileStorage (T in mm)");
  }
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
  /// Empty when the key is missing or does not hold a square matrix of finite numbers.
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

 private:
  std::string path_;
  cv::FileStorage storage_;
};

CameraModel readCamera(const RigReader& reader, const std::string& side) {
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

RigidTransform<RightCamera, Camera> readPose(const RigReader& reader) {
  const cv::Mat r = reader.matrix("R", 3, 3), t = reader.matrix("T");
  if (t.total() != 3) reader.fail("key 'T' has " + std::to_string(t.total()) + " values, 3 were expected");
  const cv::Mat column = t.reshape(1, 3);
  Eigen::Matrix4d pose = Eigen::Matrix4d::Identity();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) pose(i, j) = r.at<double>(i, j);
    pose(i, 3) = column.at<double>(i);
  }
  const double baseline_mm = pose.topRightCorner<3, 1>().norm();
  if (baseline_mm == 0) reader.fail("key 'T' has zero length: both cameras would stand in one place");
  if (baseline_mm < kShortestBaseline_mm)
    reader.fail("key 'T' is only " + std::to_string(baseline_mm) +
                " long: it looks like metres, millimetres are needed");
  try {
    return RigidTransform<RightCamera, Camera>::fromMatrix(pose);
  } catch (const Error&) {
    reader.fail("key 'R' is no rotation (orthonormal, determinant +1)");
  }
}

cv::Mat toMat(const Eigen::Matrix3d& m) {
  cv::Mat mat(3, 3, CV_64F);
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) mat.at<double>(r, c) = m(r, c);
  return mat;
}

// Key of each figure of the effect at the head.
const std::pair<const char*, double HeadEffect::*> kEffectKeys[] = {
    {"effect_distance_mm", &HeadEffect::distance_mm}, {"effect_point_mm", &HeadEffect::point_mm},
    {"effect_depth_mm", &HeadEffect::depth_mm},       {"effect_length_mm", &HeadEffect::length_mm},
    {"effect_motion_mm", &HeadEffect::motion_mm},     {"effect_motion_deg", &HeadEffect::motion_deg}};

void writeNotes(cv::FileStorage& storage, const CalibrationNotes& notes) {
  if (!notes.board.empty()) storage << "board" << notes.board;
  if (notes.views) storage << "views" << *notes.views;
  if (!notes.created.empty()) storage << "created" << notes.created;
  if (!notes.at_head) return;
  for (const auto& [key, figure] : kEffectKeys) storage << key << (*notes.at_head).*figure;
}

}  // namespace

StereoRig readRig(const std::filesystem::path& path) {
  const RigReader reader(path);
  StereoRig rig;
  rig.width_px = reader.size("image_width");
  rig.height_px = reader.size("image_height");
  rig.left = readCamera(reader, "1");
  rig.right = readCamera(reader, "2");
  rig.right_T_left = readPose(reader);
  rig.rms_px = reader.number("rms_px");
  rig.covariance = reader.optionalSquare("covariance");
  if (!rig.covariance.empty() &&
      rig.covariance.rows != int(14 + rig.left.distortion.total() + rig.right.distortion.total()))
    rig.covariance.release();  // it belongs to another model
  return rig;
}

void writeRig(const StereoRig& rig, const std::filesystem::path& path) {
  writeRig(rig, path, CalibrationNotes{});
}

void writeRig(const StereoRig& rig, const std::filesystem::path& path, const CalibrationNotes& notes) {
  cv::FileStorage storage(".yml",
                          cv::FileStorage::WRITE | cv::FileStorage::MEMORY | cv::FileStorage::FORMAT_YAML);
  const auto coefficients = [](const CameraModel& camera) {
    return camera.distortion.empty() ? cv::Mat::zeros(1, 5, CV_64F)
                                     : cv::Mat(camera.distortion.reshape(1, 1));
  };
  const Eigen::Vector3d t = rig.right_T_left.translation_mm();
  const Eigen::Matrix3d essential = skew(t) * rig.right_T_left.rotation();
  const cv::Mat e = toMat(essential), k1(rig.left.k), k2(rig.right.k);
  cv::Mat f = k2.inv().t() * e * k1.inv();
  if (std::abs(f.at<double>(2, 2)) > 1e-15) f /= f.at<double>(2, 2);
  storage << "image_width" << rig.width_px << "image_height" << rig.height_px;
  storage << "K1" << k1 << "D1" << coefficients(rig.left) << "K2" << k2 << "D2" << coefficients(rig.right);
  storage << "R" << toMat(rig.right_T_left.rotation()) << "T"
          << (cv::Mat_<double>(3, 1) << t.x(), t.y(), t.z());
  storage << "E" << e << "F" << f;
  if (rig.rms_px) storage << "rms_px" << *rig.rms_px;
  if (!rig.covariance.empty()) {
    cv::Mat sigmas(1, rig.covariance.rows, CV_64F);
    for (int i = 0; i < rig.covariance.rows; ++i)
      sigmas.at<double>(i) = std::sqrt(std::max(0.0, rig.covariance.at<double>(i, i)));
    storage << "standard_errors" << sigmas << "covariance" << rig.covariance;
  }
  writeNotes(storage, notes);
  writeWholeFile(path, storage.releaseAndGetString());
}

}  // namespace facenav::cameras
