#include "misfit_model.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "facenav/core/settings_in_force.h"

namespace facenav::registration {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A hypothesis about the smooth field: its size, its reach, and the factor over soft tissue.
struct FieldShape {
  double size_mm, reach_mm, soft;
};

/// A hypothesis about the sizes of the whole skin's offset and of the scan's scale error.
struct ModeSizes {
  double offset_mm, scale, log_weight;
};

/// The patches as one linear model: residual = misfit + design * error. Columns: six of the pose, the offset,
/// the scale along each axis (modes of the misfit), the residual itself, and a turn of the right camera (zero
/// if it is not estimated).
struct LinearModel {
  static constexpr int kPose = 6, kOffset = 6, kScale = 7, kResidual = 10, kTurn = 11, kColumns = 12;
  Eigen::Matrix<double, Eigen::Dynamic, kColumns> columns;
  VectorXd noise2, softness;
  MatrixXd distance_mm;
};

/// Rotations are multiplied by this lever, so that all six columns have similar size.
constexpr double kLever_mm = 100.0;
constexpr double kTurn_rad = 0.1 * kRadPerDeg;  // one unit of the turn's column
// Number of patches and of shapes in the estimate of the field. Fewer patches determine the shape too poorly.
constexpr std::size_t kShapePatches = 150, kMostShapes = 6;

LinearModel linearModel(const std::vector<SkinPatch>& patches, const anatomy::FaceRegions& regions,
                        const Eigen::Vector3d& pivot, const SeenFrom& seen = {}) {
  const auto n = Eigen::Index(patches.size());
  LinearModel model{{n, LinearModel::kColumns}, VectorXd(n), VectorXd(n), MatrixXd(n, n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const SkinPatch& patch = patches[std::size_t(i)];
    model.noise2[i] = patch.noise_mm * patch.noise_mm;
    model.softness[i] = regions.softness(patch.at_mri_mm);
    const Eigen::Vector3d stretch_mm = patch.normal.cwiseProduct(patch.at_mri_mm - pivot);
    model.columns.row(i) << patch.jacobian.head<3>().transpose() / kLever_mm,
        patch.jacobian.tail<3>().transpose(), 1.0, stretch_mm.transpose(), patch.residual_mm,
        seen.turn_mm ? kTurn_rad * patch.normal.dot(seen.turn_mm(patch.at_mri_mm)) : 0.0;
    for (Eigen::Index j = 0; j <= i; ++j)
      model.distance_mm(i, j) = model.distance_mm(j, i) =
          (patch.at_mri_mm - patches[std::size_t(j)].at_mri_mm).norm();
  }
  return model;
}

/// Matern 3/2: smooth skin with detail at every scale below its reach.
Eigen::MatrixXf maternOf(const MatrixXd& distance_mm, double reach_mm) {
  const Eigen::ArrayXXf u = distance_mm.array().cast<float>() * float(std::sqrt(3.0) / reach_mm);
  return (1.0f + u) * (-u).exp();
}

MatrixXd correlation(const MatrixXd& distance_mm, double reach_mm) {
  return maternOf(distance_mm, reach_mm).cast<double>();
}

/// Covariance of smooth field and noise.
MatrixXd fieldCovariance(const LinearModel& model, const MatrixXd& correlation, const FieldShape& shape) {
  const VectorXd size = shape.size_mm * (1.0 + (shape.soft - 1.0) * model.softness.array()).matrix();
  MatrixXd k = size.asDiagonal() * correlation * size.asDiagonal();
  k.diagonal() += model.noise2;
  return k;
}

/// The model whitened under one shape of the field: sufficient for the modes' sizes and the pose.
struct Whitened {
  Eigen::Matrix<double, LinearModel::kColumns, LinearModel::kColumns> products;
  double log_determinant;
};

Whitened whiten(const LinearModel& model, const MatrixXd& field_covariance) {
  const Eigen::LLT<MatrixXd> factor(field_covariance);
  const Eigen::Matrix<double, Eigen::Dynamic, LinearModel::kColumns> white =
      factor.matrixL().solve(model.columns);
  return {white.transpose() * white, 2 * factor.matrixLLT().diagonal().array().log().sum()};
}

/// Generalised least squares of `unknowns` among the columns; `modes` are random with the given sigmas
/// (Woodbury). Returns the estimate, its covariance, and the logarithm of the restricted likelihood.
struct Estimate {
  VectorXd value;
  MatrixXd covariance;
  double log_likelihood;
};

Estimate estimate(const Whitened& white, const MatrixXd& unknowns, const MatrixXd& modes,
                  const VectorXd& sigma) {
  const VectorXd residual = VectorXd::Unit(LinearModel::kColumns, LinearModel::kResidual);
  MatrixXd capacity = modes.transpose() * white.products * modes;
  capacity.diagonal() += sigma.cwiseAbs2().cwiseInverse();
  const Eigen::LLT<MatrixXd> random(capacity);
  const MatrixXd by_modes = white.products * modes;
  const MatrixXd products = white.products - by_modes * random.solve(by_modes.transpose());
  const Eigen::LLT<MatrixXd> information(unknowns.transpose() * products * unknowns);
  const VectorXd score = unknowns.transpose() * products * residual;
  const auto logDeterminant = [](const Eigen::LLT<MatrixXd>& f) {
    return 2 * f.matrixLLT().diagonal().array().log().sum();
  };
  Estimate out{information.solve(score), information.solve(MatrixXd::Identity(score.size(), score.size())),
               0};
  out.log_likelihood =
      -0.5 * (white.log_determinant + logDeterminant(random) + 2 * sigma.array().log().sum() +
              logDeterminant(information) + residual.dot(products * residual) - score.dot(out.value));
  return out;
}

Estimate estimatePose(const Whitened& white, const ModeSizes& sizes) {
  const MatrixXd all = MatrixXd::Identity(LinearModel::kColumns, LinearModel::kColumns);
  return estimate(white, all.leftCols<LinearModel::kPose>(), all.middleCols<4>(LinearModel::kOffset),
                  (VectorXd(4) << sizes.offset_mm, VectorXd::Constant(3, sizes.scale)).finished());
}

/// Estimate and variance of a scale common to all axes, fitted together with the pose.
std::pair<double, double> estimateScale(const Whitened& white, const ModeSizes& sizes) {
  MatrixXd unknowns = MatrixXd::Zero(LinearModel::kColumns, 7);
  unknowns.topLeftCorner<6, 6>().setIdentity();
  unknowns.block<3, 1>(LinearModel::kScale, 6).setOnes();
  const Estimate out = estimate(white, unknowns, VectorXd::Unit(LinearModel::kColumns, LinearModel::kOffset),
                                VectorXd::Constant(1, sizes.offset_mm));
  return {out.value[6], out.covariance(6, 6)};
}

/// Estimate and variance of the right camera's turn, fitted together with the pose. The scan's offset and
/// scale along each axis are random, with their prior sizes.
std::pair<double, double> estimateTurn(const Whitened& white, const ModeSizes& sizes) {
  MatrixXd unknowns = MatrixXd::Zero(LinearModel::kColumns, 7);
  unknowns.topLeftCorner<6, 6>().setIdentity();
  unknowns(LinearModel::kTurn, 6) = 1.0;
  const MatrixXd all = MatrixXd::Identity(LinearModel::kColumns, LinearModel::kColumns);
  const Estimate out =
      estimate(white, unknowns, all.middleCols<4>(LinearModel::kOffset),
               (VectorXd(4) << sizes.offset_mm, VectorXd::Constant(3, sizes.scale)).finished());
  return {out.value[6], out.covariance(6, 6)};
}

struct Plausible {
  FieldShape shape;
  std::vector<ModeSizes> modes;  // log_weight: of shape and sizes together; 0 for the best
  double log_weight;             // log weight of the best sizes
};

/// Shapes and sizes that agree with the residuals, with posterior weights. Those below 2 % of the best are
/// left out.
std::vector<Plausible> plausibleShapes(const LinearModel& model, const MisfitPrior& prior) {
  constexpr double kStep = 0.55, kLeast = -4.0;
  std::vector<Plausible> all;
  for (const double reach_mm : {12.0, 25.0, 50.0, 100.0}) {
    const MatrixXd c = correlation(model.distance_mm, reach_mm);
    for (const double soft : {1.0, 2.5})
      for (int step = -4; step <= 3; ++step) {
        Plausible some{{prior.field_mm * std::exp(kStep * step), reach_mm, soft}, {}, -1e300};
        const double believed = -0.5 * std::pow(kStep * step / prior.field_spread, 2);
        const Whitened white = whiten(model, fieldCovariance(model, c, some.shape));
        for (const auto& [offset_mm, offset_share] : prior.offsets_mm)
          for (const auto& [scale, scale_share] : prior.scales) {
            ModeSizes sizes{offset_mm, scale, believed + std::log(offset_share * scale_share)};
            sizes.log_weight += estimatePose(white, sizes).log_likelihood;
            some.log_weight = std::max(some.log_weight, sizes.log_weight);
            some.modes.push_back(sizes);
          }
        all.push_back(some);
      }
  }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.log_weight > b.log_weight; });
  const double best = all.front().log_weight;
  const auto is_unlikely = [best](const auto& w) { return !(w.log_weight > best + kLeast); };
  all.erase(std::remove_if(all.begin(), all.end(), is_unlikely), all.end());
  if (all.size() > kMostShapes) all.resize(kMostShapes);
  for (auto& w : all) {
    w.modes.erase(std::remove_if(w.modes.begin(), w.modes.end(), is_unlikely), w.modes.end());
    for (auto& sizes : w.modes) sizes.log_weight -= best;
  }
  return all;
}

