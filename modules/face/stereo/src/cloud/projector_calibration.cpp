#include "facenav/stereo/projector_calibration.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>
#include <optional>
#include <unordered_map>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"

namespace facenav::stereo {
namespace {

constexpr double kMostEpipolar_px = 1.0, kSameCode_px = 1.5;
constexpr std::size_t kFewestPlaces = 200, kMostPlaces = 6000;
constexpr double kFlat =
    0.02;  // least extent relative to the largest: a plane does not determine a projector
constexpr double kOutlierSigmas = 4.0, kLeastOutlier_px = 0.5;
constexpr int kRounds = 4;

/// Index of the right picture by code: one pixel for each projector pixel decoded in it.
class CodeIndex {
 public:
  explicit CodeIndex(const cv::Mat& place) : place_(place) {
    for (int y = 1; y + 1 < place.rows; ++y)
      for (int x = 1; x + 1 < place.cols; ++x)
        if (const cv::Vec2f code = place.at<cv::Vec2f>(y, x); !std::isnan(code[0]))
          pixels_.emplace(key(int(std::lround(code[0])), int(std::lround(code[1]))), cv::Point(x, y));
  }
  /// Place of the code `wanted` in the picture, interpolated between pixels.
  std::optional<Eigen::Vector2d> find(const cv::Vec2f& wanted) const {
    const auto near = nearest(wanted);
    if (!near) return std::nullopt;
    const auto at = [&](int dx, int dy) { return place_.at<cv::Vec2f>(near->y + dy, near->x + dx); };
    const cv::Vec2f here = at(0, 0), along = 0.5F * (at(1, 0) - at(-1, 0)),
                    down = 0.5F * (at(0, 1) - at(0, -1));
    const float determinant = along[0] * down[1] - along[1] * down[0];
    if (!(std::abs(determinant) > 1e-3F)) return std::nullopt;  // also true for a NaN neighbour
    const cv::Vec2f miss = wanted - here;
    const float dx = (miss[0] * down[1] - miss[1] * down[0]) / determinant,
                dy = (along[0] * miss[1] - along[1] * miss[0]) / determinant;
    if (std::abs(dx) > 1.5F || std::abs(dy) > 1.5F) return std::nullopt;
    return Eigen::Vector2d(near->x + double(dx), near->y + double(dy));
  }

 private:
  static std::int64_t key(int x, int y) { return (std::int64_t(y) << 20) + x; }
  std::optional<cv::Point> nearest(const cv::Vec2f& wanted) const {
    const int x = int(std::lround(wanted[0])), y = int(std::lround(wanted[1]));
    std::optional<cv::Point> best;
    double least = kSameCode_px;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        if (const auto found = pixels_.find(key(x + dx, y + dy)); found != pixels_.end()) {
          const double distance = cv::norm(place_.at<cv::Vec2f>(found->second) - wanted);
          if (distance < least) {
            least = distance;
            best = found->second;
          }
        }
    return best;
  }

