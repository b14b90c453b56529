#include "pose_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "facenav/core/robust_statistics.h"
#include "facenav/geometry/normal_equations.h"
#include "level_measurement.h"
#include "patch_observation.h"

namespace facenav::head_tracking {
namespace {

constexpr double kLinear_px = 2.5;     // motion over which the linearisation at a patch is valid
constexpr double kUnsettled_px = 0.1;  // motion in the last step above which the fit has not converged
constexpr float kLeastScale = 0.5f;
// Factor on errors common to both cameras, which neighbouring patches share (one light, one shape).
constexpr float kSharedError = 1.6f;
constexpr float kPairRatio = 0.4f;                  // above it both cameras see the patch about equally well
constexpr int kIterations[kLevels] = {0, 5, 5, 6};  // finest level: set by the caller
constexpr double kSettled_px[kLevels] = {0.02, 0.03, 0.05, 0.05};  // largest motion of a patch in a step

// The fit of one level in both images, near the pose it was made for.
class LevelFit {
 public:
  LevelFit(const cameras::StereoRig& rig, const PatchModel& model, const PatchLevel& level,
           const std::array<ImagePyramid, 2>& now, const std::vector<float>& patch_weights)
      : rig_(rig),
        model_(model),
        level_(level),
        patch_weights_(patch_weights),
        seen_(rig, model, level, now) {}

  void placeAt(const Eigen::Isometry3d& motion) {
    seen_.placeAt(motion);
    is_assessed_ = false;
  }

  int placements() const {
    return int(seen_.placed()[0].placements.size() + seen_.placed()[1].placements.size());
  }

  void measure(const Eigen::Isometry3d& motion) {
    seen_.measure(motion);
    if (!is_assessed_) assess(motion);
  }

  double likeness() const { return seen_.likeness(); }

  // Solves for the increment xi (Head, about the model's centre) that explains the displacements.
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

  void finish(PoseFit& fit, const Vector6d& last_step) {
    seen_.markCentres(fit.motion);
    PatchMeasurements& all = seen_.measurements();
    fit.scale = std::max(scale_[0], scale_[1]);
    for (float& scale : scale_) scale = std::max(1.f, scale);  // at least the known errors
    fit.information = information();
    const Eigen::Matrix<float, 6, 1> step = last_step.cast<float>();
    std::vector<Vector6d> pulls(model_.regions, Vector6d::Zero());
    for (auto& measurements : all)
      for (auto& measurement : measurements) measurement.weight = measurement.is_visible ? 1.f : 0.f;
    std::vector<std::array<bool, 2>> is_observed(all.size());
    for (const auto& row : rows_) {
      for (int c = 0; c < 2; ++c) {
        if ((c == 0 && row.observed == ObservationKind::by_right) ||
            (c == 1 && row.observed == ObservationKind::by_left))
          continue;
        auto& measurement = all[row.patch][c];
        is_observed[row.patch][c] = row.prior > 0;
        measurement.weight = std::min(measurement.weight, row.weight);
        measurement.distance = std::max(measurement.distance, row.distance);
        measurement.residual_px =
            (measurement.displacement - level_.patches[row.patch].view[c].jacobian.cast<float>() * step)
                .norm();
      }
      pulls[level_.patches[row.patch].region] +=
          (weightOf(row) * (observations_[row.observation].weighted * row.e)).cast<double>();
    }
    fit.sides = sides();
    for (std::size_t i = 0; i < all.size(); ++i)
      for (int c = 0; c < 2; ++c)
        if (!is_observed[i][c]) all[i][c].weight = 0.f;
    for (const auto& pull : pulls) {
      fit.regions += pull.squaredNorm() > 0;
      fit.pull += pull * pull.transpose();
    }
    fit.measurements = std::move(all);
  }

  // Largest motion of a patch by the step, pixels of the level.
  double motion_px(const Vector6d& xi) const {
    double most = 0;
    for (const auto& patch : level_.patches)
      most = std::max(most, (patch.view[0].jacobian * xi).squaredNorm());
    return std::sqrt(most);
  }

 private:
  // One PatchObservation: J, J' L J (upper triangle, row by row) and J' L.
  struct WeightedObservation {
    Eigen::Matrix<float, 2, 4> combine;
    Eigen::Matrix<float, 2, 6> jacobian;
    std::array<float, 24> normal{};
    Eigen::Matrix<float, 6, 2> weighted;
    Eigen::Matrix2f information;

    explicit WeightedObservation(const PatchObservation& observed)
        : combine(observed.combine.cast<float>()), jacobian(observed.jacobian.cast<float>()) {
      const Eigen::Matrix2d inverse = observed.covariance.inverse();
      information = inverse.cast<float>();
      weighted = (observed.jacobian.transpose() * inverse).cast<float>();
      const Eigen::Matrix<float, 6, 6> product = weighted * jacobian;
      for (int i = 0, n = 0; i < 6; ++i)
        for (int j = i; j < 6; ++j) normal[n++] = product(i, j);
    }
  };

