// The paper's alignment: ICP with point-to-point pairs (equation 1; Besl and McKay 1992), trimmed
// (Chetverikov 2002). Deviations from the paper, without which it fails: pairs on the scan's cut edge and
// beyond it are dropped and the farthest pairs trimmed (untrimmed, a cloud that reaches below the scan's end
// turns the head by 12-27 degrees), and it starts from the rough poses of the search, not from a click.

#include <algorithm>
#include <numeric>

#include "cloud_sampling.h"
#include "facenav/geometry/rigid_fit.h"
#include "fit_report.h"

namespace facenav::registration {
namespace {

struct IcpFit {
  Eigen::Isometry3d mri_T_camera;
  double mean_square_mm2 = 1e12;
};

/// Pairs: cloud point and nearest vertex of the skin, the closest `kept` of those with a counterpart.
IcpFit iterate(const SkinField& skin, const PointCloud<Camera>& face, Eigen::Isometry3d pose, double kept,
               int iterations) {
  IcpFit fit{pose};
  const PoseFitter fitter(skin, face);
  for (int iteration = 0; iteration < iterations; ++iteration) {
    const auto matches = fitter.match(pose, false);
    std::vector<std::pair<double, int>> pairs;
    for (std::size_t p = 0; p < matches.size(); ++p)
      if (matches[p].is_valid)
        pairs.emplace_back((skin.vertices()[matches[p].vertex] - matches[p].at_mri_mm).squaredNorm(), int(p));
    const std::size_t count = std::size_t(kept * double(pairs.size()));
    if (count < 50) return {pose};
    std::nth_element(pairs.begin(), pairs.begin() + count, pairs.end());
    std::vector<Eigen::Vector3d> from_mm, to_mm;
    double squares = 0;
    for (std::size_t p = 0; p < count; ++p) {
      from_mm.push_back(face.points_mm[pairs[p].second]);
      to_mm.push_back(skin.vertices()[matches[pairs[p].second].vertex]);
      squares += pairs[p].first;
    }
    const Eigen::Isometry3d next = fitRigidPoints(from_mm, to_mm).to_T_from;
    // Few pairs at the head's rim match well anywhere: a fit that uses less of the cloud counts for less.
    const double used = double(pairs.size()) / double(face.size());
    fit = {next, squares / double(count) / (used * used)};
    if (!areDistinct(next, pose, fitter.pivot_mri_mm(), 1e-5, 1e-3)) break;
    pose = next;
  }
  return fit;
}

class IcpAligner : public Aligner {
 public:
  AlignmentResult align(const SkinModel& skin_model, const PointCloud<Camera>& face,
                        const AlignmentStart& start, TaskMonitor& monitor) const override {
    requireMaterial(skin_model, face);
    monitor.report("distance field", 0.0);
    const SkinField skin(skin_model);
    const auto starts = findStarts(skin, face, start, {true, 12, false, false}, monitor);
    IcpFit best{starts.front().mri_T_camera};
    std::vector<Candidate> tried;
    for (std::size_t s = 0; s < starts.size(); ++s) {
      monitor.report("iterating closest points", double(s) / double(starts.size()));
      const PointCloud<Camera> head = pick(face, nearHead(skin, face, starts[s].mri_T_camera, 40.0));
      const IcpFit fit =
          iterate(skin, pick(head, thinOut(head, 5.0, 1500)), starts[s].mri_T_camera, kKept, 30);
      tried.push_back({fit.mri_T_camera, fit.mean_square_mm2});
      if (fit.mean_square_mm2 < best.mean_square_mm2) best = fit;
    }
    const PointCloud<Camera> head = pick(face, nearHead(skin, face, best.mri_T_camera, 30.0));
    best = iterate(skin, pick(head, thinOut(head, 3.0, 5000)), best.mri_T_camera, kKept,
                   400);  // it slides slowly
    const auto matches = PoseFitter(skin, head).match(best.mri_T_camera, true);
    return report(skin, face, {best.mri_T_camera, inlierLimit_mm(matches, 3.0)}, tried);
  }

 private:
  static constexpr double kKept = 0.7;  // hair covers up to a third of what the cameras see of a head
};

}  // namespace

std::unique_ptr<Aligner> makeIcpAligner() { return std::make_unique<IcpAligner>(); }

}  // namespace facenav::registration
