#include "evaluate/picture_changes.h"
#include "facenav/geometry/normal_equations.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace facenav::app {
namespace {

constexpr int kShift_px = 13,  // sideways: about the same as rotating the whole rig
    kCoarse = 30;              // JPEG quality
constexpr double kDarker = 0.85;

// Mirrors the view of `other` into that of `camera` after rotation by `turn` (from the mirrored axes to the
// new ones).
cv::Mat mirroredPicture(const cameras::CameraModel& camera, const Eigen::Matrix3d& turn,
                        const cameras::CameraModel& other, const cv::Mat& seen) {
  cv::Mat2f from(seen.size());
  for (int y = 0; y < seen.rows; ++y)
    for (int x = 0; x < seen.cols; ++x) {
      Eigen::Vector3d ray =
          turn.transpose() * cameras::undistort(camera, {double(x), double(y)}).homogeneous();
      ray.x() = -ray.x();
      const Eigen::Vector2d px = ray.z() > 0 ? cameras::project(other, ray) : Eigen::Vector2d(-1, -1);
      from(y, x) = {float(px.x()), float(px.y())};
    }
  cv::Mat picture;
  cv::remap(seen, picture, from, {}, cv::INTER_LINEAR, cv::BORDER_CONSTANT, cv::Scalar(0));
  return picture;
}

cv::Mat shifted(const cv::Mat& picture) {
  cv::Mat moved;
  const cv::Matx23d by(1, 0, kShift_px, 0, 1, 0);
  cv::warpAffine(picture, moved, by, picture.size(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  return moved;
}

cv::Mat compressed(const cv::Mat& picture) {
  std::vector<unsigned char> bytes;
  cv::imencode(".jpg", picture, bytes, {cv::IMWRITE_JPEG_QUALITY, kCoarse});
  return cv::imdecode(bytes, cv::IMREAD_GRAYSCALE);
}

cv::Mat covered(const cv::Mat& picture, int from_y) {
  cv::Mat half = picture.clone();
  if (from_y < half.rows) half.rowRange(std::max(0, from_y), half.rows) = cv::Scalar(60);
  return half;
}

}  // namespace

// Mirroring exchanges the cameras: x_right' = M R^T M x_left' - M R^T T. Both are then rotated about their
// own centres to match the rig.
cameras::StereoFrame mirroredPair(const cameras::StereoRig& rig, const cameras::StereoFrame& frame) {
  const Eigen::Matrix3d mirror = Eigen::Vector3d(-1, 1, 1).asDiagonal();
  const Eigen::Matrix3d turn = rig.right_T_left.rotation();
  const Eigen::Vector3d shift_mm = rig.right_T_left.translation_mm();
  const Eigen::Matrix3d mirrored_turn = mirror * turn.transpose() * mirror;
  const Eigen::Vector3d mirrored_shift_mm = -(mirror * turn.transpose() * shift_mm);
  const Eigen::Matrix3d of_right = rotationBetween(mirrored_shift_mm, shift_mm).toRotationMatrix();
  const Eigen::Matrix3d of_left = turn.transpose() * of_right * mirrored_turn;
  cameras::StereoFrame mirrored = frame;
  mirrored.left = mirroredPicture(rig.left, of_left, rig.right, frame.right);
  mirrored.right = mirroredPicture(rig.right, of_right, rig.left, frame.left);
  return mirrored;
}

std::vector<ChangedPair> changedPairs(const cameras::StereoFrame& frame, int lower_face_y_left,
                                      int lower_face_y_right) {
  const auto both = [&](auto change) {
    cameras::StereoFrame changed = frame;
    changed.left = change(frame.left), changed.right = change(frame.right);
    return changed;
  };
  std::vector<ChangedPair> changes;
  changes.push_back({"shifted by 13 px", both(shifted)});
  changes.push_back({"15 % darker", both([](const cv::Mat& p) { return cv::Mat(p * kDarker); })});
  changes.push_back({"coarser JPEG", both(compressed)});
  cameras::StereoFrame half = frame;
  half.left = covered(frame.left, lower_face_y_left), half.right = covered(frame.right, lower_face_y_right);
  changes.push_back({"lower face covered", half});
  return changes;
}

}  // namespace facenav::app
