#pragma once
// Which place of the cortex explains the muscle's responses? At the right place the MEP follows the local
// field, however the coil was held. At each place the MEPs of many poses are regressed on |E| there, and R2
// says how much of them it explains (Weise et al. 2020, NeuroImage 209: 116486; Numssen et al. 2021,
// NeuroImage 245: 118654). Those fit a sigmoid; here the MEP and its logarithm are fitted by a line. Pure
// functions of numbers; the places have no frame here.

#include <Eigen/Core>
#include <string>
#include <vector>

namespace facenav::stimulation {

struct FieldRegressionOptions {
  int least_pulses = 20;      ///< Numssen et al. 2021 find the place with some 20 to 30 pulses
  double most_chance = 0.05;  ///< the customary 5 %
  double noise_uv = 10;       ///< about surface EMG at rest; smaller MEPs count as this in the logarithm
};

enum class FieldResponse { linear, log };
/// Returns "linear" or "log".
std::string toString(FieldResponse response);

struct FieldRegression {
  Eigen::VectorXf r2_linear, r2_log;               ///< at each place; 0 where the MEP falls with the field
  FieldResponse response = FieldResponse::linear;  ///< the better one of both at its best place
  Eigen::Index best = -1;                          ///< place with the largest R2 of this response
  double r2 = 0;
  double chance = 1;          ///< share of shuffled MEPs whose best R2, of any place, is at least `r2`
  bool is_explained = false;  ///< chance is at most most_chance
  std::vector<Eigen::Index> best_of_resampled;  ///< best place for each resampling of the pulses (bootstrap)
};

/// Regresses on the field (places x pulses; any unit). Deterministic. Throws Error: fewer pulses than
/// `least_pulses`, MEPs that are all equal, or numbers that do not belong together.
FieldRegression regressOnField(const Eigen::MatrixXf& field, const std::vector<double>& mep_uv,
                               const FieldRegressionOptions& options = {});

}  // namespace facenav::stimulation
