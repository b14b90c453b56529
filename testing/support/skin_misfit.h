#pragma once
// Differences between the live skin and the MRI's, generated from seeds: smooth fields, a skin that is too
// deep, moved cheeks and jaw, dents on the forehead, scan distortion. Also the stereo measurement of such a
// skin: noise along the ray that is correlated between neighbours, hair, a hand or coil in front, clothes.
// Used to test whether predicted errors are correct.

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "facenav/geometry/rigid_transform.h"
#include "facenav/registration/skin_model.h"

namespace facenav::testing {

/// A smooth random function of a point with zero mean, unit variance and Gaussian correlation of `reach_mm`
/// (random Fourier features).
class RandomField {
 public:
  RandomField(std::mt19937& random, double reach_mm) {
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> phase(0, 2 * M_PI);
    for (int f = 0; f < 40; ++f) {
      waves_.emplace_back(normal(random) / reach_mm, normal(random) / reach_mm, normal(random) / reach_mm);
      phases_.push_back(phase(random));
    }
  }
  double at(const Eigen::Vector3d& p) const {
    double sum = 0;
    for (std::size_t f = 0; f < waves_.size(); ++f) sum += std::cos(waves_[f].dot(p) + phases_[f]);
    return sum * std::sqrt(2.0 / double(waves_.size()));
  }

