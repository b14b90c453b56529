#include "misfit_model.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace facenav::registration {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Design = Eigen::Matrix<double, Eigen::Dynamic, 6>;

/// What the size of the smooth field may be, its reach, and how much larger it is over soft tissue.
struct FieldShape {
  double size_mm, reach_mm, soft;
};

/// The patches as one linear model: residual = misfit + design * error.
struct LinearModel {
  VectorXd residual, noise2, softness;
  Design design;
  MatrixXd distance_mm;
  MatrixXd fixed;  // covariance of what has no free size: offset and scale
  MatrixXd scale_covariance;
  VectorXd stretch_mm;  // residual of a live face of twice the size
};

/// Rotations are stated at this lever, so that all six columns are of one size.
constexpr double kLever_mm = 100.0;
constexpr double kPatch_mm = 12.0;

LinearModel linearModel(const std::vector<SkinPatch>& patches, const FaceRegions& regions,
                        const Eigen::Vector3d& pivot, const MisfitPrior& prior) {
  const auto n = Eigen::Index(patches.size());
  LinearModel model{VectorXd(n), VectorXd(n), VectorXd(n), Design(n, 6), MatrixXd(n, n), {}, {}, VectorXd(n)};
  Eigen::Matrix<double, Eigen::Dynamic, 4> modes(n, 4);
  for (Eigen::Index i = 0; i < n; ++i) {
    const SkinPatch& patch = patches[std::size_t(i)];
    model.residual[i] = patch.residual_mm;
    model.noise2[i] = patch.noise_mm * patch.noise_mm;
    model.softness[i] = regions.softness(patch.at_mri_mm);
    model.design.row(i) = patch.jacobian.transpose();
    modes(i, 0) = prior.offset_mm;
    for (int a = 0; a < 3; ++a)
      modes(i, 1 + a) = prior.scale * patch.normal[a] * (patch.at_mri_mm[a] - pivot[a]);
    model.stretch_mm[i] = patch.normal.dot(patch.at_mri_mm - pivot);
    for (Eigen::Index j = 0; j <= i; ++j)
      model.distance_mm(i, j) = model.distance_mm(j, i) =
          (patch.at_mri_mm - patches[std::size_t(j)].at_mri_mm).norm();
  }
  model.design.leftCols<3>() /= kLever_mm;
  model.scale_covariance = modes.rightCols<3>() * modes.rightCols<3>().transpose();
  model.fixed = modes.col(0) * modes.col(0).transpose() + model.scale_covariance;
  return model;
}

/// Matern 3/2: smooth skin, with detail at every scale below its reach.
MatrixXd correlation(const MatrixXd& distance_mm, double reach_mm) {
  const Eigen::ArrayXXd u = distance_mm.array() * (std::sqrt(3.0) / reach_mm);
  return ((1.0 + u) * (-u).exp()).matrix();
}

struct Estimate {
  Eigen::LLT<MatrixXd> factor;
  Vector6d error;
  Matrix6d covariance;
  double log_likelihood;  // restricted
};

/// Covariance of the residuals of a right pose.
MatrixXd misfitCovariance(const LinearModel& model, const MatrixXd& correlation, const FieldShape& shape) {
  const VectorXd size = shape.size_mm * (1.0 + (shape.soft - 1.0) * model.softness.array()).matrix();
  MatrixXd k = size.asDiagonal() * correlation * size.asDiagonal();
  k += model.fixed;
  k.diagonal() += model.noise2;
  return k;
}

Estimate estimate(const LinearModel& model, const MatrixXd& correlation, const FieldShape& shape) {
  const MatrixXd k = misfitCovariance(model, correlation, shape);
  Estimate out{Eigen::LLT<MatrixXd>(k), {}, {}, 0};
  const Design whitened = out.factor.matrixL().solve(model.design);
  const VectorXd residual = out.factor.matrixL().solve(model.residual);
  const Matrix6d information = whitened.transpose() * whitened;
  const Eigen::LLT<Matrix6d> inverse(information);
  const Vector6d rhs = whitened.transpose() * residual;
  out.error = inverse.solve(rhs);
  out.covariance = inverse.solve(Matrix6d::Identity());
  const double log_k = 2 * out.factor.matrixLLT().diagonal().array().log().sum();
  const double log_information = 2 * Matrix6d(inverse.matrixL()).diagonal().array().log().sum();
  out.log_likelihood = -0.5 * (log_k + log_information + residual.squaredNorm() - rhs.dot(out.error));
  return out;
}

/// Scale beside the pose: its estimate and variance.
std::pair<double, double> estimateScale(const LinearModel& model, const FieldShape& shape) {
  const Eigen::LLT<MatrixXd> factor(
      misfitCovariance(model, correlation(model.distance_mm, shape.reach_mm), shape) -
      model.scale_covariance);
  Eigen::Matrix<double, Eigen::Dynamic, 7> design(model.design.rows(), 7);
  design << model.design, model.stretch_mm / kLever_mm;
  design = factor.matrixL().solve(design);
  const VectorXd residual = factor.matrixL().solve(model.residual);
  const Eigen::LLT<Eigen::Matrix<double, 7, 7>> inverse(design.transpose() * design);
  const double scale = inverse.solve(design.transpose() * residual)[6] / kLever_mm;
  return {scale, inverse.solve(Eigen::Matrix<double, 7, 7>::Identity())(6, 6) / (kLever_mm * kLever_mm)};
}

