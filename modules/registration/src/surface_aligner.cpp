#include "facenav/core/error.h"
#include "fit_report.h"
#include "robust_fit.h"

namespace facenav::registration {
namespace {

AlignmentResult conclude(const ScalpField& scalp, const PointCloud<Camera>& face, const RobustFit& robust,
                         const std::vector<Candidate>& rivals, TaskMonitor& monitor) {
  monitor.report("modelling the skin's misfit", 0.7);
  FinalFit fit = correct(scalp, face, robust.points, robust.mri_T_camera, robust.limit_mm);
  fit.belief.covariance += robust.doubt;
  monitor.report("checking the fit", 0.9);
  return report(scalp, face, fit, robust.mri_T_camera, rivals);
}

AlignmentResult search(const ScalpField& scalp, const PointCloud<Camera>& face, const AlignmentStart& start,
                       SearchWidth width, std::size_t most, TaskMonitor& monitor) {
  const auto candidates = findStarts(scalp, face, start, width, most, monitor);
  monitor.report("fitting the face", 0.5);
  return conclude(scalp, face, fitFace(scalp, face, candidates.front().mri_T_camera), candidates, monitor);
}

class SurfaceAligner : public Aligner {
 public:
  AlignmentResult align(const ScalpField& scalp, const PointCloud<Camera>& face, const AlignmentStart& start,
                        TaskMonitor& monitor) const override {
    requireMaterial(scalp, face);
    monitor.report("fitting the face", 0.0);
    try {
      if (const auto robust = fitFromGuess(scalp, face, start))
        return conclude(scalp, face, *robust, {}, monitor);
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
};

}  // namespace

std::unique_ptr<Aligner> makeSurfaceAligner() { return std::make_unique<SurfaceAligner>(); }

}  // namespace facenav::registration