  // The observations of each patch at this pose; of both cameras together when the patch looks as expected in
  // both.
  void assess(const Eigen::Isometry3d& motion) {
    const Eigen::Isometry3d left_T_right = rig_.right_T_left.isometry().inverse();
    const Eigen::Vector3d eyes_mm[2] = {motion.inverse().translation(),
                                        motion.inverse() * left_T_right.translation()};
    std::vector<PatchChange> changes(level_.patches.size());
    const double light_change = seen_.lightChange();
    const auto& placed = seen_.placed();
    for (int c = 0; c < 2; ++c)
      for (std::size_t k = 0; k < placed[c].placements.size(); ++k) {
        const int index = placed[c].placements[k].patch;
        changes[index].key_from_now[c] = placed[c].key_from_now[k];
        changes[index].ray[c] = (level_.patches[index].centre_mm - eyes_mm[c]).normalized();
        changes[index].light_change = light_change;
      }
    observations_.clear(), observations_.reserve(2 * level_.patches.size());
    rows_.clear(), rows_.reserve(2 * level_.patches.size());
    for (std::size_t i = 0; i < level_.patches.size(); ++i) {
      const Patch& patch = level_.patches[i];
      const float appearance[2] = {appearanceWeight(seen_.measurements()[i][0]),
                                   appearanceWeight(seen_.measurements()[i][1])};
      const bool is_pair =
          std::min(appearance[0], appearance[1]) > kPairRatio * std::max(appearance[0], appearance[1]) &&
          canBePaired(patch);
      if (is_pair) {
        const auto observed = observedByBoth(patch, changes[i]);
        addRow(i, ObservationKind::mean, observed[0]);
        addRow(i, ObservationKind::difference, observed[1]);
      } else if (std::max(appearance[0], appearance[1]) > 0) {
        for (int c = 0; c < 2; ++c)
          if (appearance[c] > 0)
            addRow(i, c == 0 ? ObservationKind::by_left : ObservationKind::by_right,
                   observedByOne(patch, c, changes[i]));
      }
    }
    is_assessed_ = true;
  }

  enum class ObservationKind { by_left, by_right, mean, difference };

  void addRow(std::size_t patch, ObservationKind observed, const PatchObservation& observation) {
    Row row;
    row.patch = int(patch), row.observed = observed, row.observation = int(observations_.size());
    observations_.emplace_back(observation);
    rows_.push_back(row);
  }

  struct Row {
    int patch = 0;
    ObservationKind observed = ObservationKind::mean;
    int observation = 0;
    float prior = 0.f;  // weight before geometry
    Eigen::Vector2f displacement = Eigen::Vector2f::Zero(), e = Eigen::Vector2f::Zero();
    float weight = 0.f, distance = 0.f;
    /// Errors of differences and of all others have separate scales.
    int kind() const { return observed == ObservationKind::difference ? 1 : 0; }
  };

  // Weight before geometry: the patch looks as expected and its displacement is within reach.
  static float appearanceWeight(const PatchMeasurement& measurement) {
    if (!measurement.is_visible || measurement.expected_ncc <= 0.05f) return 0.f;
    const float likeness = std::clamp((measurement.ncc / measurement.expected_ncc - 0.3f) / 0.5f, 0.f, 1.f);
    return measurement.displacement.squaredNorm() < kLinear_px * kLinear_px ? likeness : 0.1f * likeness;
  }

  // Updates the displacements. A row gets weight 0 when its patch no longer looks as expected.
  void collect() {
    for (auto& row : rows_) {
      const auto& measurements = seen_.measurements()[row.patch];
      float appearance = 0.f;
      switch (row.observed) {
        case ObservationKind::by_left:
          appearance = appearanceWeight(measurements[0]);
          break;
        case ObservationKind::by_right:
          appearance = appearanceWeight(measurements[1]);
          break;
        default:
          appearance = std::min(appearanceWeight(measurements[0]), appearanceWeight(measurements[1]));
      }
      row.prior = appearance * float(level_.patches[row.patch].rigidity) *
                  (patch_weights_.empty() ? 1.f : patch_weights_[row.patch]);
      Eigen::Vector4f both;
      both << measurements[0].displacement, measurements[1].displacement;
      row.displacement = row.e = observations_[row.observation].combine * both;
    }
  }

