#include "pose_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "light_field.h"
#include "patch_looks.h"
#include "patch_placement.h"

namespace facenav::tracking {
namespace {

constexpr float kBiweight = 4.685f;      // 95 % efficiency for normal errors (Huber 1981)
constexpr float kLongestStep_px = 2.5f;  // displacement beyond which a patch's linearisation means nothing
constexpr double kLeastLightChange = 0.02, kUsualLightChange = 0.2;
constexpr double kUnsettled_px = 0.1;  // in the last step: the fit has not arrived
constexpr float kAlikeShare = 0.6f;    // of the correlation expected
constexpr int kFewestAlike = 10;       // patches in view, of both cameras, to say anything
constexpr float kLeastScale = 0.5f;
constexpr int kIterations[kLevels] = {8, 5, 5, 6};
constexpr double kSettled_px[kLevels] = {0.01, 0.03, 0.05, 0.05};  // largest motion of a patch in a step

std::array<float, 12> floatsOf(const Eigen::Isometry3d& pose) {
  std::array<float, 12> m;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) m[3 * r + c] = float(pose.linear()(r, c));
    m[9 + r] = float(pose.translation()(r));
  }
  return m;
}

patch::Image imageOf(const BlurredImage& image) {
  return {image.pixels.ptr<std::uint16_t>(0),
          int(image.pixels.step1()),
          image.origin.x,
          image.origin.y,
          image.pixels.cols,
          image.pixels.rows};
}

// Of one level in both images, at poses near the one it was made for.
class LevelFit {
 public:
  LevelFit(const stereo::StereoRig& rig, const PatchModel& model, const PatchLevel& level,
           const std::array<ImagePyramid, 2>& now, const std::vector<float>& trust)
      : rig_(rig), model_(model), level_(level), trust_(trust), sights_(level.patches.size()) {
    for (int c = 0; c < 2; ++c) images_[c] = imageOf(now[c].level[level.level]);
    noise_share_ = float(patch::kSamples * noiseShare(level.level) * model.noise_grey * model.noise_grey);
  }

  void placeAt(const Eigen::Isometry3d& motion) {
    placed_[0] = place(level_, rig_.left, 0, motion);
    placed_[1] = place(level_, rig_.right, 1, rig_.right_T_left.isometry() * motion);
    is_assessed_ = false;
  }

  void look(const Eigen::Isometry3d& motion) {
    for (auto& sight : sights_) sight = {};
    const Eigen::Isometry3d camera_T_head[2] = {motion, rig_.right_T_left.isometry() * motion};
    for (int c = 0; c < 2; ++c) {
      const auto& placements = placed_[c].placements;
      if (images_[c].width < 2 || images_[c].height < 2) continue;
      sums_[c].resize(placements.size());
      patch::kernel()(images_[c], level_.samples(c), floatsOf(camera_T_head[c]).data(), placements.data(),
                      int(placements.size()), sums_[c].data());
      for (std::size_t k = 0; k < placements.size(); ++k) see(c, k);
    }
    if (!is_assessed_) assess(motion);
    for (int c = 0; c < 2; ++c)
      for (std::size_t k = 0; k < placed_[c].placements.size(); ++k) displace(c, k);
  }

  // The increment xi (Head, about the model's centre) that explains the displacements.
  Vector6d solve(int rounds, bool is_first) {
    collect();
    Vector6d xi = Vector6d::Zero();
    for (int round = 0; round < rounds; ++round) {
      weigh(xi, is_first && round == 0);
      xi = normalSolution();
      if (!xi.allFinite()) return Vector6d::Zero();
    }
    weigh(xi, false);
    return xi;
  }

  void finish(PoseFit& fit) {
    fit.information = information();
    fit.scale = scale_;
    std::vector<Vector6d> pulls(model_.regions, Vector6d::Zero());
    for (const auto& row : rows_) {
      auto& sight = sights_[row.patch][row.camera];
      sight.weight = row.weight, sight.distance = row.distance, sight.residual_px = row.residual_px;
      pulls[level_.patches[row.patch].region] +=
          (row.weight * row.prior * (row.worth->weighted * row.e)).cast<double>();
    }
    for (const auto& pull : pulls) {
      fit.regions += pull.squaredNorm() > 0;
      fit.pull += pull * pull.transpose();
    }
    fit.sights = std::move(sights_);
  }

  double likeness() const {
    int seen = 0, alike = 0;
    for (const auto& sight : sights_)
      for (const auto& one : sight)
        if (one.is_visible && one.expected_ncc > 0.3f)
          ++seen, alike += one.ncc > kAlikeShare * one.expected_ncc;
    return seen < kFewestAlike ? 0.0 : double(alike) / seen;
  }

  // How far the step moves the patches, pixels of the level.
  double motion_px(const Vector6d& xi) const {
    double most = 0;
    for (const auto& patch : level_.patches)
      most = std::max(most, (patch.view[0].jacobian * xi).squaredNorm());
    return std::sqrt(most);
  }

