#include "marker_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "edge_profile.h"

namespace facenav::tracking {
namespace {

constexpr int kParameters = 9;  // rotation, translation, size factor, shrink left, shrink right
using Vector9 = Eigen::Matrix<double, kParameters, 1>;
using Matrix9 = Eigen::Matrix<double, kParameters, kParameters>;

constexpr double kSizeSigma = 0.01, kShrinkSigma_px = 0.5;   // what is believed before looking
constexpr double kSpacing_px = 2.0, kFirstSpacing_px = 4.0;  // between edge points; in the first rounds
constexpr double kLongestHalf_px = 4.5, kShortestHalf_px = 1.8;
constexpr double kCornerGap_px = 3.0;  // blur reaches this far round a corner
constexpr double kLeastContrast_grey = 8.0;

struct State {
  Eigen::Isometry3d camera_T_coil;
  double size_factor = 1.0;
  std::array<double, 2> shrink_px{0.0, 0.0};
};

struct Observation {
  double residual_px;  // measured - shrink - predicted
  Vector9 derivative;  // of the prediction
  int image, side;     // side: index of the printed edge over all markers
};

struct Observations {
  std::vector<Observation> list;
  std::array<int, 2> tried{0, 0};
};

/// One image of the pair: its camera and how left-camera coordinates reach it.
struct View {
  const cv::Mat& grey;
  const stereo::CameraModel& camera;
  Eigen::Isometry3d view_T_camera;
};

class EdgeSampler {
 public:
  EdgeSampler(const View& view, int image, const State& state, const Eigen::Vector3d& centre_mm,
              double spacing_px)
      : view_(view), image_(image), state_(state), centre_mm_(centre_mm), spacing_px_(spacing_px) {}

  void sample(const SeenMarker& marker, const PrintedEdge& edge, int side, Observations& observations) const {
    const Eigen::Isometry3d camera_T_marker = state_.camera_T_coil * marker.coil_T_marker.isometry();
    const double size_mm = marker.size_mm * state_.size_factor;
    const Eigen::Matrix<double, 3, 2> plane =
        camera_T_marker.linear().leftCols<2>() * size_mm;  // print -> Camera
    const Eigen::Vector2d along = edge.b - edge.a, black(-along.normalized().y(), along.normalized().x());
    const auto pixel = [&](const Eigen::Vector2d& p) {
      return stereo::project(view_.camera, view_.view_T_camera * (camera_T_marker.translation() + plane * p));
    };
    const double length_px = (pixel(edge.b) - pixel(edge.a)).norm();
    const int count = int((length_px - 2 * kCornerGap_px) / spacing_px_);
    if (count < 2) return;
    for (int i = 0; i < count; ++i) {
      const double t = (kCornerGap_px + (i + 0.5) * (length_px - 2 * kCornerGap_px) / count) / length_px;
      samplePoint(camera_T_marker, plane, edge, edge.a + t * along, along, black, side, observations);
    }
  }

 private:
  void samplePoint(const Eigen::Isometry3d& camera_T_marker, const Eigen::Matrix<double, 3, 2>& plane,
                   const PrintedEdge& edge, const Eigen::Vector2d& print, const Eigen::Vector2d& along,
                   const Eigen::Vector2d& black, int side, Observations& observations) const {
    const Eigen::Vector3d on_print_mm = plane * print, p_mm = camera_T_marker.translation() + on_print_mm;
    Eigen::Matrix<double, 2, 3> jacobian;
    const Eigen::Vector2d at = stereo::project(view_.camera, view_.view_T_camera * p_mm, jacobian);
    jacobian = jacobian * view_.view_T_camera.linear();
    const Eigen::Vector2d tangent = (jacobian * plane * along).normalized(),
                          towards_black = jacobian * plane * black;
    Eigen::Vector2d normal(-tangent.y(), tangent.x());
    if (normal.dot(towards_black) < 0) normal = -normal;
    const double reach_px = 0.45 * std::min(edge.black_depth, edge.white_depth) * normal.dot(towards_black);
    if (reach_px < kShortestHalf_px) return;
    ++observations.tried[image_];
    const auto found =
        locateEdge(view_.grey, at, normal, std::min(reach_px, kLongestHalf_px), kLeastContrast_grey);
    if (!found) return;
    const Eigen::RowVector3d by_point = normal.transpose() * jacobian;
    Observation observation{found->offset_px - state_.shrink_px[image_], Vector9::Zero(), image_, side};
    observation.derivative.head<3>() = (by_point * -skew(p_mm - centre_mm_)).transpose();
    observation.derivative.segment<3>(3) = by_point.transpose();
    observation.derivative[6] = by_point.dot(on_print_mm) / state_.size_factor;
    observation.derivative[7 + image_] = 1.0;
    observations.list.push_back(observation);
  }

