#include "marker_edges.h"

#include <algorithm>
#include <cmath>

#include "edge_filter.h"
#include "facenav/core/robust_statistics.h"

namespace facenav::coil_tracking {
namespace {

constexpr double kCornerGap_px = 1.5;  // reach of the blur round a corner, besides the taps of a slanted row
constexpr double kLeastLength_px = 3.0;
constexpr double kNoise_grey = 2.0;     // of a common camera: reduces the weight of edges with low contrast
constexpr double kFloor_px = 0.02;      // error left by lens and print without any noise
constexpr double kFirstSigma_px = 0.4;  // error of an edge found by search

/// One image with its camera, at the state's pose.
struct Sight {
  const cv::Mat& grey;
  const cameras::CameraModel& camera;
  Eigen::Isometry3d view_T_camera;
  Eigen::Vector3d pitch_axis;  // pitch axis of the right camera; zero for the left image
  int image;
};

/// The coil's motion during the picture, with constant velocity.
struct RowMotion {
  Eigen::Vector3d turning, moving_mm, origin_mm;  // rad/s; mm/s, of the origin; Camera
  bool is_resting;

  Eigen::Vector3d velocity_mm_s(const Eigen::Vector3d& p_mm) const {
    return moving_mm + turning.cross(p_mm - origin_mm);
  }
  static double belowMiddle(const Sight& sight, double row) { return row - 0.5 * (sight.grey.rows - 1); }
  /// Position of a point at the exposure of its own row, from its position at the middle row's.
  Eigen::Vector3d seenIn(const Sight& sight, const Eigen::Vector3d& p_mm) const {
    constexpr int kRounds = 2;  // the second changes 300 mm/s at 50 us a row by 0.05 mm
    if (is_resting || sight.camera.row_time_s == 0.0) return p_mm;
    const Eigen::Vector3d by_row_mm = sight.camera.row_time_s * velocity_mm_s(p_mm);
    Eigen::Vector3d seen_mm = p_mm;
    for (int round = 0; round < kRounds; ++round) {
      const double row = cameras::project(sight.camera, sight.view_T_camera * seen_mm).y();
      seen_mm = p_mm + belowMiddle(sight, row) * by_row_mm;
    }
    return seen_mm;
  }
};

/// The marker's plane at the state's pose: print (unit squares) -> Camera.
struct Plane {
  Eigen::Vector3d origin_mm;
  Eigen::Matrix<double, 3, 2> axes_mm;
  Eigen::Vector3d at(const Eigen::Vector2d& print) const { return origin_mm + axes_mm * print; }
};

struct Knot {
  Eigen::Vector2d px, normal;
  FitVector derivative;
  double by_row_time;  // px/s
};

class LineSampler {
 public:
  LineSampler(const Sight& sight, const RowMotion& motion, const FitState& state,
              const EdgeSampling& sampling, const Eigen::Vector3d& centre_mm, MarkerEdges& edges)
      : sight_(sight),
        motion_(motion),
        state_(state),
        sampling_(sampling),
        centre_mm_(centre_mm),
        edges_(edges) {}

  void sample(const Plane& plane, const PrintedEdge& edge) {
    const Eigen::Vector2d first = pixel(plane.at(edge.a)), last = pixel(plane.at(edge.b));
    const double length_px = (last - first).norm();
    if (!(length_px > 2 * kCornerGap_px + kLeastLength_px)) return;
    const Eigen::Vector2d along = edge.b - edge.a,
                          into_black = Eigen::Vector2d(-along.y(), along.x()).normalized();
    const Eigen::Vector2d normal(-(last - first).y() / length_px, (last - first).x() / length_px);
    const double depth = 0.5 * std::min(edge.black_depth, edge.white_depth);
    const double reach_px = std::abs(normal.dot(pixel(plane.at(edge.a + depth * into_black)) - first));
    const auto taps = tapsFor(normal, reach_px, length_px);
    if (!taps) return;
    const double gap = (kCornerGap_px + *taps * normal.cwiseAbs().minCoeff()) / length_px;
    const Eigen::Vector2d start = edge.a + gap * along, span = (1 - 2 * gap) * along;
    for (int i = 0; i < 3; ++i) knots_[i] = knot(plane, start + 0.5 * i * span, span, into_black);
    beginLine();
    walk(*taps);
  }

 private:
  Eigen::Vector2d pixel(const Eigen::Vector3d& p_mm) const {
    return cameras::project(sight_.camera, sight_.view_T_camera * motion_.seenIn(sight_, p_mm));
  }

