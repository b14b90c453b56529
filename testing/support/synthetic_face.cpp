#include "support/synthetic_face.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <random>

#include "support/pixel_rays.h"

namespace facenav::testing {
namespace {

constexpr double kWidth_mm = 78, kLength_mm = 112, kDepth_mm = 95;  // semi-axes of the ellipsoid
// Camera coordinates of the face's foremost point at the reference, between the two cameras' axes.
const Eigen::Vector3d kFace_mm(0, 0, 600);

double bump(double x, double y, double cx, double cy, double sx, double sy) {
  const double u = (x - cx) / sx, v = (y - cy) / sy, square = u * u + v * v;
  return square > 40 ? 0.0 : std::exp(-0.5 * square);  // beyond that: below 2e-9
}

float cubic(const cv::Mat1f& image, double x, double y) {
  const int ix = int(std::floor(x)), iy = int(std::floor(y));
  if (ix < 1 || iy < 1 || ix >= image.cols - 2 || iy >= image.rows - 2) return 60.f;
  const auto weights = [](double t, double* w) {  // Catmull-Rom
    w[0] = 0.5 * (-t + 2 * t * t - t * t * t), w[1] = 0.5 * (2 - 5 * t * t + 3 * t * t * t);
    w[2] = 0.5 * (t + 4 * t * t - 3 * t * t * t), w[3] = 0.5 * (-t * t + t * t * t);
  };
  double wx[4], wy[4], sum = 0;
  weights(x - ix, wx), weights(y - iy, wy);
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) sum += wy[j] * wx[i] * image(iy - 1 + j, ix - 1 + i);
  return float(sum);
}

}  // namespace

SyntheticFace::SyntheticFace(const cv::Mat& portrait, Eigen::Vector2d left_eye_px,
                             Eigen::Vector2d right_eye_px) {
  portrait.convertTo(portrait_, CV_32F);
  texture_px_per_mm_ = (right_eye_px - left_eye_px).norm() / 92.0;
  texture_centre_px_ =
      0.5 * (left_eye_px + right_eye_px) + Eigen::Vector2d(0, 34 * texture_px_per_mm_);  // nose tip
}

SyntheticFace SyntheticFace::astronaut() {
  return SyntheticFace(cv::imread(portraitPath(), cv::IMREAD_GRAYSCALE), {195, 100}, {259, 104});
}

SyntheticFace SyntheticFace::stranger() {
  cv::Mat portrait = cv::imread(portraitPath(), cv::IMREAD_GRAYSCALE), moved(portrait.size(), CV_8U);
  cv::Mat1f map_x(portrait.size()), map_y(portrait.size());
  for (int y = 0; y < portrait.rows; ++y)
    for (int x = 0; x < portrait.cols; ++x) {
      map_x(y, x) = float(448 - x + 4 * std::sin(y / 9.0));
      map_y(y, x) = float(110 + (y - 110) * (1.0 + 0.12 * std::sin((y - 90) / 25.0)) + 3 * std::sin(x / 8.0));
    }
  cv::remap(portrait, moved, map_x, map_y, cv::INTER_CUBIC, cv::BORDER_REPLICATE);
  SyntheticFace face(moved, {195, 110}, {253, 110});
  face.nose_mm_ = 14;
  return face;
}

// Depth (mm, away from the camera) of the skin relative to the face's plane; x right, y down from the nose
// tip.
double SyntheticFace::height(double x, double y) const {
  const double u = x / kWidth_mm, v = (y + 10) / kLength_mm, r = u * u + v * v;
  const double ellipsoid =
      r < 0.96 ? kDepth_mm * (1 - std::sqrt(1 - r)) : kDepth_mm * (0.8 + 6.0 * (r - 0.96));
  return ellipsoid - nose_mm_ * bump(x, y, 0, 0, 9, 13) - 6 * bump(x, y, 0, -25, 7, 14) +
         6 * bump(x, y, -31, -33, 12, 8) + 6 * bump(x, y, 31, -33, 12, 8) - 3 * bump(x, y, 0, 32, 20, 8);
}

Eigen::Vector3d SyntheticFace::hit(const Eigen::Vector3d& origin, const Eigen::Vector3d& ray, bool& is_hit,
                                   double& near_t) const {
  is_hit = false;
  const double to_axis = (kFace_mm - origin).dot(ray), middle = kFace_mm.z() + 50;
  if (to_axis <= 0 || ray.z() <= 0.1) return {};
  const Eigen::Vector3d across = origin + (middle - origin.z()) / ray.z() * ray - kFace_mm;
  if (across.head<2>().norm() > 165) return {};
  constexpr double kBefore_mm = 8;  // starts this far before a nearby ray's hit, to find nearer skin first
  double t = near_t > 0 ? near_t - kBefore_mm : (kFace_mm.z() - 30 - origin.z()) / ray.z();
  near_t = 0;
  double last_t = t, last_gap = 0;
  for (int i = 0; i < 60; ++i) {
    const Eigen::Vector3d p = origin + t * ray - kFace_mm;
    const double gap = height(p.x(), p.y()) - p.z();
    if (std::abs(gap) < 1e-4) {
      is_hit = p.z() < kDepth_mm;
      near_t = is_hit ? t : 0;
      break;
    }
    if (p.z() > kDepth_mm + 10) break;
    const double damped = (gap > 0 ? 0.6 : 0.9) * gap / std::max(0.3, ray.z());
    // Uses the secant step if it has the same sign and is not much longer.
    const double secant = i < 3 || gap == last_gap ? damped : -gap * (t - last_t) / (gap - last_gap);
    const bool is_safe = secant * damped > 0 && std::abs(secant) < 2.5 * std::abs(damped);
    last_t = t, last_gap = gap;
    t += is_safe ? secant : damped;
  }
  return origin + t * ray - kFace_mm;
}