/// Every `stride`-th patch; enough to estimate the field's shape.
std::vector<SkinPatch> some(const std::vector<SkinPatch>& patches, std::size_t most) {
  if (patches.size() <= most) return patches;
  std::vector<SkinPatch> out;
  const double stride = double(patches.size()) / double(most);
  for (double at = 0; at < double(patches.size()); at += stride) out.push_back(patches[std::size_t(at)]);
  return out;
}

/// Covariance of the residuals at the right pose: field, noise, offset and scale.
MatrixXd misfitCovariance(const LinearModel& model, const FieldShape& shape, const ModeSizes& sizes) {
  MatrixXd k = fieldCovariance(model, correlation(model.distance_mm, shape.reach_mm), shape);
  const auto offset = model.columns.col(LinearModel::kOffset);
  const auto scale = model.columns.middleCols<3>(LinearModel::kScale);
  k += sizes.offset_mm * sizes.offset_mm * offset * offset.transpose();
  k += sizes.scale * sizes.scale * scale * scale.transpose();
  return k;
}

/// Adds noise to patches that neighbours and pose do not explain, by cross-validated residuals (Rasmussen and
/// Williams 2006, equation 5.12).
void dropOutliers(LinearModel& model, const Plausible& likeliest) {
  const Eigen::LLT<MatrixXd> factor(misfitCovariance(model, likeliest.shape, likeliest.modes.front()));
  const auto n = model.columns.rows();
  const MatrixXd root = factor.matrixL().solve(MatrixXd::Identity(n, n));
  const auto design = model.columns.leftCols<LinearModel::kPose>();
  const VectorXd residual = model.columns.col(LinearModel::kResidual);
  const MatrixXd weighted = factor.solve(design);
  const VectorXd error = (design.transpose() * weighted).llt().solve(weighted.transpose() * residual);
  const VectorXd unexplained = factor.solve(residual - design * error);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double precision = root.col(i).squaredNorm(), sigma = std::sqrt(precision);
    const double z = std::abs(unexplained[i]) / sigma;
    if (z > 3) model.noise2[i] += std::pow((z - 2.0) / sigma, 2);
  }
}

