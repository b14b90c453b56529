#include "facenav/stimulation/response_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "facenav/core/error.h"

namespace facenav::stimulation {
namespace {

constexpr int kLeastResponses = 10;
constexpr int kLineParameters = 3, kSigmoidParameters = 5;  // each with the scatter
constexpr int kGridSteps = 24, kShrinks = 12;               // of the search for midpoint and width
constexpr double kNearZero = 1e-12;

struct StraightLine {
  double intercept = 0, slope = 0, squares = 0;  // squares: sum of the squared residuals
};

StraightLine lineThrough(const Eigen::ArrayXd& x, const Eigen::ArrayXd& y) {
  const double mean_x = x.mean(), mean_y = y.mean();
  const double variance = (x - mean_x).square().sum();
  StraightLine line;
  line.slope = variance > kNearZero ? ((x - mean_x) * (y - mean_y)).sum() / variance : 0;
  line.intercept = mean_y - line.slope * mean_x;
  line.squares = (y - line.intercept - line.slope * x).square().sum();
  return line;
}

double aicc(double squares, Eigen::Index n, int parameters) {
  const double count = double(n), k = parameters;
  return count * std::log(std::max(squares / count, kNearZero)) + 2 * k + 2 * k * (k + 1) / (count - k - 1);
}

struct FittedSigmoid {
  Sigmoid curve;
  double squares = std::numeric_limits<double>::max();
};

/// The best sigmoid of one midpoint and width: low and height follow from a line. One that falls is none.
FittedSigmoid sigmoidWith(double midpoint, double width, const Eigen::ArrayXd& x, const Eigen::ArrayXd& y) {
  const Eigen::ArrayXd share = 1 / (1 + (-(x - midpoint) / width).exp());
  const StraightLine line = lineThrough(share, y);
  FittedSigmoid fitted;
  if (line.slope <= 0) return fitted;
  fitted.curve = {line.intercept, line.slope, midpoint, width};
  fitted.squares = line.squares;
  return fitted;
}

/// Searches midpoint and width on a grid that shrinks about the best one.
FittedSigmoid bestSigmoid(const Eigen::ArrayXd& x, const Eigen::ArrayXd& y) {
  const double low = x.minCoeff(), range = x.maxCoeff() - low;
  double midpoint = low + range / 2, log_width = std::log(range / 12);
  double midpoint_span = range / 2, width_span = std::log(6.0);  // widths of a 72nd to a half of the range
  FittedSigmoid best;
  for (int round = 0; round < kShrinks; ++round) {
    const double from_midpoint = midpoint, from_width = log_width;
    for (int i = 0; i <= kGridSteps; ++i)
      for (int j = 0; j <= kGridSteps; ++j) {
        const double m = from_midpoint + midpoint_span * (2.0 * i / kGridSteps - 1);
        const double w = from_width + width_span * (2.0 * j / kGridSteps - 1);
        const auto fitted = sigmoidWith(m, std::exp(w), x, y);
        if (fitted.squares < best.squares) best = fitted, midpoint = m, log_width = w;
      }
    midpoint_span /= 2;
    width_span /= 2;
  }
  return best;
}

}  // namespace

double Sigmoid::at(double x) const { return low + height / (1 + std::exp(-(x - midpoint) / width)); }

ResponseCurve fitResponse(const Eigen::VectorXd& field, const Eigen::VectorXd& response) {
  FACENAV_EXPECT(field.size() == response.size(), "one response a field");
  if (field.size() < kLeastResponses) throw Error("too few pulses for a curve of the response");
  if (!(field.maxCoeff() > field.minCoeff())) throw Error("all pulses had the same field at the spot");
  const Eigen::ArrayXd x = field.array(), y = response.array();
  const StraightLine line = lineThrough(x, y);
  const FittedSigmoid best = bestSigmoid(x, y);
  ResponseCurve result;
  result.intercept = line.intercept;
  result.slope = line.slope;
  const double all = std::max((y - y.mean()).square().sum(), kNearZero);
  result.r2_line = 1 - line.squares / all;
  if (best.squares == std::numeric_limits<double>::max()) return result;  // the response never rises
  result.sigmoid = best.curve;
  result.r2_sigmoid = 1 - best.squares / all;
  result.aicc_gain =
      aicc(line.squares, x.size(), kLineParameters) - aicc(best.squares, x.size(), kSigmoidParameters);
  if (result.aicc_gain <= kLeastGain) return result;
  const auto below = (x < best.curve.midpoint).count();
  const bool is_bent = below >= kLeastOnASide && x.size() - below >= kLeastOnASide;
  result.verdict = is_bent ? CurveVerdict::sigmoid : CurveVerdict::no_bend;
  return result;
}

}  // namespace facenav::stimulation
