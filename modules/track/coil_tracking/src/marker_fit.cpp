#include "marker_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "facenav/core/robust_statistics.h"

namespace facenav::coil_tracking {
namespace {

// Priors of the fit. Those of pitch and roll are wide, because both are measured here.
constexpr double kSizeSigma = 0.01;
constexpr double kCalibratedRoll_rad = 3.5e-4;          // error of roll after a good calibration
constexpr double kLeastScale = 1.0, kFirstScale = 2.0;  // robust scale in sigmas of an edge point
constexpr int kFewestPoints = 8;                        // in each image
constexpr int kFirstStride_px = 4, kFinestStride_px = 2, kMostPoints = 2400;
constexpr int kPointsPerComparison = 6;

double tukey(double u) { return std::abs(u) < 1 ? (1 - u * u) * (1 - u * u) : 0.0; }

/// Robust spread of the residuals in their sigmas: 1.48 median |residual|.
double spread(const std::vector<EdgeSample>& samples) {
  std::vector<float> absolute;
  absolute.reserve(samples.size());
  for (const auto& s : samples) absolute.push_back(float(std::abs(s.residual_px) / s.sigma_px));
  return kSigmaPerMad * double(upperMedian(std::move(absolute)));
}

/// Sums over one edge: powers of t with weight, and residuals.
struct Moments {
  std::array<double, 5> t{};
  Eigen::Vector3d residual = Eigen::Vector3d::Zero();
  Eigen::Matrix3d hankel() const {
    Eigen::Matrix3d sums;
    sums << t[0], t[1], t[2], t[1], t[2], t[3], t[2], t[3], t[4];
    return sums;
  }
};

struct Normal {
  FitMatrix matrix = FitMatrix::Zero();
  FitVector right = FitVector::Zero();
};

void addPriors(const FitState& state, double scale, Normal& normal) {
  const auto believe = [&](int parameter, double deviation, double sigma) {
    const double weight = scale * scale / (sigma * sigma);
    normal.matrix(parameter, parameter) += weight;
    normal.right[parameter] -= weight * deviation;
  };
  believe(kSize, state.size_factor - 1.0, kSizeSigma);
  believe(kShrink, state.shrink_px[0], kShrinkSigma_px);
  believe(kShrink + 1, state.shrink_px[1], kShrinkSigma_px);
  believe(kPitch, state.pitch_rad, kTurnSigma_rad);
  believe(kRoll, state.roll_rad, kTurnSigma_rad);
}

/// Sums of each line; `scale`: spread of the residuals in their sigmas.
std::vector<Moments> momentsOf(const MarkerEdges& edges, double scale) {
  std::vector<Moments> moments(edges.lines.size());
  for (const EdgeSample& s : edges.samples) {
    const double weight =
        tukey(s.residual_px / (kTukeyReach * scale * s.sigma_px)) / (s.sigma_px * s.sigma_px);
    if (weight == 0) continue;
    Moments& m = moments[s.line];
    double power = weight;
    for (int k = 0; k < 5; ++k, power *= s.t) {
      m.t[k] += power;
      if (k < 3) m.residual[k] += power * s.residual_px;
    }
  }
  return moments;
}

/// Weighted normal equations.
Normal normalEquations(const MarkerEdges& edges, const FitState& state, double scale) {
  const std::vector<Moments> moments = momentsOf(edges, scale);
  Normal normal;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    if (moments[i].t[0] == 0) continue;
    const Eigen::Matrix3d hankel = moments[i].hankel();
    const auto& derivative = edges.lines[i].derivative;
    const Eigen::Matrix<double, kFitParameters, 3> weighted = derivative.lazyProduct(hankel);
    normal.matrix += weighted.lazyProduct(derivative.transpose());
    normal.right += derivative.lazyProduct(moments[i].residual);
  }
  addPriors(state, scale, normal);
  return normal;
}

/// `normal`: equations of the same edges. `variance`: of a residual of one sigma.
RowTimeEquations rowTimeEquations(const MarkerEdges& edges, const Normal& normal, double scale,
                                  double variance) {
  const std::vector<Moments> moments = momentsOf(edges, scale);
  RowTimeEquations row_times;
  Eigen::Matrix<double, kFitParameters, 2> shared = Eigen::Matrix<double, kFitParameters, 2>::Zero();
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const EdgeLine& line = edges.lines[i];
    const Eigen::Vector3d weighted = moments[i].hankel() * line.by_row_time;
    row_times.information(line.image, line.image) += weighted.dot(line.by_row_time);
    row_times.right[line.image] += moments[i].residual.dot(line.by_row_time);
    shared.col(line.image) += line.derivative * weighted;
  }
  const Eigen::Matrix<double, kFitParameters, 2> absorbed = normal.matrix.ldlt().solve(shared);
  row_times.information -= shared.transpose() * absorbed;
  row_times.right -= absorbed.transpose() * normal.right;
  row_times.information /= variance;
  row_times.right /= variance;
  return row_times;
}