/// The linear estimator of the pose, error = estimator * residual. Its weights assume only short
/// correlations: variation within patches, a small part shared by neighbours, offset and scale of a good
/// scan.
MatrixXd workingEstimator(const LinearModel& model) {
  const MisfitPrior& prior = settingsOf<MisfitPrior>();
  const double offset_mm = prior.working_offset_mm, scale = prior.working_scale;
  const Eigen::VectorXf field_mm =
      (prior.working_field_mm * (1.0 + (prior.working_soft - 1.0) * model.softness.array())).cast<float>();
  Eigen::MatrixXf k =
      field_mm.asDiagonal() * maternOf(model.distance_mm, prior.working_reach_mm) * field_mm.asDiagonal();
  k.diagonal() += model.noise2.cast<float>();  // well conditioned, so single precision is enough
  const MatrixXd design = model.columns.leftCols<LinearModel::kResidual>();
  const MatrixXd weighted = k.llt().solve(design.cast<float>()).cast<double>();
  MatrixXd information = design.transpose() * weighted;
  information(LinearModel::kOffset, LinearModel::kOffset) += 1 / (offset_mm * offset_mm);
  for (int axis = 0; axis < 3; ++axis)
    information(LinearModel::kScale + axis, LinearModel::kScale + axis) += 1 / (scale * scale);
  return information.llt().solve(weighted.transpose()).topRows<LinearModel::kPose>();
}

/// Covariance of the estimate averaged over these shapes, times the sum of their weights.
Matrix6d covarianceUnder(const std::vector<Plausible>& shapes, const LinearModel& model,
                         const MatrixXd& estimator) {
  const Vector6d by_offset = estimator * model.columns.col(LinearModel::kOffset);
  const Eigen::Matrix<double, 6, 3> by_scale = estimator * model.columns.middleCols<3>(LinearModel::kScale);
  Matrix6d sum = Matrix6d::Zero();
  for (const auto& [shape, modes, log_weight] : shapes) {
    const MatrixXd k = fieldCovariance(model, correlation(model.distance_mm, shape.reach_mm), shape);
    const Matrix6d by_field = estimator * k * estimator.transpose();
    for (const auto& sizes : modes)
      sum += std::exp(sizes.log_weight) *
             (by_field + std::pow(sizes.offset_mm, 2) * by_offset * by_offset.transpose() +
              std::pow(sizes.scale, 2) * by_scale * by_scale.transpose());
  }
  return sum;
}

