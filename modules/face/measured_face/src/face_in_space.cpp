#include "facenav/measured_face/face_in_space.h"

#include <algorithm>
#include <cmath>

#include "facenav/anatomy/face_norms.h"
#include "facenav/anatomy/head_norms.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/face/stereo_face.h"

namespace facenav::measured_face {
namespace {

// Largest distance of a landmark from the other camera's epipolar line, in widths of the face (some 7 mm).
constexpr double kEpipolarShare = 0.04;

using Triangulated = std::vector<std::optional<Eigen::Vector3d>>;

Triangulated triangulateAll(const cameras::StereoRig& rig, const face::FaceLandmarks& left,
                            const face::FaceLandmarks& right) {
  Triangulated points(68);
  for (int i = 0; i < 68; ++i) {
    if (cameras::epipolarError_px(rig, left.points68[i], right.points68[i]) >
        kEpipolarShare * left.face.width)
      continue;
    const Eigen::Vector3d p = cameras::triangulate(rig, left.points68[i], right.points68[i]).mm;
    if (p.allFinite() && p.z() > 100.0 && p.z() < 5000.0) points[i] = p;
  }
  return points;
}

/// The landmarks' common plane, as depth over x and y (mm) from their middle.
struct DepthPlane {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  Eigen::Vector3d coefficients = Eigen::Vector3d::Zero();  // of (x, y, 1)
  double deviation_mm = 0.0;                               // of the points from it, robust
  Eigen::Vector3d row(const Eigen::Vector3d& p) const {
    return {p.x() - middle.x(), p.y() - middle.y(), 1.0};
  }
  double at(const Eigen::Vector3d& p) const { return coefficients.dot(row(p)); }
};

/// Fits the plane to at least one point, outliers with a low weight. A face is usually turned towards the
/// cameras, which limits the plane's slope where the depths scatter.
DepthPlane planeThrough(const std::vector<Eigen::Vector3d>& points) {
  constexpr int kRounds = 8;
  constexpr double kSlope = 0.4;   // standard deviation: turned by 20 degrees
  constexpr double kShared = 8.0;  // landmarks of one part of the face share their error
  DepthPlane plane;
  for (const auto& p : points) plane.middle += p / double(points.size());
  plane.coefficients.z() = plane.middle.z();
  double scale_mm = 0;
  for (int round = 0; round <= kRounds; ++round) {
    std::vector<double> off_mm;
    for (const auto& p : points) off_mm.push_back(std::abs(p.z() - plane.at(p)));
    scale_mm = std::max(1.0, kSigmaPerMad * upperMedian(off_mm));
    Eigen::Matrix3d normal = Eigen::Vector3d(1, 1, 0).asDiagonal().toDenseMatrix() / (kSlope * kSlope);
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double weight = 1.0 / (kShared * (scale_mm * scale_mm + off_mm[i] * off_mm[i]));
      const Eigen::Vector3d row = plane.row(points[i]);
      normal += weight * row * row.transpose(), right += weight * points[i].z() * row;
    }
    plane.coefficients = normal.ldlt().solve(right);
  }
  plane.deviation_mm = scale_mm;
  return plane;
}

/// Draws the landmarks along their rays towards their common plane. The depths of a far face scatter by
/// centimetres; the scatter beyond a face's own relief is taken away.
void steadyDepths(Triangulated& points) {
  constexpr double kRelief_mm = 10.0;  // of brows, eyes, nose, mouth and jaw about a plane
  std::vector<Eigen::Vector3d> seen;
  for (const auto& p : points)
    if (p) seen.push_back(*p);
  const DepthPlane plane = planeThrough(seen);
  const double own = std::min(1.0, std::pow(kRelief_mm / plane.deviation_mm, 2));
  for (auto& p : points)
    if (p) *p *= (plane.at(*p) + own * (p->z() - plane.at(*p))) / p->z();
}

std::optional<Eigen::Vector3d> mean(const Triangulated& points, int first, int last) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int n = 0;
  for (int i = first; i <= last; ++i)
    if (points[i]) sum += *points[i], ++n;
  if (n == 0) return std::nullopt;
  return sum / n;
}

