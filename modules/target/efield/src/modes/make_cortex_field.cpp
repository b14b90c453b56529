#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>

#include "dense/product.h"
#include "facenav/core/error.h"
#include "facenav/efield/cortex_field.h"
#include "facenav/surface/closest_point.h"
#include "model/shell_surface.h"
#include "modes/packed_modes.h"
#include "modes/training_sources.h"

namespace facenav::efield {
namespace {

using dense::addProduct;
using dense::viewOf;
using Eigen::Index;
using Eigen::MatrixXf;

constexpr int kSketchSources = 1500, kFitSources = 4000, kCheckSources = 200;
constexpr int kMoreColumns =
    192;                         // of the random sketch, beyond the modes kept (Halko 2011, SIAM Rev 53:217)
constexpr Index kSubset = 1000;  // points on which modes are made orthogonal
constexpr Index kPointBlock = 512;  // points whose rows are made together
constexpr Index kSamples = 642;     // vertices of the skull next to which the coil's field is taken
constexpr int kFitSteps = 4;        // of the iterated ridge regression
constexpr float kFitRidge = 1e-7f;  // relative to the sum of the squares

const auto kShare = float(1 / (4 * M_PI));

MatrixXf product(const MatrixXf& a, const MatrixXf& b) {
  MatrixXf c = MatrixXf::Zero(a.rows(), b.cols());
  addProduct(viewOf(c), 1.f, viewOf(a), viewOf(b));
  return c;
}
MatrixXf transposedProduct(const MatrixXf& a, const MatrixXf& b) {
  MatrixXf c = MatrixXf::Zero(a.cols(), b.cols());
  addProduct(viewOf(c), 1.f, viewOf(a).transposed(), viewOf(b));
  return c;
}

/// Every n-th of the points after shuffling, the same for the same number.
Eigen::Matrix3Xd subsetOf(const Eigen::Matrix3Xd& points) {
  std::vector<Index> order(std::size_t(points.cols()));
  std::iota(order.begin(), order.end(), Index(0));
  std::mt19937 random(5);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  order.resize(std::min(order.size(), std::size_t(kSubset)));
  Eigen::Matrix3Xd subset(3, Index(order.size()));
  for (std::size_t i = 0; i < order.size(); ++i) subset.col(Index(i)) = points.col(order[i]);
  return subset;
}

/// Places on the outer skull next to the first vertices of the inner skull, which are spread evenly.
Eigen::Matrix3Xd samplePlaces(const HeadModel& head) {
  const surface::ClosestPoint skull(triangleMesh(head.outer_skull));
  const Eigen::Matrix3Xd& inner = head.inner_skull.vertices_mm;
  Eigen::Matrix3Xd places = inner.leftCols(std::min(kSamples, inner.cols()));
  for (auto place : places.colwise()) place = skull.nearest(Point<Mri>(place)).point.mm;
  return places;
}

class ModeMaker {
 public:
  /// `drop`: called when the factorised equations are not needed any more.
  ModeMaker(const FieldSolver& solver, const Eigen::Matrix3Xd& points_mm, TaskMonitor& monitor,
            std::function<void()> drop)
      : system_(solver.system()),
        monitor_(monitor),
        drop_(std::move(drop)),
        points_mm_(points_mm),
        subset_(subsetOf(points_mm)),
        subset_pulls_(pullsAt(system_, subset_)) {
    samples_ = PointArrays(samplePlaces(solver.head()));
    lowest_z_mm_ = solver.innermost().vertices_mm.row(2).minCoeff();
    scalp_ = &solver.head().scalp;
  }

  CortexField make(int most_modes) {
    sketch(most_modes + kMoreColumns);
    orthogonalise(most_modes);
    takeIn();
    subset_pulls_.resize(0, 0);
    drop_();
    CortexField field;
    field.points_mm = points_mm_.cast<float>();
    field.samples_mm.resize(3, samples_.x.size());
    field.samples_mm << samples_.x.transpose(), samples_.y.transpose(), samples_.z.transpose();
    fit(field);
    spread(field);
    return field;
  }