/// Weighted mean over the plausible shapes and sizes, with the variance within and between them.
CameraTurn turnUnder(const std::vector<Plausible>& shapes, const LinearModel& model, double tails) {
  double total = 0, mean = 0, squares = 0;
  for (const auto& [shape, modes, log_weight] : shapes) {
    const Whitened white =
        whiten(model, fieldCovariance(model, correlation(model.distance_mm, shape.reach_mm), shape));
    for (const auto& sizes : modes) {
      const auto [turn, variance] = estimateTurn(white, sizes);
      const double weight = std::exp(sizes.log_weight);
      total += weight, mean += weight * turn, squares += weight * (tails * variance + turn * turn);
    }
  }
  mean /= total;
  return {kTurn_rad * mean, kTurn_rad * std::sqrt(std::max(0.0, squares / total - mean * mean))};
}

/// Covariance of the estimate due to the cloud's error along the lines of sight.
Matrix6d covarianceBySight(const std::vector<SkinPatch>& patches, const LinearModel& model,
                           const MatrixXd& estimator, const SeenFrom& seen) {
  if (!(seen.error.sigma_mm > 0)) return Matrix6d::Zero();
  VectorXd along_normal_mm(Eigen::Index(patches.size()));
  for (std::size_t i = 0; i < patches.size(); ++i)
    along_normal_mm[Eigen::Index(i)] =
        seen.error.sigma_mm * patches[i].normal.dot((seen.camera_mri_mm - patches[i].at_mri_mm).normalized());
  const MatrixXd weighted = estimator * along_normal_mm.asDiagonal();
  return weighted * correlation(model.distance_mm, seen.error.reach_mm) * weighted.transpose();
}

Vector6d units() {
  Vector6d units;
  units << Eigen::Vector3d::Constant(1.0 / kLever_mm), Eigen::Vector3d::Ones();
  return units;
}

}  // namespace

Vector6d poseError(const std::vector<SkinPatch>& patches, const anatomy::FaceRegions& regions,
                   const Eigen::Vector3d& pivot) {
  const LinearModel model = linearModel(patches, regions, pivot);
  return units().asDiagonal() * (workingEstimator(model) * model.columns.col(LinearModel::kResidual));
}

PosePosterior posteriorOf(const std::vector<SkinPatch>& patches, const anatomy::FaceRegions& regions,
                          const Eigen::Vector3d& pivot, const MisfitPrior& prior, const SeenFrom& seen) {
  const auto shapes = plausibleShapes(linearModel(some(patches, kShapePatches), regions, pivot), prior);
  LinearModel model = linearModel(patches, regions, pivot, seen);
  dropOutliers(model, shapes.front());
  const MatrixXd estimator = workingEstimator(model);
  PosePosterior posterior;
  double total = 0;
  for (const auto& [shape, modes, log_weight] : shapes)
    for (const auto& sizes : modes) {
      const double weight = std::exp(sizes.log_weight);
      total += weight;
      posterior.field_mm += weight * shape.size_mm;
      posterior.reach_mm += weight * shape.reach_mm;
    }
  posterior.field_mm /= total, posterior.reach_mm /= total;
  posterior.error = estimator * model.columns.col(LinearModel::kResidual);
  posterior.covariance = covarianceUnder(shapes, model, estimator) / total;
  // The field's size is estimated from a limited number of independent values: the face divided by its reach.
  // The error therefore has Student's t distribution, which is wider than the plug-in covariance.
  posterior.freedom =
      std::clamp(double(patches.size()) * std::pow(kModelPatch_mm / posterior.reach_mm, 2), 5.0, 60.0);
  const double tails = posterior.freedom / (posterior.freedom - 2.0);
  posterior.covariance = tails * posterior.covariance + covarianceBySight(patches, model, estimator, seen);
  const FieldShape& likeliest = shapes.front().shape;
  const auto [scale, variance] = estimateScale(
      whiten(model, fieldCovariance(model, correlation(model.distance_mm, likeliest.reach_mm), likeliest)),
      shapes.front().modes.front());
  posterior.scale = scale, posterior.scale_sigma = std::sqrt(tails * variance);
  if (seen.turn_mm) posterior.turn = turnUnder(shapes, model, tails);
  posterior.error_by_turn =
      units().asDiagonal() * (estimator * model.columns.col(LinearModel::kTurn) / kTurn_rad);
  posterior.error = units().asDiagonal() * posterior.error;
  posterior.covariance = units().asDiagonal() * posterior.covariance * units().asDiagonal();
  return posterior;
}

}  // namespace facenav::registration
