#include <algorithm>
#include <cmath>
#include <exception>
#include <future>
#include <optional>

#include "confidence/camera_turn.h"
#include "confidence/fit_report.h"
#include "facenav/core/error.h"
#include "robust_fit.h"

namespace facenav::registration {
namespace {

/// Takes the likeliest size into account. The fit may hide a size error in the pose, and then states too
/// small a one.
void takeSize(PosePosterior& posterior, double size) {
  constexpr double kStep = 0.005;  // half the distance of two sizes that are tried
  if (std::abs(size - 1.0) <= std::abs(posterior.scale)) return;
  posterior.scale = size - 1.0;
  posterior.scale_sigma = std::max(posterior.scale_sigma, kStep);
}

AlignmentResult conclude(const ScalpField& scalp, const PointCloud<Camera>& face, const RobustFit& robust,
                         const std::vector<Candidate>& rivals, const AlignmentStart& start,
                         TaskMonitor& monitor) {
  monitor.report("modelling the skin's misfit", 0.7);
  auto gathering = std::async(std::launch::async, [&] {
    FitEvidence all = gatherEvidence(scalp, face, robust.mri_T_camera, robust.covers, rivals, start.noise_mm);
    all.is_patient_confirmed = start.is_patient_confirmed;
    return all;
  });
  std::optional<FinalFit> fit;
  try {
    fit = correct(scalp, face, evenPoints(scalp, face, robust), robust.mri_T_camera, robust.limit_mm, start);
  } catch (const Error&) {
    requireLikeness(gathering.get());  // another person's face is reported as such
    throw;
  }
  fit->posterior.covariance += robust.doubt;
  const FitEvidence evidence = gathering.get();
  requireLikeness(evidence);
  takeSize(fit->posterior, evidence.fitting_scale);
  fit->posterior.turn = settledTurn(scalp, face, start, *fit, evidence.fitting_scale);
  monitor.report("checking the fit", 0.9);
  return report(scalp, face, *fit, robust.mri_T_camera, robust.covers, evidence, start);
}

AlignmentResult search(const ScalpField& scalp, const PointCloud<Camera>& face, const AlignmentStart& start,
                       SearchWidth width, std::size_t most, TaskMonitor& monitor) {
  const auto candidates = findStarts(scalp, face, start, width, most, monitor);
  monitor.report("fitting the face", 0.5);
  return conclude(scalp, face, fitFace(scalp, face, candidates.front().mri_T_camera, start.noise_mm),
                  candidates, start, monitor);
}

/// Adds the error shared by the whole cloud (too near or too far), which the residuals do not show.
void addSharedDepth(AlignmentResult& result, const PointCloud<Camera>& face, double sigma_mm) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t p = 0; p < face.size(); ++p)
    if (result.is_inlier[p]) sum += face.points_mm[p];
  const Eigen::Vector3d along = sigma_mm * sum.normalized();
  result.covariance.bottomRightCorner<3, 3>() += along * along.transpose();
}

class SurfaceAligner : public Aligner {
 public:
  AlignmentResult align(const ScalpField& scalp, const PointCloud<Camera>& face, const AlignmentStart& start,
                        TaskMonitor& monitor) const override {
    AlignmentResult result = fit(scalp, face, start, monitor);
    addSharedDepth(result, face, start.shared_depth_sigma_mm);
    return result;
  }

 private:
  static AlignmentResult fit(const ScalpField& scalp, const PointCloud<Camera>& face,
                             const AlignmentStart& start, TaskMonitor& monitor) {
    requireMaterial(scalp, face);
    monitor.report("fitting the face", 0.0);
    try {
      if (const auto robust = fitFromGuess(scalp, face, start))
        return conclude(scalp, face, *robust, {}, start, monitor);
    } catch (const Cancelled&) {
      throw;
    } catch (const CameraTurned&) {
      throw;
    } catch (const Error&) {
      // The guess was poor: search around it.
    }
    // Hints may mislead and the first search is quick, so a refusal leads to a wider search. The error of the
    // first search is thrown: it refers to the best pose, while wider searches end in worse poses. But where
    // a person can decide about a pose, the question is thrown.
    std::exception_ptr reason, undecided;
    for (const auto& [width, most] :
         {std::pair{SearchWidth::near, 6}, {SearchWidth::any, 6}, {SearchWidth::thorough, 10}})
      try {
        return search(scalp, face, start, width, std::size_t(most), monitor);
      } catch (const Cancelled&) {
        throw;
      } catch (const CameraTurned&) {
        throw;
      } catch (const PersonUnclear&) {
        if (!undecided) undecided = std::current_exception();
      } catch (const Error&) {
        if (!reason) reason = std::current_exception();
      }
    std::rethrow_exception(undecided ? undecided : reason);
  }
};

}  // namespace

std::unique_ptr<Aligner> makeSurfaceAligner() { return std::make_unique<SurfaceAligner>(); }

}  // namespace facenav::registration
