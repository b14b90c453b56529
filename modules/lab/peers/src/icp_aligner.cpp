#include "facenav/peers/icp_aligner.h"

// The paper's alignment: iterative closest points of face and skin (section 3, equation 1; Besl and McKay
// 1992), by PCL. It deviates from the paper where it would fail otherwise. Pairs at the scan's cut edge are
// dropped, and so are the farthest pairs: untrimmed, a cloud that reaches below the scan's end turns the head
// by 12-27 degrees. It starts from the rough poses of the search, not from a click.

#include <pcl/console/print.h>
#include <pcl/point_types.h>
#include <pcl/registration/icp.h>
#include <pcl/search/impl/kdtree.hpp>  // with impl, pcl_search and pcl_octree need not be loaded
#include <pcl/search/impl/search.hpp>

#include "cloud/cloud_sampling.h"
#include "confidence/fit_report.h"
#include "field/nearest_skin.h"
#include "field/point_kernel.h"
#include "fit/robust_fit.h"

namespace facenav::peers {
namespace {

using namespace registration;

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

pcl::PointXYZ toPcl(const Eigen::Vector3d& p_mm) {
  return {float(p_mm.x()), float(p_mm.y()), float(p_mm.z())};
}

/// Keeps the closest pairs (Chetverikov 2002) of those whose vertex of the skin the camera sees.
class ClosestSeenPairs : public pcl::registration::CorrespondenceRejector {
 public:
  static constexpr std::size_t kFewest = 50;  // pairs of a fit
  static constexpr double kNoFit_mm2 = 1e12;

  explicit ClosestSeenPairs(const ScalpField& scalp) : scalp_(scalp) {}

  void lookFrom(const Eigen::Vector3d& camera_mri_mm) {
    const auto& skin = scalp_.skin().points;
    is_seen_.resize(skin.size());
    for (std::size_t v = 0; v < skin.size(); ++v)
      is_seen_[v] = !scalp_.nearest().isOnBorder(int(v)) &&
                    skin.normals[v].dot((camera_mri_mm - skin.points_mm[v]).normalized()) >=
                        double(point::kGrazing_cos);
  }

  void getRemainingCorrespondences(const pcl::Correspondences& all, pcl::Correspondences& kept) override {
    kept.clear();
    for (const auto& pair : all)
      if (is_seen_[std::size_t(pair.index_match)]) kept.push_back(pair);
    const double used = double(kept.size()) / double(all.size());
    const auto count = std::size_t(kKept * double(kept.size()));
    cost_mm2_ = kNoFit_mm2;
    if (count < kFewest) return kept.clear();
    const auto is_closer = [](const auto& a, const auto& b) { return a.distance < b.distance; };
    std::nth_element(kept.begin(), kept.begin() + std::ptrdiff_t(count), kept.end(), is_closer);
    kept.resize(count);
    double squares_mm2 = 0;
    for (const auto& pair : kept) squares_mm2 += double(pair.distance);  // PCL's are squared
    cost_mm2_ = squares_mm2 / double(count) / (used * used);
  }

  /// Mean of equation 1 over the pairs kept last. A few pairs at the head's rim match well anywhere: a fit
  /// that uses less of the cloud costs more.
  double cost_mm2() const { return cost_mm2_; }

 private:
  static constexpr double kKept = 0.7;  // hair covers up to a third of the visible head

  void applyRejection(pcl::Correspondences& kept) override {
    getRemainingCorrespondences(*input_correspondences_, kept);
  }

  const ScalpField& scalp_;
  std::vector<bool> is_seen_;  // by vertex
  double cost_mm2_ = kNoFit_mm2;
};

class ClosestPoints {
 public:
  ClosestPoints(const ScalpField& scalp, const PointCloud<Camera>& face)
      : face_(face),
        skin_(new Cloud),
        tree_(new pcl::search::KdTree<pcl::PointXYZ>),
        pairs_(new ClosestSeenPairs(scalp)) {
    for (const auto& p_mm : scalp.skin().points.points_mm) skin_->push_back(toPcl(p_mm));
    tree_->setInputCloud(skin_);
    icp_.setInputTarget(skin_);
    icp_.setSearchMethodTarget(tree_, true);  // built once, not for each start
    icp_.addCorrespondenceRejector(pairs_);
    icp_.setTransformationEpsilon(kStill_mm * kStill_mm);
    icp_.setTransformationRotationEpsilon(std::cos(kStill_rad));
  }

  /// Section 3, steps 1 to 4: pairs of nearest points, the motion (R, t) that minimises equation 1 over them,
  /// the points moved by it, and so on until the pose stops moving.
  Candidate fit(const std::vector<int>& points, const Eigen::Isometry3d& mri_T_camera, int iterations) {
    if (points.size() < ClosestSeenPairs::kFewest) return {mri_T_camera, ClosestSeenPairs::kNoFit_mm2};
    Cloud::Ptr face(new Cloud), moved(new Cloud);
    for (const int p : points) face->push_back(toPcl(mri_T_camera * face_.points_mm[std::size_t(p)]));
    pairs_->lookFrom(mri_T_camera.translation());
    icp_.setInputSource(face);
    icp_.setMaximumIterations(iterations);
    icp_.align(*moved);
    return {Eigen::Isometry3d(icp_.getFinalTransformation()) * mri_T_camera, pairs_->cost_mm2()};
  }

 private:
  static constexpr double kStill_rad = 1e-5, kStill_mm = 1e-3;

  const PointCloud<Camera>& face_;
  Cloud::Ptr skin_;
  pcl::search::KdTree<pcl::PointXYZ>::Ptr tree_;
  pcl::shared_ptr<ClosestSeenPairs> pairs_;
  pcl::IterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ, double> icp_;
};

class IcpAligner : public Aligner {
 public:
  AlignmentResult align(const ScalpField& scalp, const PointCloud<Camera>& face, const AlignmentStart& start,
                        TaskMonitor& monitor) const override {
    requireMaterial(scalp, face);
    auto starts = findStarts(scalp, face, start, SearchWidth::near, 6, monitor);
    ClosestPoints closest(scalp, face);
    Candidate best{starts.front().mri_T_camera, ClosestSeenPairs::kNoFit_mm2};
    for (std::size_t s = 0; s < starts.size(); ++s) {
      monitor.report("iterating closest points", double(s) / double(starts.size()));
      const auto head = nearHead(scalp, face, finitePoints(face), starts[s].mri_T_camera, 40.0);
      starts[s] = closest.fit(thinOut(face, head, 5.0, 1500), starts[s].mri_T_camera, 30);
      if (starts[s].cost < best.cost) best = starts[s];
    }
    const auto head = nearHead(scalp, face, finitePoints(face), best.mri_T_camera, 30.0);
    // Point-to-point ICP converges slowly.
    best = closest.fit(thinOut(face, head, 3.0, 5000), best.mri_T_camera, 400);
    const auto matches = FieldFitter(scalp, face, head).match(best.mri_T_camera);
    const Covers covers(scalp, face, thinOut(face, head, 3.0, 4000), best.mri_T_camera, start.noise_mm);
    const auto fit =
        judge(scalp, face, covers.bare(face, head), best.mri_T_camera, inlierLimit_mm(matches, 3.0));
    return report(scalp, face, fit, best.mri_T_camera, covers,
                  gatherEvidence(scalp, face, best.mri_T_camera, covers, starts, start.noise_mm));
  }
};

}  // namespace

std::unique_ptr<Aligner> makeIcpAligner() {
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);  // a fit without pairs is refused by us, in words
  return std::make_unique<IcpAligner>();
}

}  // namespace facenav::peers