  const View& view_;
  int image_;
  const State& state_;
  Eigen::Vector3d centre_mm_;
  double spacing_px_;
};

Eigen::Vector3d centre(const std::vector<SeenMarker>& markers, const Eigen::Isometry3d& camera_T_coil) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const SeenMarker& marker : markers) sum += camera_T_coil * marker.coil_T_marker.translation_mm();
  return sum / double(markers.size());
}

Observations observe(const std::array<View, 2>& views, const std::vector<SeenMarker>& markers,
                     const State& state, double spacing_px) {
  Observations observations;
  const Eigen::Vector3d centre_mm = centre(markers, state.camera_T_coil);
  for (int image = 0; image < 2; ++image) {
    const EdgeSampler sampler(views[image], image, state, centre_mm, spacing_px);
    int side = 0;
    for (const SeenMarker& marker : markers)
      for (const PrintedEdge& edge : marker.pattern->edges())
        sampler.sample(marker, edge, side++, observations);
  }
  return observations;
}

/// Robust spread: 1.48 median |residual|, not below what a clean edge gives.
double spread_px(const std::vector<Observation>& list) {
  std::vector<double> absolute;
  absolute.reserve(list.size());
  for (const auto& o : list) absolute.push_back(std::abs(o.residual_px));
  const auto middle = absolute.begin() + absolute.size() / 2;
  std::nth_element(absolute.begin(), middle, absolute.end());
  return std::max(0.03, 1.4826 * *middle);
}

double tukey(double residual_px, double limit_px) {
  const double u = residual_px / limit_px;
  return std::abs(u) < 1 ? (1 - u * u) * (1 - u * u) : 0.0;
}

struct Normal {
  Matrix9 matrix = Matrix9::Zero();
  Vector9 right = Vector9::Zero();
  double weighted_squares = 0, weight = 0;
};

Normal normalEquations(const std::vector<Observation>& list, const State& state, double sigma_px) {
  Normal normal;
  for (const auto& o : list) {
    const double weight = tukey(o.residual_px, 4.685 * sigma_px);
    if (weight == 0) continue;
    normal.matrix.selfadjointView<Eigen::Lower>().rankUpdate(o.derivative, weight);
    normal.right += weight * o.residual_px * o.derivative;
    normal.weighted_squares += weight * o.residual_px * o.residual_px;
    normal.weight += weight;
  }
  normal.matrix.triangularView<Eigen::StrictlyUpper>() = normal.matrix.transpose();
  // Priors in units of one edge point's variance, as if a clean point had 0.05 px.
  const double variance_px2 = std::max(sigma_px, 0.05) * std::max(sigma_px, 0.05);
  const auto believe = [&](int parameter, double deviation, double sigma) {
    normal.matrix(parameter, parameter) += variance_px2 / (sigma * sigma);
    normal.right[parameter] -= variance_px2 / (sigma * sigma) * deviation;
  };
  believe(6, state.size_factor - 1.0, kSizeSigma);
  believe(7, state.shrink_px[0], kShrinkSigma_px);
  believe(8, state.shrink_px[1], kShrinkSigma_px);
  return normal;
}

State moved(const State& state, const Vector9& step, const Eigen::Vector3d& centre_mm) {
  State next = state;
  const Eigen::Matrix3d rotation = expRotation(step.head<3>());
  next.camera_T_coil.linear() = rotation * state.camera_T_coil.linear();
  next.camera_T_coil.translation() =
      centre_mm + rotation * (state.camera_T_coil.translation() - centre_mm) + step.segment<3>(3);
  next.size_factor += step[6];
  next.shrink_px[0] += step[7];
  next.shrink_px[1] += step[8];
  return next;
}

