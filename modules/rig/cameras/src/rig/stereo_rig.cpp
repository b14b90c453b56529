#include "facenav/cameras/stereo_rig.h"

#include "facenav/cameras/rig_file.h"
#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/geometry/rotation.h"
#include "rig_reader.h"

namespace facenav::cameras {
namespace {

constexpr double kShortestBaseline_mm = 5.0;

bool isSameLens(const CameraModel& a, const CameraModel& b) {
  return a.k == b.k && a.distortion.size() == b.distortion.size() &&
         (a.distortion.empty() || cv::norm(a.distortion, b.distortion) == 0.0);
}

RigidTransform<RightCamera, Camera> readPose(const RigReader& reader) {
  const Eigen::Matrix4d pose = reader.pose();
  const double baseline_mm = pose.topRightCorner<3, 1>().norm();
  if (baseline_mm == 0) reader.fail("key 'T' has zero length: both cameras would stand in one place");
  if (baseline_mm < kShortestBaseline_mm)
    reader.fail("key 'T' is only " + std::to_string(baseline_mm) +
                " long: it looks like metres, millimetres are needed");
  return reader.transform<RightCamera, Camera>();
}

/// Row time of a camera in s; the file has it in microseconds, or not at all.
double readRowTime(const RigReader& reader, const std::string& key, int rows) {
  const double row_time_s = 1e-6 * reader.number(key).value_or(0.0);
  if (!(std::abs(row_time_s) * rows <= kLongestReadout_s))
    reader.fail("key '" + key + "' is no row time in microseconds: a picture would take " +
                std::to_string(int(std::min(1e6, 1e3 * std::abs(row_time_s) * rows))) + " ms");
  return row_time_s;
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

bool isSameCalibration(const StereoRig& a, const StereoRig& b) {
  return a.width_px == b.width_px && a.height_px == b.height_px && isSameLens(a.left, b.left) &&
         isSameLens(a.right, b.right) && a.right_T_left.matrix() == b.right_T_left.matrix();
}

StereoRig readRig(const std::filesystem::path& path) {
  const RigReader reader(
      path, "write it with 'facenav calibrate' or cv::FileStorage (T in mm), see resources/doc/formats.md");
  StereoRig rig;
  rig.width_px = reader.size("image_width");
  rig.height_px = reader.size("image_height");
  rig.left = readCamera(reader, "1");
  rig.right = readCamera(reader, "2");
  rig.left.row_time_s = readRowTime(reader, "row_time1_us", rig.height_px);
  rig.right.row_time_s = readRowTime(reader, "row_time2_us", rig.height_px);
  rig.right_T_left = readPose(reader);
  rig.rms_px = reader.number("rms_px");
  rig.covariance = reader.optionalSquare("covariance");
  if (!rig.covariance.empty() &&
      rig.covariance.rows != int(14 + rig.left.distortion.total() + rig.right.distortion.total()))
    rig.covariance.release();  // the covariance belongs to another model
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
  if (rig.left.row_time_s != 0.0 || rig.right.row_time_s != 0.0)
    storage << "row_time1_us" << 1e6 * rig.left.row_time_s << "row_time2_us" << 1e6 * rig.right.row_time_s;
  if (rig.rms_px) storage << "rms_px" << *rig.rms_px;
  if (!rig.covariance.empty()) {
    cv::Mat sigmas(1, rig.covariance.rows, CV_64F);
    for (int i = 0; i < rig.covariance.rows; ++i)
      sigmas.at<double>(i) = std::sqrt(std::max(0.0, rig.covariance.at<double>(i, i)));
    storage << "standard_errors" << sigmas << "covariance" << rig.covariance;
  }
  writeNotes(storage, notes);
  writeWholeFile(path, storage.releaseAndGetString(), FileAccess::by_umask);
}

}  // namespace facenav::cameras
