#include "facenav/health/rig_monitor.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "facenav/cameras/rig_motion.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/geometry/normal_equations.h"
#include "relative_pose.h"

namespace facenav::health {
namespace {

constexpr double kColumns = 6, kRows = 4, kDepthBand_mm = 100;
constexpr std::size_t kMemory = 60;  // samples of a cell; the oldest are overwritten
constexpr double kFewest = 12;       // samples before a verdict is given
constexpr double kGross_px = 20;     // a wrong match, not a moved camera
constexpr double kHarmful_mm = 0.5;  // smaller errors are no reason to stop
constexpr double kHarmful_px = 0.6;  // of rows, as the motion explains them: two sigmas of a match on skin
constexpr double kTellsScatter = 4;  // fewest matches of a cell that determine their scatter
// A moved camera moves all points; a repeating pattern (knitwear) moves only those in one place. Least
// decrease of the points' mean squared residual by the motion, in sigmas, each at most four.
constexpr double kComesNearer = 0.3;

/// Relative error of the square's size measured with this rig.
double sizeError(const cameras::StereoRig& rig, const SquareObservation& square) {
  std::array<Eigen::Vector3d, 4> corners_mm;
  for (int i = 0; i < 4; ++i)
    corners_mm[i] = cameras::triangulate(rig, square.left_px[i], square.right_px[i]).mm;
  double side_mm = 0;
  for (int i = 0; i < 4; ++i) side_mm += (corners_mm[(i + 1) % 4] - corners_mm[i]).norm() / 4;
  return side_mm / square.size_mm - 1.0;
}

/// Running mean: `count` grows to kMemory, then older samples lose weight.
template <class T>
void average(T& mean, const T& sample, double count) {
  mean += (sample - mean) / count;
}

std::array<int, 3> keyOf(const cameras::StereoRig& rig, const Eigen::Vector2d& left_px, double depth_mm) {
  return {int(kColumns * left_px.x() / rig.width_px), int(kRows * left_px.y() / rig.height_px),
          int(depth_mm / kDepthBand_mm)};
}

}  // namespace

RigMonitor::RigMonitor(const cameras::StereoRig& rig, cameras::RigUncertainty uncertainty)
    : rig_(rig), uncertainty_(std::move(uncertainty)) {}

void RigMonitor::add(const std::vector<Correspondence>& points) {
  for (const Correspondence& point : points) {
    const double residual_px = cameras::epipolarResidual_px(rig_, point.left_px, point.right_px);
    if (!(std::abs(residual_px) < kGross_px)) continue;
    const double depth_mm = cameras::triangulate(rig_, point.left_px, point.right_px).mm.z();
    Cell& cell = cells_[keyOf(rig_, point.left_px, depth_mm)];
    const double count = double(cell.residuals_px.size());
    if (cell.residuals_px.size() < kMemory)
      cell.residuals_px.push_back(residual_px), cell.sigmas_px.push_back(point.sigma_px);
    else
      cell.residuals_px[cell.next % kMemory] = residual_px,
                                    cell.sigmas_px[cell.next++ % kMemory] = point.sigma_px;
    average(cell.left_px, point.left_px, std::min(count + 1, double(kMemory)));
    average(cell.right_px, point.right_px, std::min(count + 1, double(kMemory)));
  }
}

void RigMonitor::add(const SquareObservation& square) {
  std::vector<Correspondence> corners;
  for (int i = 0; i < 4; ++i) corners.push_back({square.left_px[i], square.right_px[i], 0.05});
  add(corners);
  const double error = sizeError(rig_, square);
  if (!std::isfinite(error)) return;
  const double depth_mm = cameras::triangulate(rig_, square.left_px[0], square.right_px[0]).mm.z();
  SizeCell& cell = size_cells_[keyOf(rig_, square.left_px[0], depth_mm)];
  cell.square = square;
  cell.count = std::min(double(kMemory), cell.count + 1);
  average(cell.error, error, cell.count);
  average(cell.variance, std::pow(square.size_sigma_mm / square.size_mm, 2), cell.count);
}

namespace {

double scatterOf(const std::vector<double>& residuals_px, double middle) {
  return kSigmaPerMad * medianAbsoluteDeviation(residuals_px, middle);
}

/// A median and its standard error. Each match counts with its own sigma or with the scatter in the cell,
/// whichever is larger. Too few matches do not determine their scatter: then `typical_px` of the other cells
/// is used.
std::pair<double, double> middleOf(const std::vector<double>& residuals_px,
                                   const std::vector<double>& sigmas_px, double typical_px) {
  const double middle = upperMedian(residuals_px), count = double(residuals_px.size());
  const double here_px = count < kTellsScatter ? typical_px : scatterOf(residuals_px, middle);
  const double each = std::max({upperMedian(sigmas_px), here_px, kSharedShare * typical_px});
  return {middle, std::hypot(each * std::sqrt(M_PI / 2 / count), kSharedShare * each)};
}

/// The measured values with their sigmas, and a linear model of possible causes: errors of calibration and
/// prints (unit variance), and the six parameters of a motion (scaled to unit variance).
struct Explanation {
  Eigen::VectorXd seen, sigma;
  Eigen::MatrixXd by_calibration, by_motion;
};

struct Explained {
  double cost = 0;                   // -2 log posterior, up to a constant
  Eigen::VectorXd unknowns, weight;  // weight: per measurement; near 0 for a wrong match
  Eigen::MatrixXd precision;         // precision of the unknowns
};

/// Maximum posterior under Student's t residuals, by reweighting (Lange, Little, Taylor 1989): a cell on a
/// glint or a silhouette is wrong by pixels and must not look like a moved camera.
Explained explain(const Explanation& model, const Eigen::MatrixXd& design) {
  Explained best;
  best.unknowns = Eigen::VectorXd::Zero(design.cols());
  best.weight = Eigen::VectorXd::Ones(model.seen.size());
  const Eigen::MatrixXd whitened = model.sigma.cwiseInverse().asDiagonal() * design;
  const Eigen::VectorXd seen = model.seen.cwiseQuotient(model.sigma);
  for (int round = 0; round < kMostReweightings; ++round) {
    Eigen::MatrixXd normal = whitened.transpose() * best.weight.asDiagonal() * whitened;
    normal.diagonal().array() += 1.0;
    best.precision = normal;
    best.unknowns =
        solveSymmetric(normal, Eigen::VectorXd(whitened.transpose() * best.weight.asDiagonal() * seen));
    const Eigen::ArrayXd z2 = (seen - whitened * best.unknowns).array().square();
    best.weight = ((kStudentFreedom + 1) / (kStudentFreedom + z2)).matrix();
    const double cost =
        best.unknowns.squaredNorm() + (kStudentFreedom + 1) * (1 + z2 / kStudentFreedom).log().sum();
    const bool has_settled = round > 0 && best.cost - cost < 1e-3;
    best.cost = cost;
    if (has_settled) break;
  }
  return best;
}

double sizeCost(const Explanation& model, const Eigen::VectorXd& explained, int points) {
  const Eigen::Index sizes = model.seen.size() - points;
  const Eigen::ArrayXd z2 = (model.seen - explained).cwiseQuotient(model.sigma).tail(sizes).array().square();
  return (kStudentFreedom + 1) * (1 + z2 / kStudentFreedom).log().sum();  // Student's t, as in explain()
}

/// The part of the motion that the measurements determine. Without squares they hardly determine yaw, and a
/// guess of it would appear as centimetres of depth.
Vector6d toldMotion(const Explained& moved) {
  const Eigen::MatrixXd covariance = inverseOfSymmetric(moved.precision);
  const PrincipalAxes<6> axes = principalAxes(Matrix6d(covariance.bottomRightCorner<6, 6>()));
  Vector6d along = axes.vectors.transpose() * moved.unknowns.tail<6>();
  for (int i = 0; i < 6; ++i)
    if (along[i] * along[i] < 4 * axes.values[i]) along[i] = 0;  // within two standard deviations of zero
  return axes.vectors * along;
}

}  // namespace

/// The gathered cells as one system of measurements: a row for each cell of points, then one for each cell of
/// squares.
class RigMonitor::Evaluation {
 public:
  explicit Evaluation(const RigMonitor& monitor) : rig_(monitor.rig_), uncertainty_(monitor.uncertainty_) {
    for (const auto& entry : monitor.cells_) cells_.push_back(&entry.second);
    for (const auto& entry : monitor.size_cells_) sizes_.push_back(&entry.second);
    points_ = int(cells_.size()), all_ = points_ + int(sizes_.size());
  }
  RigEstimate estimate() const;