 private:
  SourceArray sources(int count, unsigned seed) const {
    return trainingSources(*scalp_, lowest_z_mm_, count, seed);
  }
  /// 1 / size of each source's field at the samples.
  Eigen::VectorXf scalesOf(const MatrixXf& at_samples) const {
    return at_samples.colwise().norm().cwiseInverse().transpose();
  }
  /// Field in the head (field units) of sources with flux weights `flux` and own field `own` on the subset.
  MatrixXf modesOf(const MatrixXf& own, const MatrixXf& flux) const {
    MatrixXf modes = transposedProduct(subset_modes_, own);
    addProduct(viewOf(modes), 1.f, viewOf(flux_modes_).transposed(), viewOf(flux));
    return modes;
  }

  /// Random sums of sources: their solved weights and their field on the subset.
  void sketch(int columns) {
    monitor_.report("electric field: modes", 0.1);
    sources_ = sources(kSketchSources, 1);
    mixture_.resize(kSketchSources, columns);
    std::mt19937 random(2);
    for (Index i = 0; i < mixture_.size(); ++i) mixture_.data()[i] = (random() & 1) ? 1.f : -1.f;
    mixture_ = scalesOf(primaryOfEach(samples_, sources_)).asDiagonal() * mixture_;
    weights_ = product(fluxOfEach(system_, sources_), mixture_);
    system_.removeMeans(weights_);
    dense::solveTransposed(viewOf(system_.lu), system_.pivots, viewOf(weights_));
    weights_ *= kShare;
  }

  /// The strongest orthogonal combinations of the sketch on the subset.
  void orthogonalise(int most_modes) {
    monitor_.report("electric field: modes", 0.3);
    MatrixXf field = product(primaryOfEach(subset_, sources_), mixture_);
    addProduct(viewOf(field), 1.f,
               viewOf(subset_pulls_).part(0, 0, system_.size(), field.rows()).transposed(), viewOf(weights_));
    const Eigen::MatrixXd wide = field.cast<double>();
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(wide.cols(), wide.cols());
    gram.selfadjointView<Eigen::Lower>().rankUpdate(wide.transpose());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(gram);
    const Index kept = std::min<Index>(most_modes, gram.cols());
    const Eigen::VectorXd values = eigen.eigenvalues().tail(kept);
    // Modes that are rounding errors count for nothing.
    const Eigen::VectorXd scales =
        (values.array() > 1e-12 * values.maxCoeff()).select(values.array().max(1e-300).rsqrt(), 0.0);
    const MatrixXf turn = (eigen.eigenvectors().rightCols(kept) * scales.asDiagonal()).cast<float>();
    subset_modes_ = product(field, turn);
    mixture_ = product(mixture_, turn);
    weights_ = product(weights_, turn);
  }

  /// Flux weights to modes: the transposed map, solved for the modes.
  void takeIn() {
    monitor_.report("electric field: modes", 0.5);
    flux_modes_ = MatrixXf::Zero(system_.size(), subset_modes_.cols());
    addProduct(viewOf(flux_modes_), kShare,
               viewOf(subset_pulls_).part(0, 0, system_.size(), subset_modes_.rows()), viewOf(subset_modes_));
    dense::solve(viewOf(system_.lu), system_.pivots, viewOf(flux_modes_));
    system_.removeMeans(flux_modes_);
  }

  /// Fits the map from the coil's own field at the samples to the modes, on sources that it was not made
  /// from.
  void fit(CortexField& field) {
    monitor_.report("electric field: modes", 0.6);
    const auto [at_samples, modes] = pairsOf(kFitSources, 3);
    MatrixXf gram = MatrixXf::Zero(at_samples.rows(), at_samples.rows());
    addProduct(viewOf(gram), 1.f, viewOf(at_samples), viewOf(at_samples).transposed());
    gram.diagonal().array() += kFitRidge * gram.diagonal().sum();
    const dense::Pivots pivots = dense::factorise(viewOf(gram));
    MatrixXf map = MatrixXf::Zero(at_samples.rows(), modes.rows());  // transposed
    MatrixXf residual = modes;
    for (int step = 0; step < kFitSteps; ++step) {
      MatrixXf change = MatrixXf::Zero(map.rows(), map.cols());
      addProduct(viewOf(change), 1.f, viewOf(at_samples), viewOf(residual).transposed());
      dense::solve(viewOf(gram), pivots, viewOf(change));
      map += change;
      residual = modes;
      addProduct(viewOf(residual), -1.f, viewOf(map).transposed(), viewOf(at_samples));
    }
    field.modes = map.cols();
    field.intake = packedFloats(map.transpose());
    const auto [unseen, truth] = pairsOf(kCheckSources, 4);
    const MatrixXf found = transposedProduct(map, unseen);
    field.mode_error = std::sqrt(
        ((found - truth).colwise().squaredNorm().array() / truth.colwise().squaredNorm().array()).mean());
  }