cv::Mat SyntheticFace::image(const cameras::CameraModel& camera, const Eigen::Isometry3d& camera_T_left,
                             cv::Size size, const SyntheticView& view, std::uint64_t seed) const {
  cv::Mat1f shaded(size);
  const auto rays = pixelRays(camera, size);
  const Eigen::Isometry3d head_T_camera = (camera_T_left * view.motion).inverse();
  const Eigen::Vector3d lamp = Eigen::Vector3d(view.lamp_x, -0.4, -1).normalized(),
                        origin = head_T_camera.translation();
  std::vector<double> wave(static_cast<std::size_t>(size.width));
  for (int x = 0; x < size.width; ++x) wave[std::size_t(x)] = 25 * std::sin(x / 17.0);
  for (int y = 0; y < size.height; ++y) {
    const double down = std::cos(y / 23.0);
    double near_t = 0;
    for (int x = 0; x < size.width; ++x) {
      const Eigen::Vector2d n = rays->at(x, y);
      bool is_hit = false;
      const Eigen::Vector3d p =
          hit(origin, (head_T_camera.linear() * n.homogeneous()).normalized(), is_hit, near_t);
      if (!is_hit) {
        shaded(y, x) = float(70 + wave[std::size_t(x)] * down + (x / 40 + y / 40) % 2 * 20);
        continue;
      }
      if (view.cover_mm.contains({p.x(), p.y()})) {
        shaded(y, x) = float(110 + 8 * std::sin(p.x() / 3));
        continue;
      }
      const double e = 0.1;
      const Eigen::Vector3d normal =
          Eigen::Vector3d((height(p.x() + e, p.y()) - height(p.x() - e, p.y())) / (2 * e),
                          (height(p.x(), p.y() + e) - height(p.x(), p.y() - e)) / (2 * e), -1)
              .normalized();
      const double light = 0.35 + 0.75 * std::max(0.0, lamp.dot(view.motion.linear() * normal));
      const double slide = p.y() > 20 ? view.jaw_drop_mm * std::min(1.0, (p.y() - 20) / 15) : 0.0;
      const double grey = cubic(portrait_, texture_centre_px_.x() + texture_px_per_mm_ * p.x(),
                                texture_centre_px_.y() + texture_px_per_mm_ * (p.y() - slide));
      shaded(y, x) = float(view.gain * light * grey);
    }
  }
  cv::GaussianBlur(shaded, shaded, {5, 5}, 0.6);
  cv::Mat1f noise(size);
  cv::RNG random(seed);
  random.fill(noise, cv::RNG::NORMAL, 0.0, view.noise_grey);
  if (view.noise_grey > 0) shaded += noise;
  cv::Mat result;
  shaded.convertTo(result, CV_8U);
  return result;
}

cameras::StereoFrame SyntheticFace::render(const cameras::StereoRig& rig, const SyntheticView& view) const {
  const cv::Size size(rig.width_px, rig.height_px);
  cameras::StereoFrame frame;
  frame.left = image(rig.left, Eigen::Isometry3d::Identity(), size, view, 2 * view.seed);
  frame.right = image(rig.right, rig.right_T_left.isometry(), size, view, 2 * view.seed + 1);
  frame.captured.s = view.time_s;
  return frame;
}

head_tracking::HeadReference SyntheticFace::reference(const cameras::StereoRig& rig, bool with_surface,
                                                      const SyntheticView& view) const {
  head_tracking::HeadReference reference;
  reference.frame = render(rig, view);
  if (!with_surface) return reference;
  const Eigen::Isometry3d head_T_camera = view.motion.inverse();
  const auto rays = pixelRays(rig.left, {rig.width_px, rig.height_px});
  for (int y = 0; y < rig.height_px; y += 2) {
    double near_t = 0;
    for (int x = 0; x < rig.width_px; x += 2) {
      bool is_hit = false;
      const Eigen::Vector3d ray = rays->at(x, y).homogeneous();
      const Eigen::Vector3d p =
          hit(head_T_camera.translation(), (head_T_camera.linear() * ray).normalized(), is_hit, near_t);
      if (!is_hit || p.z() > 70) continue;
      reference.surface.points_mm.push_back(view.motion * (p + kFace_mm));
      reference.surface_left_px.emplace_back(float(x), float(y));
    }
  }
  return reference;
}

cameras::StereoRig faceRig() {
  cameras::StereoRig rig;
  rig.width_px = 640, rig.height_px = 480;
  rig.left.k = cv::Matx33d(800, 0, 318, 0, 802, 242, 0, 0, 1);
  rig.right.k = cv::Matx33d(795, 0, 325, 0, 796, 236, 0, 0, 1);
  rig.left.distortion = (cv::Mat1d(1, 5) << -0.12, 0.05, 0.0005, -0.0004, 0.0);
  rig.right.distortion = (cv::Mat1d(1, 5) << -0.10, 0.04, -0.0003, 0.0006, 0.0);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(10 * M_PI / 180, Eigen::Vector3d::UnitY()).toRotationMatrix();
  const Eigen::Vector3d right_centre_mm(120, 2, 10);
  rig.right_T_left = RigidTransform<RightCamera, Camera>(Eigen::Quaterniond(turn), -(turn * right_centre_mm));
  return rig;
}

}  // namespace facenav::testing
