#include "patch_model.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "facenav/geometry/normal_equations.h"
#include "patch_appearance.h"
#include "patch_observation.h"

namespace facenav::head_tracking {
namespace {

using patch::kSide;

struct LevelPlan {
  int cell_px;       // at most one patch per cell, pixels of the level
  std::size_t most;  // number of patches
};
constexpr LevelPlan kPlan[kLevels] = {{8, 240}, {7, 110}, {5, 60}, {4, 30}};
constexpr double kUsualTurn_rad = 0.25;  // turn of the head for which patches are chosen
constexpr double kFlatShading =
    0.02;  // shading left in a patch of flat skin, relative to the change of light
constexpr double kLightReach_px = 34.0;  // distance over which light changes evenly
constexpr std::size_t kMostNeighbours = 20;

struct Candidate {
  Eigen::Vector2d px;  // in pixels of the level
  double rigidity = 1.0;
  PatchPoints points;
  std::array<PatchAppearance, 2> appearance_now;
};

// Candidate centres (pixels of the level, between four of them): the place with most texture in each cell.
std::vector<Eigen::Vector2d> centres(const cv::Mat1f& image, const FaceRegion& region, int cell_px,
                                     int level) {
  cv::Mat1f dx, dy, energy;
  cv::Sobel(image, dx, CV_32F, 1, 0, 3, 0.125);
  cv::Sobel(image, dy, CV_32F, 0, 1, 3, 0.125);
  energy = dx.mul(dx) + dy.mul(dy);
  cv::boxFilter(energy, energy, CV_32F, {kSide, kSide}, {kSide / 2 - 1, kSide / 2 - 1}, false);
  std::vector<Eigen::Vector2d> found;
  const double scale = 1 << level;
  const cv::Rect box(int(region.box().x / scale), int(region.box().y / scale),
                     int(region.box().width / scale) + 1, int(region.box().height / scale) + 1);
  for (int y0 = box.y; y0 < box.br().y; y0 += cell_px)
    for (int x0 = box.x; x0 < box.br().x; x0 += cell_px) {
      float best = 0;
      Eigen::Vector2d at(0, 0);
      for (int y = y0; y < std::min(y0 + cell_px, image.rows); ++y)
        for (int x = x0; x < std::min(x0 + cell_px, image.cols); ++x)
          if (energy(y, x) > best && region.contains(scale * Eigen::Vector2d(x + 0.5, y + 0.5)))
            best = energy(y, x), at = Eigen::Vector2d(x + 0.5, y + 0.5);
      if (best > 0) found.push_back(at);
    }
  return found;
}

std::vector<Candidate> candidates(const cameras::StereoRig& rig, const std::array<ImagePyramid, 2>& key,
                                  const FaceRegion& region, const FaceSurface& surface, int level,
                                  double noise_grey) {
  std::vector<Candidate> all;
  for (const auto& px : centres(greyOf(key[0].level[level]), region, kPlan[level].cell_px, level)) {
    auto points = pointsOf(rig, surface, px, level);
    if (!points) continue;
    Candidate candidate{px, region.rigidity((1 << level) * px), std::move(*points), {}};
    candidate.appearance_now[0] = appearanceOf(rig.left, Eigen::Isometry3d::Identity(), key[0].level[level],
                                               candidate.points, level, noise_grey);
    candidate.appearance_now[1] = appearanceOf(rig.right, rig.right_T_left.isometry(), key[1].level[level],
                                               candidate.points, level, noise_grey);
    if (candidate.appearance_now[0].view.is_usable || candidate.appearance_now[1].view.is_usable)
      all.push_back(std::move(candidate));
  }
  return all;
}

Patch patchOf(const Candidate& candidate) {
  Patch patch;
  patch.centre_mm = candidate.points.centre_mm;
  patch.normal = candidate.points.normal;
  patch.rigidity = candidate.rigidity;
  patch.right_mm = candidate.points.right_mm, patch.down_mm = candidate.points.down_mm;
  patch.depth_sigma_mm = candidate.points.depth_sigma_mm;
  patch.normal_spread_rad = candidate.points.normal_spread_rad;
  patch.view = {candidate.appearance_now[0].view, candidate.appearance_now[1].view};
  return patch;
}

// Information of the patch after a usual turn of the head, when errors of depth and shading have an effect.
std::vector<PatchObservation> usualObservations(const Patch& patch) {
  PatchChange usual;
  for (int c = 0; c < 2; ++c) {
    const Eigen::Vector3d& ray = patch.view[c].ray;
    usual.key_from_now[c].setIdentity();
    usual.ray[c] = (ray + kUsualTurn_rad * Eigen::Vector3d(M_SQRT1_2, M_SQRT1_2, 0)).normalized();
  }
  usual.light_change = kUsualTurn_rad;
  if (canBePaired(patch)) {
    const auto both = observedByBoth(patch, usual);
    return {both.begin(), both.end()};
  }
  std::vector<PatchObservation> observations;
  for (int c = 0; c < 2; ++c)
    if (patch.view[c].is_usable) observations.push_back(observedByOne(patch, c, usual));
  return observations;
}

// Square root of a patch's information, four rows.
Eigen::Matrix<double, 4, 6> rootOfInformation(const Patch& patch) {
  Eigen::Matrix<double, 4, 6> root = Eigen::Matrix<double, 4, 6>::Zero();
  int row = 0;
  for (const auto& observation : usualObservations(patch)) {
    const Eigen::Matrix2d information = observation.covariance.inverse();
    root.middleRows<2>(row) =
        std::sqrt(patch.rigidity) * Eigen::Matrix2d(information.llt().matrixU()) * observation.jacobian;
    row += 2;
  }
  return root;
}

// Greedy D-optimal design: the patches that add most to the information about the pose beside those already
// chosen, by the gain in its log det.
std::vector<std::size_t> mostInformative(const std::vector<Candidate>& all, std::size_t most) {
  Matrix6d information = Matrix6d::Identity() * 1e-3;
  std::vector<Eigen::Matrix<double, 4, 6>> roots;
  for (const auto& candidate : all) roots.push_back(rootOfInformation(patchOf(candidate)));
  std::vector<bool> is_taken(all.size(), false);
  std::vector<std::size_t> chosen;
  std::vector<double> gain(all.size(), std::numeric_limits<double>::max());
  while (chosen.size() < std::min(most, all.size())) {
    const Matrix6d covariance = inverseOf(information);
    std::size_t best = all.size();
    for (std::size_t i = 0; i < all.size(); ++i) {
      // Gains only decrease as patches are added (submodular), so patches whose old gain is below the best
      // are skipped.
      if (is_taken[i] || (best < all.size() && gain[i] <= gain[best])) continue;
      const Eigen::Matrix4d more = Eigen::Matrix4d::Identity() + roots[i] * covariance * roots[i].transpose();
      gain[i] = more.determinant();
      if (best == all.size() || gain[i] > gain[best]) best = i;
    }
    is_taken[best] = true;
    chosen.push_back(best);
    information += roots[best].transpose() * roots[best];
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

void append(PatchLevel& model, const Candidate& candidate, int region) {
  Patch patch = patchOf(candidate);
  patch.region = region;
  for (const auto& p : candidate.points.points_mm) {
    model.x.push_back(float(p.x()));
    model.y.push_back(float(p.y()));
    model.z.push_back(float(p.z()));
  }
  const std::vector<float> none(patch::kSamples, 0.f);
  for (int c = 0; c < 2; ++c) {
    const auto& appearance_now = candidate.appearance_now[c];
    const auto add = [&](std::vector<float>& to, const std::vector<float>& from) {
      const auto& source = appearance_now.view.is_usable ? from : none;
      to.insert(to.end(), source.begin(), source.end());
    };
    add(model.appearance[c].grey, appearance_now.grey);
    add(model.appearance[c].d_u, appearance_now.d_u);
    add(model.appearance[c].d_v, appearance_now.d_v);
  }
  model.patches.push_back(patch);
}

Eigen::Vector3d meanOf(const std::vector<Candidate>& all) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& candidate : all) mean += candidate.points.centre_mm / double(all.size());
  return mean;
}

std::vector<std::vector<Neighbour>> neighboursOf(const PatchLevel& level) {
  std::vector<std::vector<Neighbour>> all;
  for (const auto& patch : level.patches) {
    std::vector<Neighbour> near;
    for (std::size_t i = 0; i < level.patches.size(); ++i) {
      const Eigen::Vector2d d = level.patches[i].view[0].px - patch.view[0].px;
      if (d.norm() < kLightReach_px) near.push_back({int(i), float(d.x()), float(d.y())});
    }
    const auto distance = [](const Neighbour& n) { return std::hypot(n.right_px, n.down_px); };
    std::stable_sort(near.begin(), near.end(),
                     [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
    if (near.size() > kMostNeighbours) near.resize(kMostNeighbours);
    all.push_back(std::move(near));
  }
  return all;
}

}  // namespace

double shadingSigma(double light_change, double normal_spread_rad) {
  return light_change * (normal_spread_rad + kFlatShading);
}

patch::Samples PatchLevel::samples(int camera) const {
  const auto& l = appearance[camera];
  return {x.data(), y.data(), z.data(), l.grey.data(), l.d_u.data(), l.d_v.data()};
}

PatchModel learnPatches(const cameras::StereoRig& rig, const cameras::StereoFrame& key_frame,
                        const std::array<ImagePyramid, 2>& key, const FaceRegion& region,
                        const FaceSurface& surface) {
  PatchModel model;
  model.noise_grey = std::max(noiseOf(key_frame.left), noiseOf(key_frame.right));
  model.regions = FaceRegion::kPartColumns * FaceRegion::kPartRows;
  for (int l = 0; l < kLevels; ++l) {
    model.level[l].level = l;
    const double noise_grey = noiseBeforeBlur(model.noise_grey, l);
    auto all = candidates(rig, key, region, surface, l, noise_grey);
    if (all.empty()) continue;
    if (l == 0) model.centre_mm = meanOf(all);
    for (auto& candidate : all) {
      const auto& at_mm = candidate.points.centre_mm;
      addJacobian(rig.left, Eigen::Isometry3d::Identity(), at_mm, model.centre_mm, l,
                  candidate.appearance_now[0].view);
      addJacobian(rig.right, rig.right_T_left.isometry(), at_mm, model.centre_mm, l,
                  candidate.appearance_now[1].view);
    }
    for (std::size_t i : mostInformative(all, kPlan[l].most))
      append(model.level[l], all[i], region.partAt((1 << l) * all[i].px));
  }
  model.neighbours = neighboursOf(model.level[0]);
  return model;
}

}  // namespace facenav::head_tracking
