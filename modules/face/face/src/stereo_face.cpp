#include "facenav/face/stereo_face.h"

#include <algorithm>

#include "facenav/core/robust_statistics.h"
#include "facenav/geometry/rigid_fit.h"

namespace facenav::face {
namespace {

// Share of the face's width. On two drawn faces of 180 px (worlds 3008, 3018) landmarks were off by 6 to 8 %;
// chosen on them.
constexpr double kLandmarkEpipolarShare = 0.1;
// Share of the face's width. Landmarks that disagree by more were misled in one camera: right ones differ by
// 0.3 to 1.3 %. Chosen on drawn worlds with even seeds (3000-3030, 8000-8020).
constexpr double kSteady = 0.015;
constexpr double kLandmarkFit_mm = 9.0;  // a landmark's depth has an error of several mm

/// Median distance of the landmarks from each other's epipolar lines, in widths of the face.
double disagreement(const cameras::StereoRig& rig, const FaceLandmarks& left, const FaceLandmarks& right) {
  std::vector<double> epipolar_px;
  for (std::size_t i = 0; i < std::min(left.points68.size(), right.points68.size()); ++i)
    epipolar_px.push_back(cameras::epipolarError_px(rig, left.points68[i], right.points68[i]));
  return epipolar_px.empty() ? 0.0 : upperMedian(epipolar_px) / left.face.width;
}

/// Joins what two cameras see of one face.
class FacePair {
 public:
  FacePair(const FaceDetector& detector, const cameras::StereoRig& rig, const cameras::StereoFrame& frame)
      : detector_(detector), rig_(rig), frame_(frame) {}

  std::optional<StereoFace> joined(const std::optional<FaceLandmarks>& left,
                                   const std::optional<FaceLandmarks>& right) const {
    if (!left || !right) return std::nullopt;
    StereoFace face{*left, *right, {}};
    double off = disagreement(rig_, *left, *right);
    if (off > kSteady) off = readAgain(face, off);
    if (off >= kLandmarkEpipolarShare) return std::nullopt;
    for (std::size_t i = 0; i < std::min(face.left.points68.size(), face.right.points68.size()); ++i) {
      face.points_mm.push_back(cameras::triangulate(rig_, face.left.points68[i], face.right.points68[i]).mm);
      if (face.points_mm.back().z() <= 0) return std::nullopt;
    }
    return face;
  }

 private:
  /// Replaces the landmarks by the readings that agree best; returns their disagreement.
  double readAgain(StereoFace& face, double off) const {
    const auto in_left = detector_.readings(frame_.left, face.left),
               in_right = detector_.readings(frame_.right, face.right);
    for (const FaceLandmarks& left : in_left)
      for (const FaceLandmarks& right : in_right)
        if (const double now = disagreement(rig_, left, right); now < off)
          off = now, face.left = left, face.right = right;
    return off;
  }

  const FaceDetector& detector_;
  const cameras::StereoRig& rig_;
  const cameras::StereoFrame& frame_;
};

std::vector<double> residuals(const Eigen::Isometry3d& motion, const std::vector<Eigen::Vector3d>& from,
                              const std::vector<Eigen::Vector3d>& to) {
  std::vector<double> lengths;
  for (std::size_t i = 0; i < from.size(); ++i) lengths.push_back((motion * from[i] - to[i]).norm());
  return lengths;
}

}  // namespace

std::optional<StereoFace> findStereoFace(const FaceDetector& detector, const cameras::StereoRig& rig,
                                         const cameras::StereoFrame& frame, const StereoFace* near) {
  const FacePair pair(detector, rig, frame);
  if (near)
    return pair.joined(detector.detectNear(frame.left, near->left),
                       detector.detectNear(frame.right, near->right));
  // The two cameras decide together: of the pairs that agree, the surest one. Two unsure ones that agree are
  // a face.
  const auto left = detector.detectAll(frame.left);
  if (left.empty()) return std::nullopt;
  std::optional<StereoFace> best;
  for (const auto& in_right : detector.detectAll(frame.right))
    for (const auto& in_left : left) {
      const double score = in_left.score + in_right.score;
      if (score < 0 || (best && score <= best->left.score + best->right.score)) continue;
      if (auto face = pair.joined(in_left, in_right)) best = std::move(face);
    }
  return best;
}

std::optional<StereoFace> findStereoFaceAtRoll(const FaceDetector& detector, const cameras::StereoRig& rig,
                                               const cameras::StereoFrame& frame, double roll_rad) {
  const auto left = detector.detectAtRoll(frame.left, roll_rad);
  if (!left) return std::nullopt;
  return FacePair(detector, rig, frame).joined(left, detector.detectAtRoll(frame.right, roll_rad));
}

std::optional<Eigen::Isometry3d> motionOfLandmarks(const std::vector<Eigen::Vector3d>& reference_mm,
                                                   const std::vector<Eigen::Vector3d>& current_mm) {
  if (reference_mm.size() != 68 || current_mm.size() != 68) return std::nullopt;
  std::vector<Eigen::Vector3d> from, to;
  for (int i = 17; i < 48; ++i) from.push_back(reference_mm[i]), to.push_back(current_mm[i]);
  std::vector<double> weights(from.size(), 1.0);
  Eigen::Isometry3d motion;
  for (int round = 0; round < 5; ++round) {
    motion = fitRigidPoints(from, to, weights).to_T_from;
    const auto lengths = residuals(motion, from, to);
    const double scale = std::max(1.0, upperMedian(lengths));
    for (std::size_t i = 0; i < weights.size(); ++i)
      weights[i] = 1.0 / (1.0 + std::pow(lengths[i] / scale, 2));
  }
  if (upperMedian(residuals(motion, from, to)) > kLandmarkFit_mm) return std::nullopt;
  return motion;
}

double depthOf(const cameras::StereoRig& rig, const StereoFace& face) {
  std::vector<double> depths_mm;
  for (const auto& p_mm : face.points_mm) depths_mm.push_back(p_mm.z());
  if (!depths_mm.empty()) return upperMedian(std::move(depths_mm));
  const auto centre = [](const cv::Rect& r) {
    return Eigen::Vector2d(r.x + 0.5 * r.width, r.y + 0.5 * r.height);
  };
  return cameras::triangulate(rig, centre(face.left.face), centre(face.right.face)).mm.z();
}

}  // namespace facenav::face