 private:
  Explanation makeModel() const;
  void addPoints(Explanation& model) const;
  void addSizes(Explanation& model) const;
  void addCauses(Explanation& model) const;
  Eigen::VectorXd predict(const cameras::StereoRig& rig) const;
  double typicalScatter_px() const;
  double clippedResidual(const Eigen::VectorXd& explained) const;
  double epipolar_px(const Explanation& model, const Explained& moved) const;
  double displaced_mm(const Vector6d& motion) const;

  const cameras::StereoRig& rig_;
  const cameras::RigUncertainty& uncertainty_;
  std::vector<const Cell*> cells_;
  std::vector<const SizeCell*> sizes_;
  int points_ = 0, all_ = 0;  // rows of the cells of points, and of both
};

/// Residuals in the cells if this were the true rig.
Eigen::VectorXd RigMonitor::Evaluation::predict(const cameras::StereoRig& rig) const {
  Eigen::VectorXd values(all_);
  for (int i = 0; i < points_; ++i)
    values[i] = cameras::epipolarResidual_px(rig, cells_[i]->left_px, cells_[i]->right_px);
  for (int i = points_; i < all_; ++i) values[i] = sizeError(rig, sizes_[i - points_]->square);
  return values;
}

double RigMonitor::Evaluation::typicalScatter_px() const {
  std::vector<double> off;
  for (const Cell* cell : cells_)
    if (double(cell->residuals_px.size()) >= kTellsScatter)
      off.push_back(scatterOf(cell->residuals_px, upperMedian(cell->residuals_px)));
  return upperMedian(off);
}

void RigMonitor::Evaluation::addPoints(Explanation& model) const {
  const double typical_px = typicalScatter_px();
  for (int i = 0; i < points_; ++i) {
    const auto [middle, sigma] = middleOf(cells_[i]->residuals_px, cells_[i]->sigmas_px, typical_px);
    model.seen[i] = middle;
    model.sigma[i] = std::hypot(uncertainty_.lens_px, sigma);
  }
}

void RigMonitor::Evaluation::addSizes(Explanation& model) const {
  const int print = int(model.by_calibration.cols()) - 1;  // all sizes share the one error of the print
  for (int i = points_; i < all_; ++i) {
    const SizeCell& cell = *sizes_[i - points_];
    model.seen[i] = cell.error;
    model.sigma[i] = std::hypot(5e-4, std::sqrt(cell.variance));
    model.by_calibration(i, print) = cell.square.print_sigma_mm / cell.square.size_mm;
  }
}

/// Adds the derivatives of all measurements by the calibration's axes and by the motion.
void RigMonitor::Evaluation::addCauses(Explanation& model) const {
  const Eigen::VectorXd nominal = predict(rig_);
  for (int k = 0; k < int(uncertainty_.one_sigma.size()); ++k)
    model.by_calibration.col(k) = nominal - predict(uncertainty_.one_sigma[k]);
  // If the right camera moved by xi, its true rig would give zero residuals: seen = -d predict / d xi * xi.
  for (int k = 0; k < 6; ++k) {
    Vector6d step = Vector6d::Zero();
    step[k] = k < 3 ? 1e-4 : 0.05;
    const double prior = k < 3 ? kKnock.turn_sigma_rad : kKnock.shift_sigma_mm;
    model.by_motion.col(k) = -(predict(cameras::turned(rig_, step)) - nominal) * (prior / step[k]);
  }
}

Explanation RigMonitor::Evaluation::makeModel() const {
  const int axes = int(uncertainty_.one_sigma.size());
  Explanation model{Eigen::VectorXd(all_), Eigen::VectorXd(all_), Eigen::MatrixXd::Zero(all_, axes + 1),
                    Eigen::MatrixXd(all_, 6)};
  addPoints(model);
  addSizes(model);
  addCauses(model);
  return model;
}

/// Mean squared residual of the single points in their sigmas, each at most four.
double RigMonitor::Evaluation::clippedResidual(const Eigen::VectorXd& explained) const {
  double sum = 0, count = 0;
  for (int i = 0; i < points_; ++i)
    for (std::size_t n = 0; n < cells_[i]->residuals_px.size(); ++n, ++count)
      sum += std::min(4.0, std::pow(cells_[i]->residuals_px[n] - explained[i], 2) /
                               (std::pow(cells_[i]->sigmas_px[n], 2) + std::pow(uncertainty_.lens_px, 2)));
  return sum / count;
}

double RigMonitor::Evaluation::epipolar_px(const Explanation& model, const Explained& moved) const {
  const Eigen::VectorXd weight = moved.weight.head(points_);  // wrong matches stay wrong under any motion
  return std::sqrt(weight.dot(model.seen.head(points_).cwiseAbs2()) / std::max(1e-9, weight.sum()));
}

/// Root mean square shift in space of the cells' points if the right camera moved so.
double RigMonitor::Evaluation::displaced_mm(const Vector6d& motion) const {
  const cameras::StereoRig moved_rig = cameras::turned(rig_, motion);
  double squares = 0;
  for (const Cell* cell : cells_)
    squares += (cameras::triangulate(moved_rig, cell->left_px, cell->right_px).mm -
                cameras::triangulate(rig_, cell->left_px, cell->right_px).mm)
                   .squaredNorm();
  return std::sqrt(squares / points_);
}

RigEstimate RigMonitor::Evaluation::estimate() const {
  const Explanation model = makeModel();
  Eigen::MatrixXd either(all_, model.by_calibration.cols() + 6);
  either << model.by_calibration, model.by_motion;
  const Explained holds = explain(model, model.by_calibration), moved = explain(model, either);
  Vector6d motion = toldMotion(moved);
  motion.head<3>() *= kKnock.turn_sigma_rad;
  motion.tail<3>() *= kKnock.shift_sigma_mm;

  RigEstimate verdict;
  if (!motion.allFinite() || !std::isfinite(holds.cost)) return verdict;
  verdict.statistic = holds.cost - moved.cost;
  verdict.turn_rad = motion.head<3>();
  verdict.epipolar_px = epipolar_px(model, moved);
  verdict.displaced_mm = displaced_mm(motion);
  const Eigen::VectorXd by_rest = model.by_calibration * holds.unknowns, by_all = either * moved.unknowns;
  const double come_nearer = clippedResidual(by_rest) - clippedResidual(by_all);
  // A wrong size costs through its own residual and through an unlikely calibration; both count.
  const double sizes_tell = sizes_.empty()
                                ? 0.0
                                : sizeCost(model, by_rest, points_) - sizeCost(model, by_all, points_) +
                                      holds.unknowns.squaredNorm() - moved.unknowns.squaredNorm();
  const Eigen::VectorXd rows_px = model.by_motion.topRows(points_) * moved.unknowns.tail<6>();
  const bool is_harmful =
      verdict.displaced_mm > kHarmful_mm || std::sqrt(rows_px.squaredNorm() / points_) > kHarmful_px;
  const bool is_told = verdict.statistic > kMovedStatistic &&
                       (come_nearer > kComesNearer || sizes_tell > 0.5 * verdict.statistic);
  verdict.state = is_told && is_harmful ? RigState::moved : RigState::holds;
  return verdict;
}

RigEstimate RigMonitor::estimate() const {
  double samples = 0;
  for (const auto& entry : cells_) samples += double(entry.second.residuals_px.size());
  if (samples < kFewest) return {};
  return Evaluation(*this).estimate();
}

}  // namespace facenav::health