  void weigh(const Vector6d& xi, bool is_start) {
    for (auto& list : distances_) list.clear();
    const Eigen::Matrix<float, 6, 1> step = xi.cast<float>();
    for (auto& row : rows_) {
      const WeightedObservation& observation = observations_[row.observation];
      row.e = row.displacement - observation.jacobian * step;
      row.distance = std::sqrt(std::max(0.f, row.e.dot(observation.information * row.e)));
      if (row.prior > 0) distances_[row.kind()].push_back(row.distance);
    }
    for (int kind = 0; kind < 2; ++kind) {
      auto& list = distances_[kind];
      if (list.empty()) continue;
      const auto middle = list.begin() + std::ptrdiff_t(list.size() / 2);
      std::nth_element(list.begin(), middle, list.end());
      scale_[kind] = std::max(kLeastScale, *middle / float(kMedianLength));
    }
    for (auto& row : rows_) {
      const float reach = float(kTukeyReach) * scale_[row.kind()];
      const float q2 = row.distance * row.distance / (reach * reach);
      row.weight = is_start ? 1.f / (1.f + 4.f * q2) : (q2 < 1.f ? (1.f - q2) * (1.f - q2) : 0.f);
    }
  }

  // Total weight of a row in the fit: robust weight, prior weight, and scale of its kind's errors.
  float weightOf(const Row& row) const {
    const float scale = scale_[row.kind()] * (row.kind() == 0 ? kSharedError : 1.f);
    return row.weight * row.prior / (scale * scale);
  }

  Matrix6d information() const {
    std::array<float, 24> sum{};
    for (const auto& row : rows_) {
      const float w = weightOf(row);
      for (int k = 0; k < 24; ++k) sum[k] += w * observations_[row.observation].normal[k];
    }
    Matrix6d h;
    for (int i = 0, k = 0; i < 6; ++i)
      for (int j = i; j < 6; ++j) h(i, j) = h(j, i) = sum[k++];
    return h;
  }

  std::optional<SidesFit> sides() const {
    StereoConsistency evidence(model_.regions);
    for (const auto& row : rows_) {
      const float w = weightOf(row);
      if (!(w > 0.f)) continue;
      const auto& observation = observations_[std::size_t(row.observation)];
      const Patch& patch = level_.patches[std::size_t(row.patch)];
      evidence.add(patch.region, observation.jacobian,
                   observation.combine.rightCols<2>() * patch.view[1].jacobian.cast<float>(), row.e,
                   w * observation.information);
    }
    return evidence.solve();
  }

  Vector6d normalSolution() const {
    Matrix6d h = information();
    Eigen::Matrix<float, 6, 1> g = Eigen::Matrix<float, 6, 1>::Zero();
    for (const auto& row : rows_)
      g.noalias() += observations_[row.observation].weighted * (weightOf(row) * row.displacement);
    h.diagonal() += 1e-6 * h.diagonal() + Vector6d::Constant(1e-9);
    return solveSymmetric(h, g.cast<double>());
  }

  const cameras::StereoRig& rig_;
  const PatchModel& model_;
  const PatchLevel& level_;
  const std::vector<float>& patch_weights_;
  LevelMeasurement seen_;
  bool is_assessed_ = false;
  std::vector<WeightedObservation> observations_;
  std::vector<Row> rows_;
  std::array<std::vector<float>, 2> distances_;  // by kind of row
  std::array<float, 2> scale_ = {1.f, 1.f};
};

Eigen::Isometry3d about(const Eigen::Vector3d& centre_mm, const Vector6d& xi) {
  return Eigen::Translation3d(centre_mm) * expRigid(xi) * Eigen::Translation3d(-centre_mm);
}

}  // namespace

PoseFit fitPose(const cameras::StereoRig& rig, const PatchModel& model, const PatchLevels& levels,
                const std::array<ImagePyramid, 2>& now, const Eigen::Isometry3d& start, int first_level,
                const std::vector<float>& patch_weights, int last_level, int most_steps) {
  PoseFit fit;
  fit.motion = start;
  const std::vector<float> even;
  for (int l = first_level; l >= last_level; --l) {
    const PatchLevel& patches = levels[l];
    if (patches.patches.size() < kFewestPatches) continue;
    LevelFit level(rig, model, patches, now, l == 0 ? patch_weights : even);
    double moved_px = std::numeric_limits<double>::max(), since_placed_px = 0;
    Vector6d xi = Vector6d::Zero();
    for (int iteration = 0; iteration < (l == 0 ? most_steps : kIterations[l]); ++iteration) {
      if (iteration == 0 || since_placed_px > kLinear_px) level.placeAt(fit.motion), since_placed_px = 0;
      level.measure(fit.motion);
      fit.comparisons += level.placements();
      xi = level.solve(iteration == 0 ? 3 : 2, iteration == 0);
      fit.motion = fit.motion * about(model.centre_mm, xi);
      moved_px = level.motion_px(xi);
      since_placed_px += moved_px;
      if (moved_px < kSettled_px[l]) break;
      // The likeness hardly changes over the steps. A patient's face converges in two, others take many: the
      // rest of the frame's work is for the search.
      if (l == 0 && iteration > 1 && moved_px > kUnsettled_px && level.likeness() < kLikely) break;
    }
    if (l == last_level) fit.likeness = level.likeness();
    if (l > 0) continue;
    fit.is_settled = moved_px < kUnsettled_px;
    level.finish(fit, xi);
  }
  return fit;
}

}  // namespace facenav::head_tracking
