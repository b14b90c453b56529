#include "coil_scene.h"
#include "facenav/geometry/normal_equations.h"

#include <cmath>
#include <opencv2/aruco.hpp>
#include <opencv2/imgproc.hpp>

#include "support/pixel_rays.h"

namespace facenav::coil_tracking::testing {
namespace {

constexpr int kRays =
    25;  // per pixel, on a lattice: no two share a row or column, so edges are not quantised

struct CameraView {
  const cameras::CameraModel& camera;
  Eigen::Isometry3d view_T_camera;
};

/// Region of the print's paper in the image at this pose, with a margin.
cv::Rect region(const CameraView& view, const PlacedPrint& placed, const Eigen::Isometry3d& pose,
                cv::Size size) {
  const double half_mm = (0.5 + placed.margin_cells / placed.print.rows) * placed.size_mm;
  cv::Rect2d box;
  for (const double x : {-half_mm, half_mm})
    for (const double y : {-half_mm, half_mm}) {
      const Eigen::Vector3d p_mm = view.view_T_camera * (pose * Eigen::Vector3d(x, y, 0));
      if (p_mm.z() < 10) return {};
      const Eigen::Vector2d p = cameras::project(view.camera, p_mm);
      const cv::Rect2d corner(p.x() - 4, p.y() - 4, 8, 8);
      box = box.empty() ? corner : box | corner;
    }
  return cv::Rect(cv::Point(int(box.x), int(box.y)), cv::Point(int(box.br().x), int(box.br().y))) &
         cv::Rect(cv::Point(), size);
}

/// Light on the print's paper at (x, y) mm; negative outside the paper.
double lightAt(const PlacedPrint& placed, double x_mm, double y_mm) {
  const int n = placed.print.rows;
  const double column = (x_mm / placed.size_mm + 0.5) * n, row = (y_mm / placed.size_mm + 0.5) * n;
  const double m = placed.margin_cells;
  if (column < -m || row < -m || column > n + m || row > n + m) return -1;
  if (column < 0 || row < 0 || column >= n || row >= n) return 1;
  return placed.print(int(row), int(column));
}

void drawPrint(const CameraView& view, const PlacedPrint& placed, const SceneOptions& options,
               cv::Mat_<float>& image) {
  const auto inRow = [&](double row) { return placed.inRow(row, view.camera, image.rows); };
  const cv::Rect box =
      region(view, placed, inRow(0), image.size()) | region(view, placed, inRow(image.rows), image.size());
  using facenav::testing::pixelRays;
  const auto rays = pixelRays(view.camera, image.size()),
             rays_by_u = pixelRays(view.camera, image.size(), {0.5, 0}),
             rays_by_v = pixelRays(view.camera, image.size(), {0, 0.5});
  for (int v = box.y; v < box.br().y; ++v) {
    const Eigen::Isometry3d marker_T_view = (view.view_T_camera * inRow(v)).inverse();
    const Eigen::Vector3d eye_mm = marker_T_view.translation();
    if (eye_mm.z() > 0) return;  // seen from behind
    for (int u = box.x; u < box.br().x; ++u) {
      // Undistorted coordinates are smooth: interpolated linearly within the pixel from its centre and two
      // neighbours.
      const Eigen::Vector2d n = rays->at(u, v);
      const Eigen::Vector2d by_u = rays_by_u->at(u, v) - n, by_v = rays_by_v->at(u, v) - n;
      double sum = 0;
      for (int ray_number = 0; ray_number < kRays; ++ray_number) {
        const double du = (ray_number + 0.5) / kRays - 0.5, dv = (ray_number * 7 % kRays + 0.5) / kRays - 0.5;
        const Eigen::Vector3d ray =
            marker_T_view.linear() * (n + 2 * du * by_u + 2 * dv * by_v).homogeneous();
        const Eigen::Vector3d hit_mm = eye_mm - ray * (eye_mm.z() / ray.z());
        const double light = lightAt(placed, hit_mm.x(), hit_mm.y());
        sum +=
            light < 0 ? image(v, u) : options.black_grey + light * (options.white_grey - options.black_grey);
      }
      image(v, u) = float(sum / kRays);
    }
  }
}

cv::Mat_<float> ground(cv::Size size, const SceneOptions& options, cv::RNG& random) {
  cv::Mat_<float> image(size, float(options.ground_grey));
  if (!options.has_clutter) return image;
  for (int i = 0; i < 60; ++i) {
    const cv::Point2f centre(random.uniform(0.f, float(size.width)), random.uniform(0.f, float(size.height)));
    const cv::RotatedRect shape(centre, {random.uniform(5.f, 90.f), random.uniform(5.f, 90.f)},
                                random.uniform(0.f, 180.f));
    cv::Point2f corners[4];
    shape.points(corners);
    std::vector<cv::Point> polygon(corners, corners + 4);
    cv::fillConvexPoly(image, polygon, cv::Scalar(random.uniform(20.f, 180.f)), cv::LINE_AA);
  }
  return image;
}

cv::Mat render(const CameraView& view, cv::Size size, const std::vector<PlacedPrint>& prints,
               const SceneOptions& options, unsigned seed) {
  cv::RNG random(seed);
  cv::Mat_<float> image = ground(size, options, random);
  for (const PlacedPrint& placed : prints) drawPrint(view, placed, options, image);
  for (int v = 0; v < size.height; ++v)
    for (int u = 0; u < size.width; ++u) {
      image(v, u) *= float(1.0 + options.side_light * (double(u) / size.width - 0.5));
      if (u > options.shadow_from_x) image(v, u) *= float(options.shadow_factor);
    }
  if (options.blur_sigma_px > 0) cv::GaussianBlur(image, image, {}, options.blur_sigma_px);
  if (options.gamma != 1.0) {
    cv::pow(image / 255.0, options.gamma, image);
    image *= 255.0;
  }
  cv::Mat_<float> noise(size);
  random.fill(noise, cv::RNG::NORMAL, 0.0, std::max(1e-9, options.noise_grey));
  cv::Mat grey;
  cv::Mat(image + noise).convertTo(grey, CV_8U);
  return grey;
}

cameras::CameraModel camera(double f, double cx, double cy, const std::vector<double>& distortion) {
  cameras::CameraModel model;
  model.k = {f, 0, cx, 0, f * 1.002, cy, 0, 0, 1};
  model.distortion = cv::Mat(distortion, true).reshape(1, 1);
  return model;
}

}  // namespace

Print arucoPrint(int predefined_dictionary, int id) {
  const auto dictionary = cv::aruco::getPredefinedDictionary(predefined_dictionary);
  const int cells = dictionary->markerSize + 2;
  cv::Mat image;
  cv::aruco::drawMarker(dictionary, id, cells * 10, image, 1);  // the reference is OpenCV's own print
  Print print(cells, cells);
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x) print(y, x) = image.at<uchar>(y * 10 + 5, x * 10 + 5) > 127 ? 1.f : 0.f;
  return print;
}

