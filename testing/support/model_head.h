#pragma once
// A head in closed form for alignment tests: a star-shaped surface (ellipsoid plus brow, eye sockets, nose,
// mouth, chin, ears, and asymmetric bumps from a seed that make it one person), and the camera's measurement
// of it, with noise, hair, clothes.

#include <cmath>
#include <random>

#include "facenav/registration/aligner.h"

namespace facenav::testing {

struct Bump {
  Eigen::Vector3d direction;  // unit, Mri
  double height_mm, width_rad;
};

inline Eigen::Vector3d towards(double right_deg, double up_deg) {
  const double a = right_deg * M_PI / 180, e = up_deg * M_PI / 180;
  return {std::sin(a) * std::cos(e), std::cos(a) * std::cos(e), std::sin(e)};
}

struct ModelHead {
  std::vector<Bump> bumps;
  Eigen::Vector3d radii_mm{75, 95, 110};

  explicit ModelHead(std::uint32_t person = 1) {
    bumps = {{towards(0, -14), 22, 0.14}, {towards(0, -3), 9, 0.12},   {towards(19, 6), 4, 0.12},
             {towards(-19, 6), 4, 0.12},  {towards(20, -3), -8, 0.13}, {towards(-20, -3), -8, 0.13},
             {towards(0, -30), 5, 0.16},  {towards(0, -45), 9, 0.2},   {towards(0, -23), -3, 0.1},
             {towards(88, -8), 14, 0.1},  {towards(-88, -8), 14, 0.1}};
    std::mt19937 random(person);
    std::normal_distribution<double> normal;
    for (int b = 0; b < 60; ++b) {
      const double right = 60 * normal(random), up = 35 * normal(random);
      bumps.push_back({towards(right, up), 1.6 * normal(random), 0.2});
    }
    for (int a = 0; a < 3; ++a) radii_mm[a] += 2.5 * normal(random);
  }
  double radius_mm(const Eigen::Vector3d& direction) const {
    double r = 1.0 / direction.cwiseQuotient(radii_mm).norm();
    for (const Bump& b : bumps) {
      const double along = direction.dot(b.direction);
      if (along > 0.3) r += b.height_mm * std::exp((along - 1) / (b.width_rad * b.width_rad));
    }
    return r;
  }
  Eigen::Vector3d at(const Eigen::Vector3d& direction) const { return radius_mm(direction) * direction; }
  Eigen::Vector3d normal(const Eigen::Vector3d& direction) const {
    const Eigen::Vector3d u = direction.unitOrthogonal(), v = direction.cross(u);
    constexpr double h = 1e-3;
    const auto tangent = [&](const Eigen::Vector3d& t) {
      return Eigen::Vector3d(at((direction + h * t).normalized()) - at((direction - h * t).normalized()));
    };
    return tangent(u).cross(tangent(v)).normalized();
  }

  /// The skin above `lowest_z_mm` (open below, like the end of a scan), vertices about 2 mm apart.
  registration::SkinModel skin(double lowest_z_mm = -85) const {
    registration::SkinModel skin;
    constexpr int kRows = 150, kColumns = 280;
    std::vector<int> index(kRows * kColumns, -1);
    for (int row = 0; row < kRows; ++row)
      for (int column = 0; column < kColumns; ++column) {
        const Eigen::Vector3d direction =
            towards(column * 360.0 / kColumns, 89.0 - row * 178.0 / (kRows - 1));
        if (at(direction).z() < lowest_z_mm) continue;
        index[row * kColumns + column] = int(skin.points.size());
        skin.points.points_mm.push_back(at(direction));
        skin.points.normals.push_back(normal(direction));
      }
    for (int row = 0; row + 1 < kRows; ++row)
      for (int column = 0; column < kColumns; ++column) {
        const int right = (column + 1) % kColumns;
        const int a = index[row * kColumns + column], b = index[row * kColumns + right];
        const int c = index[(row + 1) * kColumns + column], d = index[(row + 1) * kColumns + right];
        if (a < 0 || b < 0 || c < 0 || d < 0) continue;
        skin.triangles.emplace_back(a, b, c);
        skin.triangles.emplace_back(b, d, c);
      }
    skin.field_of_view.emplace_back(Point<Mri>(0, 0, lowest_z_mm), Direction<Mri>(Eigen::Vector3d(0, 0, -1)));
    return skin;
  }
};

/// The camera's view: the front (cos > 0.3), evenly distributed points, 2-5 mm of hair above the hairline,
/// clothes below.
struct CameraView {
  double noise_mm = 0.2;
  bool has_hair = true, has_clothes = true;
  double least_z_mm = -100, most_z_mm = 200;  // measured part of the head, Mri
  int points = 12000;
  std::uint32_t seed = 1;
};

inline PointCloud<Camera> measure(const ModelHead& head, const RigidTransform<Camera, Mri>& camera_T_mri,
                                  const CameraView& view) {
  std::mt19937 random(view.seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0, 1);
  PointCloud<Camera> cloud;
  while (int(cloud.size()) < view.points) {
    const Eigen::Vector3d direction =
        Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
    Eigen::Vector3d p = head.at(direction);
    const Eigen::Vector3d n = head.normal(direction);
    if (p.z() < view.least_z_mm || p.z() > view.most_z_mm) continue;
    const Eigen::Vector3d ray = (camera_T_mri * Point<Mri>(p)).mm.normalized();
    if (-(camera_T_mri.rotation() * n).dot(ray) < 0.3) continue;
    if (view.has_hair && p.z() > 55) p += (2 + 3 * uniform(random)) * n;
    cloud.points_mm.push_back((camera_T_mri * Point<Mri>(p)).mm + view.noise_mm * normal(random) * ray);
  }
  if (view.has_clothes)
    for (int i = 0; i < view.points / 4; ++i) {
      const double x = 350 * (uniform(random) - 0.5), z = -115 - 120 * uniform(random);
      const Eigen::Vector3d p(x, 40 + 15 * std::sin(x * 0.05) - 0.001 * x * x, z - 0.3 * std::abs(x));
      cloud.points_mm.push_back((camera_T_mri * Point<Mri>(p)).mm +
                                0.4 * Eigen::Vector3d(normal(random), normal(random), normal(random)));
    }
  return cloud;
}

/// Pose of a patient about 600 mm in front of the camera, turned by these angles (deg) from upright and
/// facing it.
inline RigidTransform<Camera, Mri> facing(double yaw, double pitch, double roll,
                                          const Eigen::Vector3d& shift_mm = {0, 0, 0}) {
  Eigen::Matrix3d upright;
  upright << -1, 0, 0, 0, 0, -1, 0, -1, 0;
  const auto turn = [](double deg, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(deg * M_PI / 180, axis).toRotationMatrix();
  };
  const Eigen::Matrix3d r = turn(roll, Eigen::Vector3d::UnitZ()) * turn(yaw, Eigen::Vector3d::UnitY()) *
                            turn(pitch, Eigen::Vector3d::UnitX()) * upright;
  return RigidTransform<Camera, Mri>(Eigen::Quaterniond(r), Eigen::Vector3d(0, 0, 690) + shift_mm);
}

}  // namespace facenav::testing
