#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "facenav/cameras/stereo_rig.h"

// The camera model of OpenCV (calib3d's introduction: radial k1..k6, tangential p1 p2, thin prism s1..s4,
// tilted sensor tau_x tau_y), with analytic derivatives throughout.

namespace facenav::cameras {
namespace {

using Matrix2d = Eigen::Matrix2d;
using Vector2d = Eigen::Vector2d;

struct Distortion {  // in the order of the file
  double k1 = 0, k2 = 0, p1 = 0, p2 = 0, k3 = 0, k4 = 0, k5 = 0, k6 = 0, s1 = 0, s2 = 0, s3 = 0, s4 = 0,
         tau_x = 0, tau_y = 0;
};
static_assert(sizeof(Distortion) == 14 * sizeof(double) && std::is_trivially_copyable_v<Distortion>);

Distortion coefficients(const cv::Mat& mat) {
  Distortion d;
  if (mat.empty()) return d;
  FACENAV_EXPECT(mat.type() == CV_64F && mat.isContinuous() && mat.total() <= 14,
                 "distortion must be 1 x n, 64-bit");
  std::memcpy(static_cast<void*>(&d), mat.ptr<double>(), mat.total() * sizeof(double));
  return d;
}

struct Distorted {
  Vector2d at;
  Matrix2d derivative;
};

Distorted tilt(const Distortion& d, const Distorted& flat) {
  const double cx = std::cos(d.tau_x), sx = std::sin(d.tau_x), cy = std::cos(d.tau_y), sy = std::sin(d.tau_y);
  Eigen::Matrix3d about_x, about_y, project_to_plane;
  about_x << 1, 0, 0, 0, cx, sx, 0, -sx, cx;
  about_y << cy, 0, -sy, 0, 1, 0, sy, 0, cy;
  const Eigen::Matrix3d rotation = about_y * about_x;
  project_to_plane << rotation(2, 2), 0, -rotation(0, 2), 0, rotation(2, 2), -rotation(1, 2), 0, 0, 1;
  const Eigen::Matrix3d m = project_to_plane * rotation;
  const Eigen::Vector3d q = m * flat.at.homogeneous();
  const Vector2d at = q.hnormalized();
  const Matrix2d derivative = (m.topLeftCorner<2, 2>() - at * m.bottomLeftCorner<1, 2>()) / q.z();
  return {at, derivative * flat.derivative};
}

Distorted distort(const Distortion& d, const Vector2d& n) {
  const double x = n.x(), y = n.y(), r2 = x * x + y * y, r4 = r2 * r2;
  const double above = 1 + r2 * (d.k1 + r2 * (d.k2 + r2 * d.k3)),
               below = 1 + r2 * (d.k4 + r2 * (d.k5 + r2 * d.k6));
  const double radial = above / below;
  const double d_above = d.k1 + r2 * (2 * d.k2 + 3 * r2 * d.k3),
               d_below = d.k4 + r2 * (2 * d.k5 + 3 * r2 * d.k6);
  const double d_radial = (d_above - radial * d_below) / below;  // derivative by r2
  const double prism_x = d.s1 + 2 * d.s2 * r2, prism_y = d.s3 + 2 * d.s4 * r2;
  Distorted out;
  out.at = {x * radial + 2 * d.p1 * x * y + d.p2 * (r2 + 2 * x * x) + d.s1 * r2 + d.s2 * r4,
            y * radial + d.p1 * (r2 + 2 * y * y) + 2 * d.p2 * x * y + d.s3 * r2 + d.s4 * r4};
  out.derivative << radial + 2 * x * x * d_radial + 2 * d.p1 * y + 6 * d.p2 * x + 2 * x * prism_x,
      2 * x * y * d_radial + 2 * d.p1 * x + 2 * d.p2 * y + 2 * y * prism_x,
      2 * x * y * d_radial + 2 * d.p1 * x + 2 * d.p2 * y + 2 * x * prism_y,
      radial + 2 * y * y * d_radial + 6 * d.p1 * y + 2 * d.p2 * x + 2 * y * prism_y;
  return d.tau_x == 0 && d.tau_y == 0 ? out : tilt(d, out);
}

Vector2d toNormalised(const CameraModel& camera, const Vector2d& pixel) {
  return {(pixel.x() - camera.k(0, 2)) / camera.k(0, 0), (pixel.y() - camera.k(1, 2)) / camera.k(1, 1)};
}

}  // namespace

Eigen::Vector2d project(const CameraModel& camera, const Eigen::Vector3d& p_mm) {
  const Vector2d n = distort(coefficients(camera.distortion), p_mm.hnormalized()).at;
  return {camera.k(0, 0) * n.x() + camera.k(0, 2), camera.k(1, 1) * n.y() + camera.k(1, 2)};
}

Eigen::Vector2d project(const CameraModel& camera, const Eigen::Vector3d& p_mm,
                        Eigen::Matrix<double, 2, 3>& jacobian) {
  const Vector2d flat = p_mm.hnormalized();
  const Distorted n = distort(coefficients(camera.distortion), flat);
  Eigen::Matrix<double, 2, 3> perspective;
  perspective << 1, 0, -flat.x(), 0, 1, -flat.y();
  const Vector2d focal(camera.k(0, 0), camera.k(1, 1));
  jacobian = focal.asDiagonal() * n.derivative * perspective / p_mm.z();
  return focal.cwiseProduct(n.at) + Vector2d(camera.k(0, 2), camera.k(1, 2));
}

Eigen::Vector2d undistort(const CameraModel& camera, const Eigen::Vector2d& pixel) {
  const Vector2d wanted = toNormalised(camera, pixel);
  const Distortion d = coefficients(camera.distortion);
  Vector2d n = wanted;
  Distorted now = distort(d, n);
  for (int iteration = 0; iteration < 30; ++iteration) {
    const Vector2d miss = wanted - now.at;
    if (miss.norm() < 1e-13) break;
    Vector2d step = now.derivative.inverse() * miss;
    if (!step.allFinite()) break;
    // Halves the step until the error falls: far off axis the polynomial bends, and a full Newton step may
    // jump across the fold.
    Distorted next = distort(d, n + step);
    for (int half = 0; half < 20 && !((wanted - next.at).norm() < miss.norm()); ++half)
      next = distort(d, n + (step *= 0.5));
    if (!((wanted - next.at).norm() < miss.norm())) break;
    n += step;
    now = next;
  }
  return n;
}

}  // namespace facenav::cameras