 private:
  // What a patch's displacement tells about the pose: J' L J (upper triangle, row by row) and J' L.
  struct Worth {
    std::array<float, 24> normal{};
    Eigen::Matrix<float, 6, 2> weighted;
    Eigen::Matrix2f information;
  };

  // How unevenly the face's brightness has changed since the key frame: half the middle 68 %.
  double lightChange() const {
    std::vector<float> ratios;
    for (const auto& sight : sights_)
      for (const auto& one : sight)
        if (one.is_visible && one.ncc > 0.5f * one.expected_ncc) ratios.push_back(one.brightness);
    if (ratios.size() < 10) return kUsualLightChange;
    const auto quantile = [&](double share) {
      const auto at = ratios.begin() + std::ptrdiff_t(share * double(ratios.size()));
      std::nth_element(ratios.begin(), at, ratios.end());
      return double(*at);
    };
    const double low = quantile(0.16), middle = quantile(0.5), high = quantile(0.84);
    return std::max(kLeastLightChange, 0.5 * (high - low) / std::max(0.1, middle));
  }

  // The error of a patch's depth shows in its displacement as the view turns away from the key frame's.
  void assess(const Eigen::Isometry3d& motion) {
    const Eigen::Isometry3d left_T_right = rig_.right_T_left.isometry().inverse();
    const Eigen::Vector3d eyes_mm[2] = {motion.inverse().translation(),
                                        motion.inverse() * left_T_right.translation()};
    const double light_change = lightChange();
    worth_.resize(2 * level_.patches.size());
    for (int c = 0; c < 2; ++c)
      for (std::size_t k = 0; k < placed_[c].placements.size(); ++k) {
        const int index = placed_[c].placements[k].patch;
        const Patch& patch = level_.patches[index];
        const PatchView& view = patch.view[c];
        const Eigen::Vector3d ray = (patch.centre_mm - eyes_mm[c]).normalized();
        const double shading = shadingSigma(light_change, patch.normal_spread_rad);
        const Eigen::Vector2d shown_px =
            patch.depth_sigma_mm * view.jacobian.rightCols<3>() * (view.ray - ray);
        // Half of the errors belong to the key frame; the other half grows where the view is foreshortened.
        const Eigen::Matrix2d own = 0.5 * (view.covariance + shading * shading * view.shading);
        const Eigen::Matrix2d& grown = placed_[c].key_from_now[k];
        const Eigen::Matrix2d information =
            (own + grown * own * grown.transpose() + shown_px * shown_px.transpose()).inverse();
        Worth& worth = worth_[2 * index + c];
        worth.information = information.cast<float>();
        worth.weighted = (view.jacobian.transpose() * information).cast<float>();
        const Eigen::Matrix<float, 6, 6> normal = worth.weighted * view.jacobian.cast<float>();
        for (int a = 0, n = 0; a < 6; ++a)
          for (int b = a; b < 6; ++b) worth.normal[n++] = normal(a, b);
      }
    is_assessed_ = true;
  }

  struct Row {
    int patch, camera;
    float prior;  // trust before geometry
    Eigen::Vector2f displacement, e;
    float weight, distance, residual_px;
    const PatchView* view;
    const Worth* worth;
  };

  void see(int camera, std::size_t k) {
    const auto& sums = sums_[camera][k];
    const int index = placed_[camera].placements[k].patch;
    const PatchView& view = level_.patches[index].view[camera];
    PatchSight& sight = sights_[index][camera];
    sight.px = placed_[camera].centres_px[k].cast<float>();
    if (!sums.is_inside) return;
    const float n = float(patch::kSamples), spread = sums.ii - sums.i * sums.i / n;
    sight.is_visible = true;
    sight.brightness = sums.i / (n * view.mean);
    sight.ncc = spread > 1e-3f ? sums.ti / std::sqrt(spread * view.contrast) : 0.f;
    sight.expected_ncc = std::max(0.f, 1.f - noise_share_ / view.contrast);
  }

  void displace(int camera, std::size_t k) {
    const auto& sums = sums_[camera][k];
    const int index = placed_[camera].placements[k].patch;
    const PatchView& view = level_.patches[index].view[camera];
    PatchSight& sight = sights_[index][camera];
    const float gain = sums.ti / view.contrast;
    if (!sight.is_visible || sight.ncc < 0.1f || gain < 0.05f) return;
    Eigen::Vector2f pull(sums.ui, sums.vi);
    if (level_.level == 0) {
      const Eigen::Vector2f slope = lightSlope(model_.neighbours[index], sights_, index, camera);
      pull -= sight.brightness * view.ramp.cast<float>() * slope;
    }
    sight.displacement = view.structure_inverse.cast<float>() * pull / -gain;
  }

  // Trust before geometry: looks as expected, and a displacement within reach.
  static float looksWeight(const PatchSight& sight) {
    if (!sight.is_visible || sight.expected_ncc <= 0.05f) return 0.f;
    const float likeness = std::clamp((sight.ncc / sight.expected_ncc - 0.3f) / 0.5f, 0.f, 1.f);
    return sight.displacement.squaredNorm() < kLongestStep_px * kLongestStep_px ? likeness : 0.1f * likeness;
  }

