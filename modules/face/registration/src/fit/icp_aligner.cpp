// The paper's alignment: ICP with point-to-point pairs (equation 1; Besl and McKay 1992), trimmed
// (Chetverikov 2002). It deviates from the paper in three points, without which it fails. Pairs at the scan's
// cut edge or beyond it are dropped. The farthest pairs are trimmed: untrimmed, a cloud that extends below
// the scan's end turns the head by 12-27 degrees. It starts from the rough poses of the search, not from a
// click.

#include <algorithm>
#include <numeric>

#include "cloud/cloud_sampling.h"
#include "confidence/fit_report.h"
#include "facenav/geometry/rigid_fit.h"
#include "field/nearest_skin.h"
#include "robust_fit.h"

namespace facenav::registration {
namespace {

struct IcpFit {
  Eigen::Isometry3d mri_T_camera;
  double mean_square_mm2 = 1e12;
};

/// A cloud point in Mri and its nearest vertex.
struct Pair {
  double squared_mm2;
  int point, vertex;
};

std::vector<Pair> pairUp(const ScalpField& scalp, const PointCloud<Camera>& face,
                         const std::vector<int>& points, const Eigen::Isometry3d& mri_T_camera) {
  constexpr double kGrazing_cos = 0.12;  // skin at a flatter angle to the view has no counterpart
  const auto& vertices = scalp.skin().points.points_mm;
  std::vector<Pair> pairs;
  for (const int p : points) {
    const Eigen::Vector3d at = mri_T_camera * face.points_mm[std::size_t(p)];
    const int vertex = scalp.nearest().nearestVertex(at);
    if (scalp.nearest().isOnBorder(vertex) || scalp.nearest().isBeyondScan(at)) continue;
    const Eigen::Vector3d towards_camera = (mri_T_camera.translation() - at).normalized();
    if (scalp.skin().points.normals[std::size_t(vertex)].dot(towards_camera) < kGrazing_cos) continue;
    pairs.push_back({(vertices[std::size_t(vertex)] - at).squaredNorm(), p, vertex});
  }
  return pairs;
}

/// Fits the closest `kept` of the pairs with a counterpart until the pose stops moving.
IcpFit iterate(const ScalpField& scalp, const PointCloud<Camera>& face, const std::vector<int>& points,
               Eigen::Isometry3d pose, double kept, int iterations) {
  IcpFit fit{pose};
  for (int iteration = 0; iteration < iterations; ++iteration) {
    auto pairs = pairUp(scalp, face, points, pose);
    const std::size_t count = std::size_t(kept * double(pairs.size()));
    if (count < 50) return {pose};
    std::nth_element(pairs.begin(), pairs.begin() + std::ptrdiff_t(count), pairs.end(),
                     [](const Pair& a, const Pair& b) { return a.squared_mm2 < b.squared_mm2; });
    std::vector<Eigen::Vector3d> from_mm, to_mm;
    double squares = 0;
    for (std::size_t p = 0; p < count; ++p) {
      from_mm.push_back(face.points_mm[std::size_t(pairs[p].point)]);
      to_mm.push_back(scalp.skin().points.points_mm[std::size_t(pairs[p].vertex)]);
      squares += pairs[p].squared_mm2;
    }
    const Eigen::Isometry3d next = fitRigidPoints(from_mm, to_mm).to_T_from;
    // A few pairs at the head's rim match well anywhere. A fit that uses less of the cloud gets a higher
    // cost.
    const double used = double(pairs.size()) / double(points.size());
    fit = {next, squares / double(count) / (used * used)};
    if (!areDistinct(next, pose, scalp.middle_mm(), 1e-5, 1e-3)) break;
    pose = next;
  }
  return fit;
}

class IcpAligner : public Aligner {
 public:
  AlignmentResult align(const ScalpField& scalp, const PointCloud<Camera>& face, const AlignmentStart& start,
                        TaskMonitor& monitor) const override {
    requireMaterial(scalp, face);
    auto starts = findStarts(scalp, face, start, SearchWidth::near, 6, monitor);
    IcpFit best{starts.front().mri_T_camera};
    for (std::size_t s = 0; s < starts.size(); ++s) {
      monitor.report("iterating closest points", double(s) / double(starts.size()));
      const auto head = nearHead(scalp, face, finitePoints(face), starts[s].mri_T_camera, 40.0);
      const IcpFit fit =
          iterate(scalp, face, thinOut(face, head, 5.0, 1500), starts[s].mri_T_camera, kKept, 30);
      starts[s] = {fit.mri_T_camera, fit.mean_square_mm2};
      if (fit.mean_square_mm2 < best.mean_square_mm2) best = fit;
    }
    const auto head = nearHead(scalp, face, finitePoints(face), best.mri_T_camera, 30.0);
    best = iterate(scalp, face, thinOut(face, head, 3.0, 5000), best.mri_T_camera, kKept,
                   400);  // point-to-point ICP converges slowly
    const auto matches = FieldFitter(scalp, face, head).match(best.mri_T_camera);
    const Covers covers(scalp, face, thinOut(face, head, 3.0, 4000), best.mri_T_camera);
    const auto fit =
        judge(scalp, face, covers.bare(face, head), best.mri_T_camera, inlierLimit_mm(matches, 3.0));
    return report(scalp, face, fit, best.mri_T_camera, covers,
                  gatherEvidence(scalp, face, best.mri_T_camera, covers, starts));
  }

 private:
  static constexpr double kKept = 0.7;  // hair covers up to a third of the visible head
};

}  // namespace

std::unique_ptr<Aligner> makeIcpAligner() { return std::make_unique<IcpAligner>(); }

}  // namespace facenav::registration
