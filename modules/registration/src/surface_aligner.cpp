#include "cloud_sampling.h"
#include "facenav/core/error.h"
#include "fit_report.h"

namespace facenav::registration {
namespace {

FinalFit refine(const SkinField& skin, const PointCloud<Camera>& face, Eigen::Isometry3d pose,
                TaskMonitor& monitor) {
  const PointCloud<Camera> head = pick(face, nearHead(skin, face, pose, 30.0));
  PoseFitter fitter(skin, pick(head, thinOut(head, 1.5, 20000)));
  monitor.report("fitting the face", 0.2);
  pose = fitter.fit(pose, {3.0, 2.0, 6, false});
  pose = fitter.fit(pose, {2.0, 1.5, 6, false});
  double limit_mm = 2.0;
  for (int round = 0; round < 3; ++round) {
    monitor.report("fitting the face", 0.4 + 0.2 * round);
    const auto matches = fitter.match(pose, true);
    fitter.setWeights(patchWeights(matches, 4.0));
    limit_mm = inlierLimit_mm(matches, limit_mm);
    pose = fitter.fit(pose, {limit_mm, limit_mm, 6, true});
  }
  return {pose, limit_mm};
}

class SurfaceAligner : public Aligner {
 public:
  AlignmentResult align(const SkinModel& skin_model, const PointCloud<Camera>& face,
                        const AlignmentStart& start, TaskMonitor& monitor) const override {
    requireMaterial(skin_model, face);
    monitor.report("distance field", 0.0);
    const SkinField skin(skin_model);
    try {
      return alignFrom(skin, face, start, {}, monitor);
    } catch (const Cancelled&) {
      throw;
    } catch (const Error&) {
      // Hints may mislead and the first search is quick: what it refuses gets a second, thorough one.
      return alignFrom(skin, face, start, {false, 10, true}, monitor);
    }
  }

 private:
  static AlignmentResult alignFrom(const SkinField& skin, const PointCloud<Camera>& face,
                                   const AlignmentStart& start, const SearchExtent& extent,
                                   TaskMonitor& monitor) {
    const auto candidates = findStarts(skin, face, start, extent, monitor);
    const FinalFit fit = refine(skin, face, candidates.front().mri_T_camera, monitor);
    return report(skin, face, fit, candidates);
  }
};

}  // namespace

std::unique_ptr<Aligner> makeSurfaceAligner() { return std::make_unique<SurfaceAligner>(); }

}  // namespace facenav::registration