FitState moved(const FitState& state, const FitVector& step, const Eigen::Vector3d& centre_mm) {
  FitState next = state;
  const Eigen::Matrix3d rotation = expRotation(step.head<3>());
  next.camera_T_coil.linear() = rotation * state.camera_T_coil.linear();
  next.camera_T_coil.translation() =
      centre_mm + rotation * (state.camera_T_coil.translation() - centre_mm) + step.segment<3>(3);
  next.size_factor += step[kSize];
  next.shrink_px[0] += step[kShrink];
  next.shrink_px[1] += step[kShrink + 1];
  next.pitch_rad += step[kPitch];
  next.roll_rad += step[kRoll];
  return next;
}

struct EdgeMean {
  double sum_px = 0;
  int count = 0;
};

/// Rms, over edges and images, of the mean residual of an edge with at least 3 points within `limit` sigmas,
/// corrected for the number of fitted parameters; and the mean number of points of such an edge.
std::pair<double, double> biasOfEdges(const MarkerEdges& edges, double limit) {
  std::vector<EdgeMean> means(edges.lines.size());
  for (const auto& s : edges.samples)
    if (std::abs(s.residual_px) < limit * s.sigma_px) {
      means[s.line].sum_px += s.residual_px;
      ++means[s.line].count;
    }
  double squares = 0, points = 0;
  int count = 0;
  for (const EdgeMean& mean : means)
    if (mean.count >= 3) {
      squares += mean.sum_px * mean.sum_px / (double(mean.count) * mean.count);
      points += mean.count;
      ++count;
    }
  if (count == 0) return {0.0, 1.0};
  const double freedom = count > kFitParameters + 2 ? double(count - kFitParameters) / count : 0.3;
  return {std::sqrt(squares / count / freedom), points / count};
}

/// Conditions the state on the calibration: the linear Gaussian update by the observation "roll = 0 +- error
/// of a good calibration". Pitch is measured so well that such a prior of it has no effect.
void conditionOnCalibration(const Eigen::Vector3d& centre_mm, FitMatrix& covariance, FitState& state) {
  const FitVector gain =
      covariance.col(kRoll) / (covariance(kRoll, kRoll) + kCalibratedRoll_rad * kCalibratedRoll_rad);
  const Eigen::Matrix<double, 1, kFitParameters> row = covariance.row(kRoll);
  covariance -= gain * row;
  state = moved(state, -gain * state.roll_rad, centre_mm);
}

bool isEnough(const MarkerEdges& edges, int least) {
  return edges.found[0] >= least && edges.found[1] >= least;
}

void countInliers(const MarkerEdges& edges, double limit, MarkerFit& fit) {
  std::array<int, 2> inliers{0, 0};
  double squares = 0;
  for (const auto& s : edges.samples)
    if (std::abs(s.residual_px) < limit * s.sigma_px) {
      ++inliers[edges.lines[s.line].image];
      squares += s.residual_px * s.residual_px;
    }
  fit.points = inliers[0] + inliers[1];
  fit.rms_px = std::sqrt(squares / std::max(1, fit.points));
  fit.inlier_fraction = std::min(double(inliers[0]) / std::max(1, edges.tried[0]),
                                 double(inliers[1]) / std::max(1, edges.tried[1]));
}