 private:
  std::vector<Eigen::Vector3d> waves_;
  std::vector<double> phases_;
};

enum class Misfit { none, smooth, deep, cheeks, dents, distortion, mixed };
inline const std::vector<std::pair<Misfit, std::string>>& misfits() {
  static const std::vector<std::pair<Misfit, std::string>> all = {
      {Misfit::none, "none (noise only)"},
      {Misfit::smooth, "smooth field 0.2-0.7 mm"},
      {Misfit::deep, "skin 0.4-0.7 mm too deep"},
      {Misfit::cheeks, "cheeks and jaw moved 1-3 mm"},
      {Misfit::dents, "dents on the forehead, 1-3 mm"},
      {Misfit::distortion, "scan scaled 0.2-0.6 %, bent"},
      {Misfit::mixed, "all of these, halved"}};
  return all;
}

/// Makes the live skin: `scanned` displaced. `nose_tip_mm`: Mri. The triangles and normals stay the same.
inline registration::SkinModel liveSkin(const registration::SkinModel& scanned,
                                        const Eigen::Vector3d& nose_tip_mm, Misfit kind, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const double share = kind == Misfit::mixed ? 0.5 : 1.0;
  const auto has = [&](Misfit m) { return kind == m || kind == Misfit::mixed; };
  const double smooth_mm = has(Misfit::smooth) ? share * uniform(0.2, 0.7) : 0.0;
  const RandomField smooth(random, uniform(10, 50)), wide(random, 60);
  const double deep_mm = has(Misfit::deep) ? share * uniform(0.4, 0.7) : 0.0;
  const double jaw_mm = has(Misfit::cheeks) ? share * uniform(0, 3) : 0.0;
  const double left_mm = has(Misfit::cheeks) ? share * uniform(-3, 3) : 0.0,
               right_mm = has(Misfit::cheeks) ? share * uniform(-3, 3) : 0.0;
  std::vector<std::pair<Eigen::Vector3d, std::pair<double, double>>> dents;
  if (has(Misfit::dents))
    for (int d = 0; d < 5; ++d)
      dents.push_back({nose_tip_mm + Eigen::Vector3d(uniform(-50, 50), -15, uniform(50, 95)),
                       {share * uniform(1, 3) * (uniform(0, 1) < 0.7 ? -1 : 1), uniform(8, 20)}});
  Eigen::Vector3d scale = Eigen::Vector3d::Zero(), bend = Eigen::Vector3d::Zero();
  if (has(Misfit::distortion))
    for (int a = 0; a < 3; ++a)
      scale[a] = share * uniform(0.002, 0.006) * (uniform(0, 1) < 0.5 ? -1 : 1),
      bend[a] = share * 1.5e-5 * normal(random);
  // The head's centre does not move: the effect of a scan's distortion on the target itself is not tested
  // here.
  const Eigen::Vector3d middle = nose_tip_mm + Eigen::Vector3d(0, -100, 40);
  registration::SkinModel live = scanned;
  for (std::size_t v = 0; v < live.points.size(); ++v) {
    const Eigen::Vector3d p = scanned.points.points_mm[v], d = p - nose_tip_mm, m = p - middle;
    if (d.y() < -120) continue;  // not visible to the cameras
    double out = smooth_mm * smooth.at(p) - deep_mm * (1 + 0.4 * wide.at(p));
    const double low = 1 / (1 + std::exp((d.z() + 25) / 6));
    out += 0.5 * jaw_mm * low * std::exp(-d.x() * d.x() / 5000);
    const double cheek = std::exp(-std::pow((std::abs(d.x()) - 45) / 18, 2) - std::pow((d.z() + 30) / 22, 2));
    out += cheek * (d.x() > 0 ? right_mm : left_mm);
    for (const auto& [at, dent] : dents)
      out += dent.first * std::exp(-((p - at).cwiseProduct(Eigen::Vector3d(1, 0.2, 1))).squaredNorm() /
                                   (2 * dent.second * dent.second));
    live.points.points_mm[v] += out * scanned.points.normals[v];
    live.points.points_mm[v] += scale.cwiseProduct(m) + bend.cwiseProduct(m.cwiseProduct(m.cwiseAbs()));
    live.points.points_mm[v].z() -= jaw_mm * low;
  }
  return live;
}

struct StereoView {
  int points = 20000;
  double noise_mm = 0.15, shared_noise_mm = 0.1;  // of single points; common to patches of 3 mm
  double hairline_mm = 85;                        // above the nose tip; 1e9: bald
  double hair_mm = 3.5;
  bool has_hand = false;  // over one side of the face, 15-40 mm in front of it
  bool has_mask = false;  // cloth from the bridge of the nose to the chin, taut over nose and chin
  double reach_mm = 135;  // of the measured region around the nose bridge
  std::uint32_t seed = 1;
};

/// Returns true under the cloth of a face mask. `d`: from the nose tip, mm.
inline bool isMasked(const Eigen::Vector3d& d) {
  return std::abs(d.x()) < 60 && d.z() < 14 - 0.3 * std::abs(d.x());
}

/// Position of the cloth, mm forward of the nose tip: 2 mm off the skin; it spans hollows along a bulge from
/// nose to chin.
inline double clothForward_mm(const Eigen::Vector3d& d) {
  const double bulge = -8.0 - d.x() * d.x() / 55 - std::pow(d.z() + 8, 2) / 140;
  return d.y() + 1.6 + std::clamp(bulge - d.y(), 0.0, 3.0);
}

/// Measures `live` by cameras at Camera's origin and 120 mm beside it.
inline PointCloud<Camera> measureSkin(const registration::SkinModel& live, const Eigen::Vector3d& nose_tip_mm,
                                      const RigidTransform<Camera, Mri>& camera_T_mri,
                                      const StereoView& view) {
  std::mt19937 random(view.seed * 7919u + 17u);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0, 1);
  const RandomField shared(random, 3.0), hair(random, 5.0), locks(random, 14.0);
  const Eigen::Vector3d eye = camera_T_mri.isometry().inverse().translation();
  const Eigen::Vector3d second = camera_T_mri.isometry().inverse() * Eigen::Vector3d(120, 0, 0);
  const Eigen::Vector3d centre = nose_tip_mm + Eigen::Vector3d(0, -15, 30);
  const double hand_side = uniform(random) < 0.5 ? -1 : 1;
  std::vector<std::size_t> seen;
  std::vector<double> area;
  double total = 0;
  for (std::size_t t = 0; t < live.triangles.size(); ++t) {
    const auto& corner = live.triangles[t];
    const Eigen::Vector3d &a = live.points.points_mm[corner[0]], &b = live.points.points_mm[corner[1]],
                          &c = live.points.points_mm[corner[2]];
    if ((a - centre).norm() > view.reach_mm) continue;
    const Eigen::Vector3d facet = (b - a).cross(c - a);
    const double size = facet.norm();
    if (size <= 0 || facet.dot((eye - a).normalized()) < 0.3 * size ||
        facet.dot((second - a).normalized()) < 0.3 * size)
      continue;
    seen.push_back(t);
    area.push_back(total += size * facet.dot((eye - a).normalized()) / size);
  }
  PointCloud<Camera> cloud;
  if (seen.empty()) return cloud;
  while (int(cloud.size()) < view.points) {
    const double pick = uniform(random) * total;
    const auto& corner =
        live.triangles[seen[std::size_t(std::lower_bound(area.begin(), area.end(), pick) - area.begin())]];
    double u = uniform(random), v = uniform(random);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const Eigen::Vector3d &a = live.points.points_mm[corner[0]], &b = live.points.points_mm[corner[1]],
                          &c = live.points.points_mm[corner[2]];
    Eigen::Vector3d p = a + u * (b - a) + v * (c - a);
    const Eigen::Vector3d outward = live.points.normals[corner[0]];
    // The hairline is lower at the sides.
    const Eigen::Vector3d d = p - nose_tip_mm;
    const double above = d.z() - view.hairline_mm + 0.006 * d.x() * d.x();
    if (above > 0)
      p += std::min(1.0, above / 8) * view.hair_mm * std::max(0.3, 1 + 0.3 * hair.at(p) + 0.3 * locks.at(p)) *
           outward;
    if (view.has_hand && hand_side * d.x() > 10 && d.z() < 40)
      p += (15 + 25 * locks.at(p) * locks.at(p)) * (eye - p).normalized();
    if (view.has_mask && isMasked(d)) p.y() = nose_tip_mm.y() + clothForward_mm(d);
    const Eigen::Vector3d ray = (p - eye).normalized();
    p += (view.noise_mm * normal(random) + view.shared_noise_mm * shared.at(p)) * ray;
    cloud.points_mm.push_back(camera_T_mri.isometry() * p);
  }
  return cloud;
}

}  // namespace facenav::testing