  void collect() {
    rows_.clear();
    for (std::size_t i = 0; i < sights_.size(); ++i)
      for (int c = 0; c < 2; ++c) {
        const auto& sight = sights_[i][c];
        const float looks = looksWeight(sight);
        if (looks <= 0) continue;
        const auto& patch = level_.patches[i];
        Row row;
        row.patch = int(i), row.camera = c;
        row.prior = looks * float(patch.rigidity) * (trust_.empty() ? 1.f : trust_[i]);
        row.displacement = row.e = sight.displacement;
        row.weight = row.distance = row.residual_px = 0.f;
        row.view = &patch.view[c], row.worth = &worth_[2 * i + c];
        rows_.push_back(row);
      }
  }

  void weigh(const Vector6d& xi, bool is_start) {
    distances_.clear();
    for (auto& row : rows_) {
      row.e = row.displacement - (row.view->jacobian * xi).cast<float>();
      row.residual_px = row.e.norm();
      row.distance = std::sqrt(std::max(0.f, row.e.dot(row.worth->information * row.e)));
      distances_.push_back(row.distance);
    }
    if (distances_.empty()) return;
    const auto middle = distances_.begin() + std::ptrdiff_t(distances_.size() / 2);
    std::nth_element(distances_.begin(), middle, distances_.end());
    scale_ = std::max(kLeastScale, *middle / 1.177f);  // of a 2-D normal error's length
    const float reach = kBiweight * scale_;
    for (auto& row : rows_) {
      const float q2 = row.distance * row.distance / (reach * reach);
      row.weight = is_start ? 1.f / (1.f + 4.f * q2) : (q2 < 1.f ? (1.f - q2) * (1.f - q2) : 0.f);
    }
  }

  Matrix6d information() {
    std::array<float, 24> sum{};
    for (const auto& row : rows_) {
      const float w = row.weight * row.prior;
      for (int k = 0; k < 24; ++k) sum[k] += w * row.worth->normal[k];
    }
    Matrix6d h;
    for (int i = 0, k = 0; i < 6; ++i)
      for (int j = i; j < 6; ++j) h(i, j) = h(j, i) = sum[k++];
    return h;
  }

  Vector6d normalSolution() {
    Matrix6d h = information();
    Eigen::Matrix<float, 6, 1> g = Eigen::Matrix<float, 6, 1>::Zero();
    for (const auto& row : rows_) {
      g.noalias() += row.worth->weighted * (row.weight * row.prior * row.displacement);
    }
    h.diagonal() += 1e-6 * h.diagonal() + Vector6d::Constant(1e-9);
    return h.ldlt().solve(g.cast<double>());
  }

  const stereo::StereoRig& rig_;
  const PatchModel& model_;
  const PatchLevel& level_;
  const std::vector<float>& trust_;
  std::array<patch::Image, 2> images_;
  float noise_share_ = 0.f;
  std::array<Placed, 2> placed_;
  std::array<std::vector<patch::Sums>, 2> sums_;
  PatchSights sights_;
  bool is_assessed_ = false;
  std::vector<Worth> worth_;  // of patch i in camera c: 2 i + c
  std::vector<Row> rows_;
  std::vector<float> distances_;
  float scale_ = 1.f;
};

Eigen::Isometry3d about(const Eigen::Vector3d& centre_mm, const Vector6d& xi) {
  return Eigen::Translation3d(centre_mm) * expRigid(xi) * Eigen::Translation3d(-centre_mm);
}

}  // namespace

PoseFit fitPose(const stereo::StereoRig& rig, const PatchModel& model, const PatchLevel& finest,
                const std::array<ImagePyramid, 2>& now, const Eigen::Isometry3d& start, int first_level,
                const std::vector<float>& trust, int last_level) {
  PoseFit fit;
  fit.motion = start;
  const std::vector<float> even;
  for (int l = first_level; l >= last_level; --l) {
    const PatchLevel& patches = l == 0 ? finest : model.level[l];
    if (patches.patches.size() < 4) continue;
    LevelFit level(rig, model, patches, now, l == 0 ? trust : even);
    double moved_px = std::numeric_limits<double>::max();
    for (int iteration = 0; iteration < kIterations[l]; ++iteration) {
      if (moved_px > 0.5) level.placeAt(fit.motion);
      level.look(fit.motion);
      const Vector6d xi = level.solve(iteration == 0 ? 3 : 2, iteration == 0);
      fit.motion = fit.motion * about(model.centre_mm, xi);
      moved_px = level.motion_px(xi);
      if (moved_px < kSettled_px[l]) break;
    }
    if (l == last_level) fit.likeness = level.likeness();
    if (l > 0) continue;
    fit.is_settled = moved_px < kUnsettled_px;
    level.finish(fit);
  }
  return fit;
}

}  // namespace facenav::tracking