/// Leaves the start open if the cameras disagree about most landmarks: the few left agree by chance.
void setStart(FaceInSpace& face, Triangulated points) {
  const auto agreeing =
      std::count_if(points.begin(), points.end(), [](const auto& p) { return p.has_value(); });
  if (2 * agreeing < std::ptrdiff_t(points.size())) return;
  steadyDepths(points);
  const auto right_eye = mean(points, 36, 41), left_eye = mean(points, 42, 47), mouth = mean(points, 48, 67);
  if (!right_eye || !left_eye) return;
  const double eyes_mm = (*right_eye - *left_eye).norm();
  if (!anatomy::kEyesInSpace.contains(eyes_mm)) return;  // one of the two is not this face
  face.start.patient_right = Direction<Camera>(*right_eye - *left_eye);
  if (mouth) {
    const Eigen::Vector3d x = face.start.patient_right->v;
    const Eigen::Vector3d up = 0.5 * (*right_eye + *left_eye) - *mouth;
    face.start.patient_superior = Direction<Camera>(up - up.dot(x) * x);
  }
  if (points[30]) face.start.nose_tip = Point<Camera>(*points[30]);
  const Eigen::Vector3d eyes = 0.5 * (*right_eye + *left_eye);
  face.centre = Point<Camera>(mouth ? Eigen::Vector3d(0.6 * eyes + 0.4 * *mouth) : eyes);
}

stereo::FaceCloud select(const stereo::FaceCloud& cloud, const std::vector<std::size_t>& indices) {
  stereo::FaceCloud out;
  out.epipolar_median_px = cloud.epipolar_median_px;
  for (const std::size_t i : indices) {
    out.cloud.points_mm.push_back(cloud.cloud.points_mm[i]);
    if (!cloud.cloud.normals.empty()) out.cloud.normals.push_back(cloud.cloud.normals[i]);
    if (!cloud.left_px.empty()) out.left_px.push_back(cloud.left_px[i]);
    if (!cloud.sigma_mm.empty()) out.sigma_mm.push_back(cloud.sigma_mm[i]);
  }
  return out;
}

/// Depth of the nearest surface with at least a tenth of the points.
double nearestLargeDepth_mm(const PointCloud<Camera>& cloud) {
  std::vector<double> depths;
  depths.reserve(cloud.size());
  for (const auto& p : cloud.points_mm) depths.push_back(p.z());
  return selectRank(depths, depths.size() / 10);
}

}  // namespace

FaceInSpace findFace(const cameras::StereoRig& rig, const cameras::StereoFrame& plain,
                     const face::FaceDetector& detector) {
  FaceInSpace face;
  if (auto both = face::findStereoFace(detector, rig, plain)) {
    face.left = std::move(both->left), face.right = std::move(both->right);
  } else {
    face.left = detector.detect(plain.left);
    face.right = detector.detect(plain.right);
  }
  if (face.left && face.right && face.left->points68.size() == 68 && face.right->points68.size() == 68)
    setStart(face, triangulateAll(rig, *face.left, *face.right));
  return face;
}

stereo::FaceCloud cutFace(const stereo::FaceCloud& cloud, const FaceInSpace& face) {
  std::vector<std::size_t> kept;
  const double nearest_mm = cloud.cloud.empty() ? 0.0 : nearestLargeDepth_mm(cloud.cloud);
  for (std::size_t i = 0; i < cloud.cloud.size(); ++i) {
    const Eigen::Vector3d& p = cloud.cloud.points_mm[i];
    const bool is_face = face.centre ? (p - face.centre->mm).norm() < anatomy::kFaceReach_mm
                                     : std::abs(p.z() - nearest_mm) < 0.75 * anatomy::kHeadDepth_mm;
    if (is_face) kept.push_back(i);
  }
  return select(cloud, kept);
}

}  // namespace facenav::measured_face