  std::pair<MatrixXf, MatrixXf> pairsOf(int count, unsigned seed) const {
    const SourceArray all = sources(count, seed);
    MatrixXf at_samples = primaryOfEach(samples_, all), modes(subset_modes_.cols(), count);
    constexpr Index kAtOnce = 500;
    for (Index first = 0; first < count; first += kAtOnce) {
      const Index some = std::min<Index>(kAtOnce, count - first);
      const SourceArray part = all.part(first, some);
      modes.middleCols(first, some) = modesOf(primaryOfEach(subset_, part), fluxOfEach(system_, part));
    }
    const Eigen::VectorXf scales = scalesOf(at_samples);
    return {at_samples * scales.asDiagonal(), modes * scales.asDiagonal()};
  }

  /// The modes at all points.
  void spread(CortexField& field) {
    PackedShapes shapes(points_mm_.cols(), subset_modes_.cols());
    PullBlocks pull_blocks(system_);
    for (Index first = 0; first < points_mm_.cols(); first += kPointBlock) {
      monitor_.report("electric field: modes", 0.7 + 0.3 * double(first) / double(points_mm_.cols()));
      const Index count = std::min(kPointBlock, points_mm_.cols() - first);
      const PointArrays block(points_mm_.middleCols(first, count));
      MatrixXf rows = product(primaryOfEach(block, sources_), mixture_);
      const MatrixXf& pulls = pull_blocks.at(block);
      addProduct(viewOf(rows), 1.f, viewOf(pulls).part(0, 0, system_.size(), rows.rows()).transposed(),
                 viewOf(weights_));
      shapes.add(rows * float(kFieldOfUnits), first, count);
    }
    shapes.finish(field);
  }

  const BoundarySystem& system_;
  TaskMonitor& monitor_;
  std::function<void()> drop_;
  const Eigen::Matrix3Xd& points_mm_;
  PointArrays subset_;
  MatrixXf subset_pulls_;
  PointArrays samples_;
  double lowest_z_mm_ = 0;
  const ShellMesh* scalp_ = nullptr;
  SourceArray sources_;
  MatrixXf mixture_;       // sources to modes
  MatrixXf weights_;       // solved weights of each mode, / 4 pi
  MatrixXf subset_modes_;  // orthonormal columns
  MatrixXf flux_modes_;    // flux weights to modes, transposed
};

}  // namespace

namespace {

CortexField madeField(const FieldSolver& solver, const Eigen::Matrix3Xd& points_mm, TaskMonitor& monitor,
                      int most_modes, std::function<void()> drop) {
  FACENAV_EXPECT(most_modes > 0 && most_modes % kernels::kBlock == 0, "whole blocks of modes");
  if (points_mm.cols() == 0) throw Error("the cortex has no points", {}, "prepare the case again");
  const ReachablePoints reachable = reachablePoints(solver.innermost(), points_mm);
  CortexField field = ModeMaker(solver, reachable.points_mm, monitor, std::move(drop)).make(most_modes);
  field.is_moved.assign(reachable.is_moved.begin(), reachable.is_moved.end());
  return field;
}

}  // namespace

CortexField makeCortexField(const FieldSolver& solver, const Eigen::Matrix3Xd& points_mm,
                            TaskMonitor& monitor, int most_modes) {
  return madeField(solver, points_mm, monitor, most_modes, [] {});
}

CortexField makeCortexField(FieldSolver&& solver, const Eigen::Matrix3Xd& points_mm, TaskMonitor& monitor,
                            int most_modes) {
  return madeField(solver, points_mm, monitor, most_modes, [&solver] { solver.dropEquations(); });
}

}  // namespace facenav::efield