/// Rms over sides and images of the mean residual of a side with at least 4 points.
double biasOverSides_px(const std::vector<Observation>& list, double limit_px) {
  std::map<int, std::pair<double, int>> sides;
  for (const auto& o : list)
    if (std::abs(o.residual_px) < limit_px) {
      auto& [sum, count] = sides[2 * o.side + o.image];
      sum += o.residual_px;
      ++count;
    }
  double squares = 0;
  int count = 0;
  for (const auto& entry : sides)
    if (entry.second.second >= 4) {
      const double mean = entry.second.first / entry.second.second;
      squares += mean * mean;
      ++count;
    }
  return count > 0 ? std::sqrt(squares / count) : 0.0;
}

bool isEnough(const Observations& observations, int least) {
  std::array<int, 2> found{0, 0};
  for (const auto& o : observations.list) ++found[o.image];
  return found[0] >= least && found[1] >= least;
}

MarkerFit summarise(const Observations& at_end, const State& state, const std::vector<SeenMarker>& markers) {
  const double sigma_px = spread_px(at_end.list);
  const Normal normal = normalEquations(at_end.list, state, sigma_px);
  MarkerFit fit;
  fit.camera_T_coil = RigidTransform<Camera, Coil>::fromIsometry(state.camera_T_coil);
  fit.centre_mm = centre(markers, state.camera_T_coil);
  const double limit_px = 4.685 * sigma_px;
  std::array<int, 2> inliers{0, 0};
  double squares = 0;
  for (const auto& o : at_end.list)
    if (std::abs(o.residual_px) < limit_px) {
      ++inliers[o.image];
      squares += o.residual_px * o.residual_px;
    }
  fit.points = inliers[0] + inliers[1];
  fit.rms_px = std::sqrt(squares / std::max(1, fit.points));
  fit.bias_px = biasOverSides_px(at_end.list, 3.0);
  fit.inlier_fraction = std::min(double(inliers[0]) / std::max(1, at_end.tried[0]),
                                 double(inliers[1]) / std::max(1, at_end.tried[1]));
  // Neighbouring points share pixels and the lens's residual errors: counted as every fourth being
  // independent.
  const double variance_px2 = 4.0 * std::max(fit.rms_px, 0.03) * std::max(fit.rms_px, 0.03);
  fit.covariance = (normal.matrix.inverse() * variance_px2).topLeftCorner<6, 6>();
  fit.size_factor = state.size_factor;
  fit.shrink_left_px = state.shrink_px[0];
  fit.shrink_right_px = state.shrink_px[1];
  return fit;
}

}  // namespace

std::optional<MarkerFit> fitMarkers(const stereo::StereoRig& rig, const stereo::StereoFrame& frame,
                                    const std::vector<SeenMarker>& markers,
                                    const RigidTransform<Camera, Coil>& start) {
  const std::array<View, 2> views{View{frame.left, rig.left, Eigen::Isometry3d::Identity()},
                                  View{frame.right, rig.right, rig.right_T_left.isometry()}};
  State state;
  state.camera_T_coil = start.isometry();
  Observations observations;
  for (int round = 0; round < 8; ++round) {
    const bool is_first = round < 2;
    observations = observe(views, markers, state, is_first ? kFirstSpacing_px : kSpacing_px);
    if (!isEnough(observations, is_first ? 6 : 12)) return std::nullopt;
    const double sigma_px = std::max(spread_px(observations.list), is_first ? 0.3 : 0.03);
    const Normal normal = normalEquations(observations.list, state, sigma_px);
    const Vector9 step = normal.matrix.ldlt().solve(normal.right);
    if (!step.allFinite()) return std::nullopt;
    state = moved(state, step, centre(markers, state.camera_T_coil));
    if (!is_first && step.head<3>().norm() < 5e-5 && step.segment<3>(3).norm() < 5e-3) break;
  }
  observations = observe(views, markers, state, kSpacing_px);
  if (!isEnough(observations, 12)) return std::nullopt;
  return summarise(observations, state, markers);
}

}  // namespace facenav::tracking
