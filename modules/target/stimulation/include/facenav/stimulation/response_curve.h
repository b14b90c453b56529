#pragma once
// The muscle's response against the field at one spot: a straight line, and a sigmoid as Weise et al. 2020
// (NeuroImage 209: 116486) fit it. Which one the pulses carry is decided by Akaike's information criterion
// with its correction for few pulses (AICc; Hurvich and Tsai 1989, Biometrika 76: 297). Pure functions of
// numbers; deterministic.

#include <Eigen/Core>
#include <string>

namespace facenav::stimulation {

/// y = low + height / (1 + exp(-(x - midpoint) / width)).
struct Sigmoid {
  double low = 0, height = 0, midpoint = 0, width = 1;
  double at(double x) const;
};

enum class CurveVerdict {
  sigmoid,  ///< it describes the pulses better than the line
  line,     ///< the line does as well
  no_bend   ///< the pulses lie on one side of the bend alone, so there is no midpoint
};

struct ResponseCurve {
  CurveVerdict verdict = CurveVerdict::line;
  double intercept = 0, slope = 0;  ///< of the line
  double r2_line = 0;
  Sigmoid sigmoid;  ///< the best one, also where the line is better
  double r2_sigmoid = 0;
  double aicc_gain = 0;  ///< AICc of the line minus that of the sigmoid; > 0: for the sigmoid
};

/// Least difference of the criterion by which the sigmoid must be better: models within 2 are about as good
/// (Burnham and Anderson 2004, Sociol Methods Res 33: 261).
constexpr double kLeastGain = 2;
/// Least number of pulses below and above the midpoint.
constexpr int kLeastOnASide = 5;

/// Fits both to as many responses as fields. Throws Error for fewer than 10, or if all fields are equal.
ResponseCurve fitResponse(const Eigen::VectorXd& field, const Eigen::VectorXd& response);

}  // namespace facenav::stimulation