  const cv::Mat& place_;
  std::unordered_map<std::int64_t, cv::Point> pixels_;
};

using Matrix34d = Eigen::Matrix<double, 3, 4>;

/// Linear fit of a projection to normalised places (Hartley and Zisserman, 7.1).
Matrix34d linearProjection(const std::vector<LitPlace>& places) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const auto& place : places) middle += place.point.mm / double(places.size());
  double spread = 0, width = 1;
  for (const auto& place : places) {
    spread += (place.point.mm - middle).norm() / double(places.size());
    width = std::max(width, place.projector_px.cwiseAbs().maxCoeff());
  }
  Eigen::Matrix<double, 12, 12> normal = Eigen::Matrix<double, 12, 12>::Zero();
  for (const auto& place : places) {
    Eigen::Vector4d p;
    p << (place.point.mm - middle) / spread, 1.0;
    const Eigen::Vector2d q = place.projector_px / width;
    Eigen::Matrix<double, 2, 12> rows = Eigen::Matrix<double, 2, 12>::Zero();
    rows.block<1, 4>(0, 0) = p.transpose();
    rows.block<1, 4>(0, 8) = -q.x() * p.transpose();
    rows.block<1, 4>(1, 4) = p.transpose();
    rows.block<1, 4>(1, 8) = -q.y() * p.transpose();
    normal += rows.transpose() * rows;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 12, 12>> solver(normal);
  const Eigen::Matrix<double, 12, 1> solution = solver.eigenvectors().col(0);
  Matrix34d scaled;
  for (int row = 0; row < 3; ++row) scaled.row(row) = solution.segment<4>(4 * row).transpose();
  Eigen::Matrix4d to_normal = Eigen::Matrix4d::Identity();
  to_normal.topLeftCorner<3, 3>() /= spread;
  to_normal.topRightCorner<3, 1>() = -middle / spread;
  Matrix34d projection = Eigen::DiagonalMatrix<double, 3>(width, width, 1.0) * scaled * to_normal;
  if ((projection * middle.homogeneous()).z() < 0) projection *= -1;
  return projection;
}

struct FittedLens {
  cv::Mat k, distortion;
  cv::Vec3d turn, shift;
  std::vector<double> errors_px;  // errors of all places
};

double pixelError(const FittedLens& lens, const LitPlace& place) {
  std::vector<cv::Point2d> seen;
  const Eigen::Vector3d& p = place.point.mm;
  cv::projectPoints(std::vector<cv::Point3d>{{p.x(), p.y(), p.z()}}, lens.turn, lens.shift, lens.k,
                    lens.distortion, seen);
  return std::hypot(seen[0].x - place.projector_px.x(), seen[0].y - place.projector_px.y());
}

FittedLens fitted(const std::vector<LitPlace>& places, const ProjectorCode& code) {
  std::vector<cv::Point3f> points;
  std::vector<cv::Point2f> pixels;
  for (const auto& place : places) {
    points.emplace_back(float(place.point.mm.x()), float(place.point.mm.y()), float(place.point.mm.z()));
    pixels.emplace_back(float(place.projector_px.x()), float(place.projector_px.y()));
  }
  cv::Mat projection, k, rotation, centre;
  cv::eigen2cv(linearProjection(places), projection);
  cv::decomposeProjectionMatrix(projection, k, rotation, centre);
  k /= k.at<double>(2, 2);
  k.at<double>(0, 1) = 0;
  if (!(k.at<double>(0, 0) > 0 && k.at<double>(1, 1) > 0)) throw ProjectorMisfit();
  FittedLens lens{k, cv::Mat::zeros(1, 5, CV_64F), {}, {}, {}};
  std::vector<cv::Mat> turns, shifts;
  cv::calibrateCamera(
      std::vector<std::vector<cv::Point3f>>{points}, std::vector<std::vector<cv::Point2f>>{pixels},
      {code.width_px, code.height_px}, lens.k, lens.distortion, turns, shifts,
      cv::CALIB_USE_INTRINSIC_GUESS | cv::CALIB_FIX_K2 | cv::CALIB_FIX_K3 | cv::CALIB_ZERO_TANGENT_DIST);
  lens.turn = cv::Vec3d(turns[0].ptr<double>());
  lens.shift = cv::Vec3d(shifts[0].ptr<double>());
  return lens;
}

double rmsOfErrors(const std::vector<double>& errors_px) {
  double squares = 0;
  for (const double error : errors_px) squares += error * error;
  return std::sqrt(squares / double(std::max<std::size_t>(1, errors_px.size())));
}

std::vector<LitPlace> thinned(const std::vector<LitPlace>& places, std::size_t most) {
  const std::size_t step = std::max<std::size_t>(1, (places.size() + most - 1) / most);
  std::vector<LitPlace> some;
  for (std::size_t i = 0; i < places.size(); i += step) some.push_back(places[i]);
  return some;
}

void requireDepth(const std::vector<LitPlace>& places) {
  if (places.size() < kFewestPlaces)
    throw Error(formatted("only %zu places are lit by the projector and seen by both cameras", places.size()),
                "", "let it light what both cameras see, and dim the room");
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const auto& place : places) middle += place.point.mm / double(places.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const auto& place : places)
    spread += (place.point.mm - middle) * (place.point.mm - middle).transpose() / double(places.size());
  const Eigen::Vector3d sizes =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvalues().cwiseMax(0).cwiseSqrt();
  if (sizes(0) < kFlat * sizes(2))
    throw Error("all places lie in one plane: that does not determine the projector", "",
                "add the plane at another distance, or light something with depth, a face");
}

}  // namespace