struct Weighted {
  FieldShape shape;
  double log_weight;
};

/// Shapes that the residuals leave open, by their posterior weight; those below 2 % of the best are left out.
std::vector<Weighted> plausibleShapes(const LinearModel& model, const MisfitPrior& prior) {
  std::vector<Weighted> all;
  for (const double reach_mm : {12.0, 25.0, 50.0, 100.0}) {
    const MatrixXd c = correlation(model.distance_mm, reach_mm);
    for (const double soft : {1.0, 2.5})
      for (const double step : {-2.0, -1.0, 0.0, 1.0, 2.0, 3.0}) {
        const FieldShape shape{prior.field_mm * std::exp(0.55 * step), reach_mm, soft};
        const double believed = -0.5 * std::pow(0.55 * step / prior.field_spread, 2);
        all.push_back({shape, estimate(model, c, shape).log_likelihood + believed});
      }
  }
  double best = -1e300;
  for (const auto& w : all) best = std::max(best, w.log_weight);
  all.erase(
      std::remove_if(all.begin(), all.end(), [&](const Weighted& w) { return !(w.log_weight > best - 4.0); }),
      all.end());
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.log_weight > b.log_weight; });
  for (auto& w : all) w.log_weight -= best;
  return all;
}

/// Every `stride`-th patch, for what only the field's shape is asked.
std::vector<SkinPatch> some(const std::vector<SkinPatch>& patches, std::size_t most) {
  if (patches.size() <= most) return patches;
  std::vector<SkinPatch> out;
  const double stride = double(patches.size()) / double(most);
  for (double at = 0; at < double(patches.size()); at += stride) out.push_back(patches[std::size_t(at)]);
  return out;
}

}  // namespace

PoseBelief believe(const std::vector<SkinPatch>& patches, const FaceRegions& regions,
                   const Eigen::Vector3d& pivot, const MisfitPrior& prior) {
  auto shapes = plausibleShapes(linearModel(some(patches, 120), regions, pivot, prior), prior);
  if (shapes.size() > 6) shapes.resize(6);
  LinearModel model = linearModel(patches, regions, pivot, prior);
  PoseBelief belief;
  // What the neighbours and the pose do not explain: cross-validated residuals (Rasmussen and Williams 2006,
  // equation 5.12).
  for (int round = 0; round < 2; ++round) {
    const Estimate best =
        estimate(model, correlation(model.distance_mm, shapes.front().shape.reach_mm), shapes.front().shape);
    const MatrixXd inverse =
        best.factor.solve(MatrixXd::Identity(model.residual.size(), model.residual.size()));
    const VectorXd unexplained = inverse * (model.residual - model.design * best.error);
    belief.surprise.clear();
    for (Eigen::Index i = 0; i < model.residual.size(); ++i) {
      const double sigma = std::sqrt(inverse(i, i));
      belief.surprise.push_back(unexplained[i] / sigma);
      const double z = std::abs(belief.surprise.back());
      if (round == 0 && z > 3) model.noise2[i] += std::pow((z - 2.0) / sigma, 2);
    }
  }
  double total = 0;
  std::vector<std::pair<double, Estimate>> mixture;
  for (const auto& w : shapes) {
    mixture.emplace_back(std::exp(w.log_weight),
                         estimate(model, correlation(model.distance_mm, w.shape.reach_mm), w.shape));
    total += mixture.back().first;
    belief.field_mm += mixture.back().first * w.shape.size_mm;
    belief.reach_mm += mixture.back().first * w.shape.reach_mm;
    belief.error += mixture.back().first * mixture.back().second.error;
  }
  belief.error /= total, belief.field_mm /= total, belief.reach_mm /= total;
  for (const auto& [weight, e] : mixture) {
    const Vector6d apart = e.error - belief.error;
    belief.covariance += weight / total * (e.covariance + apart * apart.transpose());
  }
  // The field's size was estimated from as many independent values as its reach leaves on the face: the error
  // is distributed as Student's t, wider than the plug-in covariance says.
  belief.freedom = std::clamp(double(patches.size()) * std::pow(kPatch_mm / belief.reach_mm, 2), 5.0, 60.0);
  const double tails = belief.freedom / (belief.freedom - 2.0);
  belief.covariance *= tails;
  const auto [scale, variance] = estimateScale(model, shapes.front().shape);
  belief.scale = scale, belief.scale_sigma = std::sqrt(tails * variance);
  Vector6d units;
  units << Eigen::Vector3d::Constant(1.0 / kLever_mm), Eigen::Vector3d::Ones();
  belief.error = units.asDiagonal() * belief.error;
  belief.covariance = units.asDiagonal() * belief.covariance * units.asDiagonal();
  return belief;
}

}  // namespace facenav::registration