  /// The largest number of taps that the print and the edge's length allow. The window of a slanted row also
  /// runs along the edge.
  static std::optional<int> tapsFor(const Eigen::Vector2d& normal, double reach_px, double length_px) {
    const double across = normal.cwiseAbs().maxCoeff(), along = normal.cwiseAbs().minCoeff();
    int taps = std::min(kMostTaps, int(reach_px / across));
    while (taps > kFewestTaps && length_px - 2 * (kCornerGap_px + taps * along) < kLeastLength_px) --taps;
    if (taps < kFewestTaps || length_px - 2 * (kCornerGap_px + taps * along) < kLeastLength_px)
      return std::nullopt;
    return taps;
  }

  Knot knot(const Plane& plane, const Eigen::Vector2d& print, const Eigen::Vector2d& span,
            const Eigen::Vector2d& into_black) {
    const Eigen::Vector3d p_mm = plane.at(print), q_mm = sight_.view_T_camera * motion_.seenIn(sight_, p_mm);
    Eigen::Matrix<double, 2, 3> by_view;
    Knot made;
    made.px = cameras::project(sight_.camera, q_mm, by_view);
    const Eigen::Matrix<double, 2, 3> by_point = by_view * sight_.view_T_camera.linear();
    const Eigen::Vector2d tangent = (by_point * (plane.axes_mm * span)).normalized(),
                          towards_black = by_point * (plane.axes_mm * into_black);
    made.normal = {-tangent.y(), tangent.x()};
    if (made.normal.dot(towards_black) < 0) made.normal = -made.normal;
    const Eigen::RowVector3d n = made.normal.transpose() * by_point;
    made.derivative.setZero();
    made.derivative.head<3>() = (p_mm - centre_mm_).cross(n.transpose());
    made.derivative.segment<3>(3) = n.transpose();
    made.derivative[kSize] = n.dot(p_mm - plane.origin_mm) / state_.size_factor;
    made.derivative[kShrink + sight_.image] = 1.0;
    made.by_row_time = motion_.is_resting
                           ? 0.0
                           : RowMotion::belowMiddle(sight_, made.px.y()) * n.dot(motion_.velocity_mm_s(p_mm));
    if (sight_.image == 1) {
      const Eigen::RowVector3d n_view = made.normal.transpose() * by_view;
      made.derivative[kPitch] = n_view.dot(sight_.pitch_axis.cross(q_mm));
      made.derivative[kRoll] = n_view.dot(Eigen::Vector3d::UnitZ().cross(q_mm));
    }
    return made;
  }

  void beginLine() {
    EdgeLine line;
    line.image = sight_.image;
    const auto &g0 = knots_[0].derivative, &g1 = knots_[1].derivative, &g2 = knots_[2].derivative;
    line.derivative << g0, -3 * g0 + 4 * g1 - g2, 2 * g0 - 4 * g1 + 2 * g2;
    const double r0 = knots_[0].by_row_time, r1 = knots_[1].by_row_time, r2 = knots_[2].by_row_time;
    line.by_row_time << r0, -3 * r0 + 4 * r1 - r2, 2 * r0 - 4 * r1 + 2 * r2;
    edges_.lines.push_back(line);
  }

  /// Visits every stride-th row (or column) that crosses the edge.
  void walk(int taps) {
    const bool is_by_row = std::abs(knots_[1].normal.x()) >= std::abs(knots_[1].normal.y());
    const int along = is_by_row ? 1 : 0, across = 1 - along;
    const double across_by_normal = std::abs(knots_[1].normal[across]);
    const double p0 = knots_[0].px[along], p1 = knots_[1].px[along], p2 = knots_[2].px[along];
    const double linear = -3 * p0 + 4 * p1 - p2, square = 2 * p0 - 4 * p1 + 2 * p2;
    const int low = int(std::ceil(std::min(p0, p2))), high = int(std::floor(std::max(p0, p2)));
    EdgeLine& line = edges_.lines.back();
    weights_ = &edgeWeights(taps, sampling_.blur_px[sight_.image] / across_by_normal);
    for (int row = low; row <= high; row += sampling_.stride_px) {
      double t = (row - p0) / (p2 - p0);
      t -= (p0 + t * (linear + t * square) - row) / (linear + 2 * t * square);
      if (!(t >= 0 && t <= 1)) continue;
      const double c0 = knots_[0].px[across], c1 = knots_[1].px[across], c2 = knots_[2].px[across];
      const double place = c0 + t * ((-3 * c0 + 4 * c1 - c2) + t * (2 * c0 - 4 * c1 + 2 * c2));
      measure(line, is_by_row, row, place, t, taps);
    }
  }

