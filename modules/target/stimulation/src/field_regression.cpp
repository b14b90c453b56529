#include "facenav/stimulation/field_regression.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"

namespace facenav::stimulation {
namespace {

constexpr int kShuffles = 400, kResamplings = 400;
constexpr float kTiny = 1e-12f;

/// Values minus their mean, of length 1; zeros if they are all equal.
Eigen::VectorXf standardised(const Eigen::VectorXf& values) {
  const Eigen::VectorXf centred = values.array() - values.mean();
  const float norm = centred.norm();
  return norm > kTiny ? Eigen::VectorXf(centred / norm) : Eigen::VectorXf::Zero(values.size());
}

/// Standardises each row in the same way.
Eigen::MatrixXf standardisedRows(const Eigen::MatrixXf& field) {
  Eigen::MatrixXf rows = field.colwise() - field.rowwise().mean();
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const float norm = rows.row(i).norm();
    if (norm > kTiny)
      rows.row(i) /= norm;
    else
      rows.row(i).setZero();
  }
  return rows;
}

/// R2 from correlations; a response that falls with the field explains nothing.
Eigen::VectorXf r2Of(const Eigen::VectorXf& correlation) { return correlation.cwiseMax(0).array().square(); }

struct Responses {
  Eigen::VectorXf mep, log_mep;
};

Responses responsesOf(const std::vector<double>& mep_uv, double noise_uv) {
  Responses responses{Eigen::VectorXf(mep_uv.size()), Eigen::VectorXf(mep_uv.size())};
  for (std::size_t i = 0; i < mep_uv.size(); ++i) {
    responses.mep[Eigen::Index(i)] = float(mep_uv[i]);
    responses.log_mep[Eigen::Index(i)] = float(std::log10(std::max(mep_uv[i], noise_uv)));
  }
  return responses;
}

/// Share of shuffled MEPs whose best R2, of all places and both responses, reaches `r2`. The observed order
/// counts as one of them.
double chanceOf(const Eigen::MatrixXf& rows, const Responses& responses, double r2) {
  std::mt19937 random(20231);
  std::vector<Eigen::Index> order(std::size_t(rows.cols()));
  std::iota(order.begin(), order.end(), 0);
  Eigen::MatrixXf shuffled(rows.cols(), 2 * kShuffles);
  const Eigen::VectorXf plain = standardised(responses.mep), log = standardised(responses.log_mep);
  for (int s = 0; s < kShuffles; ++s) {
    std::shuffle(order.begin(), order.end(), random);
    for (Eigen::Index i = 0; i < rows.cols(); ++i) {
      shuffled(i, 2 * s) = plain[order[std::size_t(i)]];
      shuffled(i, 2 * s + 1) = log[order[std::size_t(i)]];
    }
  }
  const Eigen::RowVectorXf best = (rows * shuffled).cwiseMax(0).colwise().maxCoeff();
  int reached = 1;
  for (int s = 0; s < kShuffles; ++s) {
    const float largest = std::max(best[2 * s], best[2 * s + 1]);
    reached += largest * largest >= r2;
  }
  return double(reached) / (kShuffles + 1);
}

/// Best place for each resampling of the pulses. `y`: standardised responses.
std::vector<Eigen::Index> resampledBest(const Eigen::MatrixXf& rows, const Eigen::VectorXf& y) {
  const Eigen::Index n = rows.cols();
  std::mt19937 random(4711);
  std::uniform_int_distribution<Eigen::Index> any(0, n - 1);
  Eigen::MatrixXf counts = Eigen::MatrixXf::Zero(n, kResamplings);
  for (int b = 0; b < kResamplings; ++b)
    for (Eigen::Index i = 0; i < n; ++i) counts(any(random), b) += 1;
  const Eigen::MatrixXf of_y = (counts.array().colwise() * y.array()).matrix();
  const Eigen::MatrixXf x = rows * counts / float(n), xy = rows * of_y / float(n);
  const Eigen::MatrixXf xx = rows.cwiseAbs2() * counts / float(n);
  std::vector<Eigen::Index> best(kResamplings, 0);
  for (int b = 0; b < kResamplings; ++b) {
    const float mean_y = of_y.col(b).sum() / float(n);
    const Eigen::ArrayXf variance = (xx.col(b).array() - x.col(b).array().square()).max(kTiny);
    const Eigen::ArrayXf covariance = xy.col(b).array() - mean_y * x.col(b).array();
    (covariance / variance.sqrt()).maxCoeff(&best[std::size_t(b)]);
  }
  return best;
}

}  // namespace

std::string toString(FieldResponse response) { return response == FieldResponse::linear ? "linear" : "log"; }

FieldRegression regressOnField(const Eigen::MatrixXf& field, const std::vector<double>& mep_uv,
                               const FieldRegressionOptions& options) {
  FACENAV_EXPECT(std::size_t(field.cols()) == mep_uv.size() && field.rows() > 0,
                 "one field for each MEP, and a place");
  if (int(mep_uv.size()) < options.least_pulses)
    throw Error(formatted("%zu pulses with MEP and pose are too few for a map by field", mep_uv.size()), {},
                formatted("at least %d are needed, with the coil held in many ways", options.least_pulses));
  if (*std::max_element(mep_uv.begin(), mep_uv.end()) <= *std::min_element(mep_uv.begin(), mep_uv.end()))
    throw Error("all MEPs are equal, so no place can explain them", {}, "enter the measured MEPs");
  const Eigen::MatrixXf rows = standardisedRows(field);
  const Responses responses = responsesOf(mep_uv, options.noise_uv);
  const Eigen::VectorXf plain = standardised(responses.mep), log = standardised(responses.log_mep);
  FieldRegression result;
  result.r2_linear = r2Of(rows * plain);
  result.r2_log = r2Of(rows * log);
  const bool is_log = result.r2_log.maxCoeff() > result.r2_linear.maxCoeff();
  result.response = is_log ? FieldResponse::log : FieldResponse::linear;
  result.r2 = (is_log ? result.r2_log : result.r2_linear).maxCoeff(&result.best);
  result.chance = chanceOf(rows, responses, result.r2);
  result.is_explained = result.chance <= options.most_chance;
  result.best_of_resampled = resampledBest(rows, is_log ? log : plain);
  return result;
}

}  // namespace facenav::stimulation