std::vector<LitPlace> matchCodes(const cameras::StereoRig& rig, const DecodedCode& left,
                                 const DecodedCode& right, int step_px) {
  const CodeIndex index(right.place);
  std::vector<LitPlace> places;
  for (int y = 0; y < left.place.rows; y += step_px)
    for (int x = 0; x < left.place.cols; x += step_px) {
      const cv::Vec2f code = left.place.at<cv::Vec2f>(y, x);
      if (std::isnan(code[0])) continue;
      const auto right_px = index.find(code);
      if (!right_px) continue;
      LitPlace place;
      place.left_px = {double(x), double(y)};
      place.right_px = *right_px;
      place.projector_px = {double(code[0]), double(code[1])};
      place.epipolar_px = cameras::epipolarError_px(rig, place.left_px, place.right_px);
      if (place.epipolar_px > kMostEpipolar_px) continue;
      place.point = cameras::triangulate(rig, place.left_px, place.right_px);
      if (place.point.mm.z() > 0) places.push_back(place);
    }
  return places;
}

ProjectorCalibration calibrateProjector(const std::vector<LitPlace>& all, const ProjectorCode& code) {
  requireDepth(all);
  std::vector<LitPlace> used, held_out;
  const auto some = thinned(all, 2 * kMostPlaces);
  for (std::size_t i = 0; i < some.size(); ++i) (i % 4 == 3 ? held_out : used).push_back(some[i]);
  FittedLens lens;
  const std::size_t given = used.size();
  for (int round = 0; round < kRounds; ++round) {
    lens = fitted(used, code);
    std::vector<double> errors_px;
    for (const auto& place : used) errors_px.push_back(pixelError(lens, place));
    std::vector<double> sorted = errors_px;
    std::nth_element(sorted.begin(), sorted.begin() + std::ptrdiff_t(sorted.size() / 2), sorted.end());
    const double limit_px = std::max(kLeastOutlier_px, kOutlierSigmas * sorted[sorted.size() / 2]);
    std::vector<LitPlace> kept;
    lens.errors_px.clear();
    for (std::size_t i = 0; i < used.size(); ++i)
      if (errors_px[i] <= limit_px) {
        kept.push_back(used[i]);
        lens.errors_px.push_back(errors_px[i]);
      }
    if (kept.size() == used.size()) break;
    used = std::move(kept);
  }
  ProjectorCalibration result;
  result.places = int(used.size());
  result.left_out = int(given - used.size());
  result.rms_px = rmsOfErrors(lens.errors_px);
  std::vector<double> other_px;
  for (const auto& place : held_out) other_px.push_back(pixelError(lens, place));
  std::sort(other_px.begin(), other_px.end());
  if (!other_px.empty()) result.held_out_px = other_px[other_px.size() / 2];
  const auto [near, far] = std::minmax_element(
      used.begin(), used.end(), [](const auto& a, const auto& b) { return a.point.mm.z() < b.point.mm.z(); });
  result.nearest_mm = near->point.mm.z();
  result.farthest_mm = far->point.mm.z();
  auto& model = result.projector;
  model.width_px = code.width_px;
  model.height_px = code.height_px;
  lens.k.copyTo(model.lens.k);
  model.lens.distortion = lens.distortion.reshape(1, 1).clone();
  cv::Matx33d rotation;
  cv::Rodrigues(lens.turn, rotation);
  Eigen::Matrix3d r;
  cv::cv2eigen(rotation, r);
  model.projector_T_camera = RigidTransform<Projector, Camera>(
      Eigen::Quaterniond(r), Eigen::Vector3d(lens.shift[0], lens.shift[1], lens.shift[2]));
  return result;
}

}  // namespace facenav::stereo