  void measure(EdgeLine& line, bool is_by_row, int row, double place, double t, int taps) {
    const cv::Mat& grey = sight_.grey;
    const int reach = sampling_.search_px > 0 ? sampling_.search_px + 4 : taps + 1;
    const int rows = is_by_row ? grey.rows : grey.cols, length = is_by_row ? grey.cols : grey.rows;
    if (row < 0 || row >= rows || !(place >= reach && place < length - reach)) return;
    ++line.tried;
    const Eigen::Vector2d normal = (1 - t) * knots_[0].normal + t * knots_[2].normal;
    const double by_normal = is_by_row ? normal.x() : normal.y();
    const std::uint8_t* first = is_by_row ? grey.ptr(row) : grey.ptr(0) + row;
    const std::ptrdiff_t step = is_by_row ? 1 : std::ptrdiff_t(grey.step[0]);
    const auto found =
        sampling_.search_px > 0
            ? searchEdge(first, step, place, by_normal > 0, sampling_.search_px, kSignificant * kNoise_grey)
            : locateEdge(*weights_, first, step, place, by_normal > 0, kSignificant * kNoise_grey);
    if (!found) return;
    ++line.found;
    const double shrink_px = state_.shrink_px[sight_.image];
    const double noise_px = 1.7 * kNoise_grey / found->contrast;
    const double sigma_px =
        sampling_.search_px > 0 ? kFirstSigma_px : std::sqrt(kFloor_px * kFloor_px + noise_px * noise_px);
    edges_.samples.push_back(
        {int(edges_.lines.size()) - 1, t, found->offset_px * by_normal - shrink_px, sigma_px});
  }

  const Sight& sight_;
  const RowMotion& motion_;
  const FitState& state_;
  const EdgeSampling& sampling_;
  const Eigen::Vector3d& centre_mm_;
  MarkerEdges& edges_;
  std::array<Knot, 3> knots_;
  const EdgeWeights* weights_ = nullptr;
};

bool isOutline(const PrintedEdge& edge) {
  const auto isOnRim = [](double a, double b) { return a == b && std::abs(a) == 0.5; };
  return isOnRim(edge.a.x(), edge.b.x()) || isOnRim(edge.a.y(), edge.b.y());
}

}  // namespace

Eigen::Vector3d centreOf(const std::vector<SeenMarker>& markers, const Eigen::Isometry3d& camera_T_coil) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const SeenMarker& marker : markers) sum += camera_T_coil * marker.coil_T_marker.translation_mm();
  return sum / double(markers.size());
}

Eigen::Vector3d pitchAxis(const cameras::StereoRig& rig, const Eigen::Vector3d& centre_mm) {
  // A rotation about the axis that is perpendicular to the viewing ray and lies in the epipolar plane moves
  // the image of the centre straight across the epipolar line.
  const Eigen::Vector3d ray = (rig.right_T_left.isometry() * centre_mm).normalized();
  const Eigen::Vector3d across = ray.cross(rig.right_T_left.translation_mm()).normalized();
  return across.cross(ray);
}

Eigen::Isometry3d rightFromLeft(const cameras::StereoRig& rig, const FitState& state,
                                const Eigen::Vector3d& centre_mm) {
  const Eigen::Vector3d turn =
      state.pitch_rad * pitchAxis(rig, centre_mm) + state.roll_rad * Eigen::Vector3d::UnitZ();
  return expRotation(turn) * rig.right_T_left.isometry();
}

void measureEdges(const EdgeView& view, const std::vector<SeenMarker>& markers, const FitState& state,
                  const EdgeSampling& sampling, MarkerEdges& edges) {
  edges.lines.clear();
  edges.samples.clear();
  edges.tried = edges.found = {0, 0};
  const Eigen::Vector3d centre_mm = centreOf(markers, state.camera_T_coil);
  const std::array<Sight, 2> sights{
      Sight{view.frame.left, view.rig.left, Eigen::Isometry3d::Identity(), Eigen::Vector3d::Zero(), 0},
      Sight{view.frame.right, view.rig.right, rightFromLeft(view.rig, state, centre_mm),
            pitchAxis(view.rig, centre_mm), 1}};
  const RowMotion motion{view.motion.velocity.head<3>(), view.motion.velocity.tail<3>(),
                         state.camera_T_coil.translation(), view.motion.isResting()};
  for (const Sight& sight : sights) {
    LineSampler sampler(sight, motion, state, sampling, centre_mm, edges);
    for (const SeenMarker& marker : markers) {
      const Eigen::Isometry3d pose = state.camera_T_coil * marker.coil_T_marker.isometry();
      const Plane plane{pose.translation(),
                        pose.linear().leftCols<2>() * (marker.size_mm * state.size_factor)};
      for (const PrintedEdge& edge : marker.pattern->edges())
        if (!sampling.is_outline_only || isOutline(edge)) sampler.sample(plane, edge);
    }
  }
  for (const EdgeLine& line : edges.lines) {
    edges.tried[line.image] += line.tried;
    edges.found[line.image] += line.found;
  }
}

}  // namespace facenav::coil_tracking