MarkerFit summarise(const EdgeView& view, const MarkerEdges& edges, const FitState& state,
                    const std::vector<SeenMarker>& markers) {
  MarkerFit fit;
  const double scale = std::max(kLeastScale, spread(edges.samples));
  countInliers(edges, kTukeyReach * scale, fit);
  fit.bias_px = biasOfEdges(edges, 1e9).first;
  const auto [bias_px, points_of_edge] = biasOfEdges(edges, kTukeyReach * scale);
  const Normal normal = normalEquations(edges, state, scale);
  // Neighbouring points share the errors of lens, print and light at their edge. The spread of the edges'
  // means shows their size.
  const double mean_sigma_px = std::max(0.02, fit.rms_px);
  const double variance =
      std::max(scale * scale, points_of_edge * std::pow(scale * bias_px / mean_sigma_px, 2));
  FitMatrix covariance = normal.matrix.inverse() * variance;
  if (!view.motion.isResting()) fit.row_times = rowTimeEquations(edges, normal, scale, variance);
  fit.free_state = state;
  fit.centre_mm = centreOf(markers, state.camera_T_coil);
  fit.pitch_rad = state.pitch_rad;
  fit.roll_rad = state.roll_rad;
  fit.pitch_sigma_rad = std::sqrt(covariance(kPitch, kPitch));
  fit.roll_sigma_rad = std::sqrt(covariance(kRoll, kRoll));
  FitState conditioned = state;
  conditionOnCalibration(fit.centre_mm, covariance, conditioned);
  fit.camera_T_coil = RigidTransform<Camera, Coil>::fromIsometry(conditioned.camera_T_coil);
  fit.centre_mm = centreOf(markers, conditioned.camera_T_coil);
  fit.covariance = covariance.topLeftCorner<6, 6>();
  fit.size_factor = conditioned.size_factor;
  fit.size_sigma = std::sqrt(covariance(kSize, kSize));
  fit.shrink_px = conditioned.shrink_px;
  return fit;
}

/// One Gauss-Newton step from `edges`, measured at `state`. Returns nothing with too few points or no
/// solution.
std::optional<FitVector> improve(const std::vector<SeenMarker>& markers, const MarkerEdges& edges,
                                 int fewest_points, double least_scale, FitState& state) {
  if (!isEnough(edges, fewest_points)) return std::nullopt;
  const Normal normal = normalEquations(edges, state, std::max(least_scale, spread(edges.samples)));
  const FitVector step = normal.matrix.ldlt().solve(normal.right);
  if (!step.allFinite() || step.head<3>().norm() > 1.0) return std::nullopt;
  state = moved(state, step, centreOf(markers, state.camera_T_coil));
  return step;
}

/// Work in patch comparisons that take the same time (frame_work.h).
int workOf(const MarkerEdges& edges) {
  // A line's three knots take as long as points.
  return (edges.tried[0] + edges.tried[1] + 3 * int(edges.lines.size())) / kPointsPerComparison;
}

/// Limits the points of large or many prints: more would take time without improving the pose.
int strideFor(const MarkerEdges& edges_of_first) {
  const int points_at_1_px = kFirstStride_px * (edges_of_first.tried[0] + edges_of_first.tried[1]);
  return std::max(kFinestStride_px, (points_at_1_px + kMostPoints - 1) / kMostPoints);
}

}  // namespace

std::optional<OutlineFit> fitOutlines(const EdgeView& view, const std::vector<SeenMarker>& markers,
                                      const FitStart& start, FrameWork& work) {
  OutlineFit fit;
  fit.state = start.state;
  MarkerEdges edges;
  for (int search_px = start.search_px; search_px >= 2; search_px = search_px > 4 ? 4 : search_px - 2) {
    measureEdges(view, markers, fit.state, {6, true, search_px, {}}, edges);
    work.comparisons += workOf(edges);
    if (!improve(markers, edges, kFewestPoints, kFirstScale, fit.state)) return std::nullopt;
  }
  fit.spread = spread(edges.samples);
  return fit;
}

std::optional<MarkerFit> fitMarkers(const EdgeView& view, const std::vector<SeenMarker>& markers,
                                    const FitState& start, FrameWork& work) {
  FitState state = start;
  MarkerEdges edges;
  int stride_px = kFirstStride_px;
  for (int round = 0; round < 8; ++round) {
    const bool is_first = round < 1;
    measureEdges(view, markers, state, {stride_px, false, 0, {0.8, 0.8}}, edges);
    work.comparisons += workOf(edges);
    if (is_first) stride_px = strideFor(edges);
    const auto step = improve(markers, edges, kFewestPoints, is_first ? kFirstScale : kLeastScale, state);
    if (!step) return std::nullopt;
    if (!is_first && step->head<3>().norm() < 2e-4 && step->segment<3>(3).norm() < 0.02) break;
  }
  return summarise(view, edges, state, markers);
}

}  // namespace facenav::coil_tracking
