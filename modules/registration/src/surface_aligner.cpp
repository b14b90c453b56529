#include <algorithm>

#include "cloud_sampling.h"
#include "facenav/core/error.h"
#include "fit_report.h"
#include "part_fits.h"

namespace facenav::registration {
namespace {

constexpr float kOutside = 0.67f;           // foreign things lie outside the skin: let go there first
constexpr std::size_t kMostPoints = 20000;  // more add nothing: neighbours share their error

/// From within a few mm to the end: parts first (hair, hands), then all points on the fine field, then the
/// misfit model.
FinalFit refine(const ScalpField& scalp, const PointCloud<Camera>& face, Eigen::Isometry3d pose,
                TaskMonitor& monitor) {
  monitor.report("fitting the face", 0.2);
  const std::vector<int> head = thinOut(face, nearHead(scalp, face, pose, 20.0), 1.0, kMostPoints);
  const PartFit parts = bestOfParts(scalp, face, thinOut(face, head, 6.0, 1000), pose);
  pose = parts.mri_T_camera;
  monitor.report("fitting the face", 0.5);
  FieldFitter sparse(scalp, face, thinOut(face, head, 3.0, 4000)), all(scalp, face, head);
  float limit_mm = 2.0f;
  for (FieldFitter* fitter : {&sparse, &all}) {
    const auto matches = fitter->match(pose);
    fitter->setWeights(patchWeights(matches, 4.0));
    limit_mm = std::min(1.5f, float(inlierLimit_mm(matches, limit_mm)));
    pose = fitter->fit(pose, {limit_mm, kOutside * limit_mm, 3, true});
  }
  monitor.report("modelling the skin's misfit", 0.8);
  FinalFit fit = correct(scalp, face, head, pose, double(limit_mm));
  fit.belief.covariance += parts.doubt;
  return fit;
}

class SurfaceAligner : public Aligner {
 public:
  AlignmentResult align(const ScalpField& scalp, const PointCloud<Camera>& face, const AlignmentStart& start,
                        TaskMonitor& monitor) const override {
    requireMaterial(scalp, face);
    try {
      if (const auto straight = descend(scalp, face, start))
        return report(scalp, face, refine(scalp, face, straight->mri_T_camera, monitor), {});
    } catch (const Cancelled&) {
      throw;
    } catch (const Error&) {
      // A poor guess: look around it.
    }
    for (const SearchWidth width : {SearchWidth::near, SearchWidth::any}) {
      try {
        return search(scalp, face, start, width, 6, monitor);
      } catch (const Cancelled&) {
        throw;
      } catch (const Error&) {
        // Hints may mislead and the first search is quick: what it refuses gets a wider one.
      }
    }
    return search(scalp, face, start, SearchWidth::thorough, 10, monitor);
  }

 private:
  static AlignmentResult search(const ScalpField& scalp, const PointCloud<Camera>& face,
                                const AlignmentStart& start, SearchWidth width, std::size_t most,
                                TaskMonitor& monitor) {
    const auto candidates = findStarts(scalp, face, start, width, most, monitor);
    const FinalFit fit = refine(scalp, face, candidates.front().mri_T_camera, monitor);
    return report(scalp, face, fit, candidates);
  }
};

}  // namespace

std::unique_ptr<Aligner> makeSurfaceAligner() { return std::make_unique<SurfaceAligner>(); }

}  // namespace facenav::registration