Print mirrored(const Print& print) {
  Print flipped;
  cv::flip(print, flipped, 1);
  return flipped;
}

cameras::StereoFrame renderMarkers(const cameras::StereoRig& rig, const std::vector<PlacedPrint>& prints,
                                   const SceneOptions& options) {
  const cv::Size size(rig.width_px, rig.height_px);
  cameras::StereoFrame frame;
  frame.left = render({rig.left, Eigen::Isometry3d::Identity()}, size, prints, options, 2 * options.seed);
  frame.right = render({rig.right, rig.right_T_left.isometry()}, size, prints, options, 2 * options.seed + 1);
  return frame;
}

cameras::StereoRig roomRig() {
  cameras::StereoRig rig;
  rig.width_px = 640;
  rig.height_px = 480;
  rig.left = camera(801, 322.3, 238.1, {-0.12, 0.09, 0.0006, -0.0004, 0.01});
  rig.right = camera(797, 315.8, 243.4, {-0.11, 0.07, -0.0005, 0.0003, 0.0});
  Eigen::Isometry3d camera_T_right = Eigen::Isometry3d::Identity();
  camera_T_right.linear() =
      Eigen::AngleAxisd(-10 * M_PI / 180, Eigen::Vector3d(0.03, 1, 0.02).normalized()).matrix();
  camera_T_right.translation() << 119, 1.5, 9;
  rig.right_T_left = RigidTransform<Camera, RightCamera>::fromIsometry(camera_T_right).inverse();
  return rig;
}

cameras::StereoRig steepRig() {
  cameras::StereoRig rig;
  rig.width_px = 1000;
  rig.height_px = 750;
  rig.left = camera(1150, 507, 371, {0.1, -0.2, 0.0004, 0.0002, 0.05, 0.15, -0.12, 0.02});
  rig.right = camera(1161, 494, 380, {0.08, -0.15, -0.0003, 0.0001, 0.03, 0.12, -0.1, 0.02});
  const double roll = 80 * M_PI / 180;
  const Eigen::Vector3d along(std::cos(roll), std::sin(roll), 0), across(-std::sin(roll), std::cos(roll), 0);
  Eigen::Isometry3d camera_T_right = Eigen::Isometry3d::Identity();
  camera_T_right.linear() = Eigen::AngleAxisd(-14 * M_PI / 180, across).matrix();
  camera_T_right.translation() = 178 * along + Eigen::Vector3d(0, 0, 20);
  rig.right_T_left = RigidTransform<Camera, RightCamera>::fromIsometry(camera_T_right).inverse();
  return rig;
}

RigidTransform<Camera, Marker> markerPose(double distance_mm, double tilt_deg, double axis_deg,
                                          double turn_deg, const Eigen::Vector2d& side_mm) {
  const double degree = M_PI / 180, axis_rad = axis_deg * degree;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  const Eigen::Vector3d towards(50 + side_mm.x(), side_mm.y(),
                                distance_mm);  // between the cameras, shifted by side_mm
  pose.linear() =
      rotationBetween(Eigen::Vector3d::UnitZ(), towards).matrix() *
      Eigen::AngleAxisd(tilt_deg * degree, Eigen::Vector3d(std::cos(axis_rad), std::sin(axis_rad), 0)) *
      Eigen::AngleAxisd(turn_deg * degree, Eigen::Vector3d::UnitZ());
  pose.translation() = towards;
  return RigidTransform<Camera, Marker>::fromIsometry(pose);
}

}  // namespace facenav::coil_tracking::testing
