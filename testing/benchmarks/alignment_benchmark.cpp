// Alignment of a face cloud (20 000 points) to the skin of an MRI, from a start with a known error: ours, the
// paper's ICP, and PCL's ICP, GICP and point-to-plane ICP on the same clouds. The head has a closed form; the
// live skin differs from it by all kinds of misfit at once.

#include <pcl/features/normal_3d.h>
#include <pcl/point_types.h>
#include <pcl/registration/gicp.h>
#include <pcl/registration/icp.h>
#include <pcl/search/kdtree.h>

#include <cstdio>
#include <cstdlib>
#include <functional>

#include "confidence/fit_report.h"
#include "facenav/anatomy/nose.h"
#include "facenav/core/error.h"
#include "facenav/geometry/pose_error.h"
#include "facenav/peers/icp_aligner.h"
#include "facenav/registration/aligner.h"
#include "fit/robust_fit.h"
#include "support/model_head.h"
#include "support/skin_misfit.h"
#include "support/stopwatch.h"

namespace facenav::testing {
namespace {

using registration::ScalpField;
using PoseMaybe = std::optional<Eigen::Isometry3d>;  // camera_T_mri
using PclCloud = pcl::PointCloud<pcl::PointNormal>;

struct Trial {
  PointCloud<Camera> face;
  RigidTransform<Camera, Mri> truth, guess;
};

struct Outcome {
  std::vector<double> time_ms, elapsed_ms, error_mm;  // processor time of all threads, wall clock
  int found = 0, trials = 0;
};

PclCloud::Ptr toPcl(const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3d>& normals) {
  PclCloud::Ptr cloud(new PclCloud);
  for (std::size_t p = 0; p < points.size(); ++p) {
    pcl::PointNormal point;
    point.getVector3fMap() = points[p].cast<float>();
    if (!normals.empty()) point.getNormalVector3fMap() = normals[p].cast<float>();
    cloud->push_back(point);
  }
  return cloud;
}

/// Runs a PCL method, which moves the face onto the skin: mri_T_camera. Its target (with the tree) is set
/// once per case, like our field.
template <class Method>
PoseMaybe runPcl(Method& method, const PclCloud::Ptr& face, const Eigen::Isometry3d& camera_T_mri) {
  method.setInputSource(face);
  PclCloud moved;
  const Eigen::Matrix4f guess = camera_T_mri.inverse().matrix().cast<float>();
  method.align(moved, guess);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  const Eigen::Matrix4d found = method.getFinalTransformation().template cast<double>();
  pose.linear() = Eigen::Quaterniond(Eigen::Matrix3d(found.topLeftCorner<3, 3>())).normalized().matrix();
  pose.translation() = found.topRightCorner<3, 1>();
  return pose.inverse();
}

Trial makeTrial(const registration::SkinModel& skin, const Eigen::Vector3d& nose, double turn_deg,
                double shift_mm, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const auto direction = [&] {
    return Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
  };
  Trial trial;
  const auto live = liveSkin(skin, nose, Misfit::mixed, seed);
  Eigen::Isometry3d place = facing(12 * normal(random), 8 * normal(random), 5 * normal(random)).isometry();
  place.translation() += Eigen::Vector3d(0, 0, 600) - place * nose;
  trial.truth = RigidTransform<Camera, Mri>::fromIsometry(place);
  StereoView view;
  view.seed = seed;
  trial.face = measureSkin(live, nose, trial.truth, view);
  Vector6d off;
  off << turn_deg * M_PI / 180 * direction(), shift_mm * direction();
  trial.guess = RigidTransform<Camera, Mri>::fromIsometry(
      place * registration::increment(off, nose, Eigen::Isometry3d::Identity()));
  return trial;
}

void note(Outcome& outcome, const Trial& trial, const Point<Mri>& target,
          const std::function<PoseMaybe()>& method) {
  PoseMaybe pose;
  const double start_ms = processorTime_ms(), begun_ms = wall_ms();
  pose = method();
  outcome.time_ms.push_back(processorTime_ms() - start_ms);
  outcome.elapsed_ms.push_back(wall_ms() - begun_ms);
  ++outcome.trials;
  if (!pose) return;
  const auto error = poseError(RigidTransform<Camera, Mri>::fromIsometry(*pose), trial.truth, target);
  if (error.at_point_mm < 3 && error.rotation_rad < 3 * M_PI / 180) ++outcome.found;
  outcome.error_mm.push_back(error.at_point_mm);
}

void print(const char* name, const Outcome& o, double ours_ms) {
  std::printf("| %s | %.1f | %.1f | %.1f | %.1f | %.2f | %.2f | %d of %d |\n", name, quantile(o.time_ms, 0.5),
              quantile(o.time_ms, 1.0), quantile(o.time_ms, 0.5) / ours_ms, quantile(o.elapsed_ms, 0.5),
              quantile(o.error_mm, 0.5), quantile(o.error_mm, 1.0), o.found, o.trials);
  std::fflush(stdout);
}

class AlignmentBenchmark {
 public:
  explicit AlignmentBenchmark(const registration::SkinModel& skin)
      : skin_(skin), target_(anatomy::findNoseTip(skin.points.points_mm) + Eigen::Vector3d(-38, -115, 100)) {
    double start_ms = processorTime_ms();
    scalp_ = std::make_unique<ScalpField>(skin_);
    std::printf("Built once a case: our field %.0f ms (%zu vertices)", processorTime_ms() - start_ms,
                skin_.points.size());
    const auto model = toPcl(skin_.points.points_mm, skin_.points.normals);
    start_ms = processorTime_ms();
    for (pcl::Registration<pcl::PointNormal, pcl::PointNormal>* method :
         {static_cast<pcl::Registration<pcl::PointNormal, pcl::PointNormal>*>(&icp_),
          static_cast<pcl::Registration<pcl::PointNormal, pcl::PointNormal>*>(&plane_),
          static_cast<pcl::Registration<pcl::PointNormal, pcl::PointNormal>*>(&gicp_)}) {
      method->setInputTarget(model);
      method->setMaximumIterations(60);
      method->setTransformationEpsilon(1e-8);
    }
    std::printf(", PCL's trees %.0f ms.\n", processorTime_ms() - start_ms);
  }

  void run(double turn_deg, double shift_mm, int trials) {
    const Eigen::Vector3d nose = anatomy::findNoseTip(skin_.points.points_mm);
    Outcome fit, whole, paper, icp, plane, gicp;
    TaskMonitor monitor;
    for (int t = 0; t < trials; ++t) {
      const Trial trial = makeTrial(skin_, nose, turn_deg, shift_mm, std::uint32_t(4000 + 17 * t));
      registration::AlignmentStart start;
      start.guess = trial.guess;
      const auto aligned = [&](const registration::Aligner& aligner) -> PoseMaybe {
        try {
          return aligner.align(*scalp_, trial.face, start, monitor).camera_T_mri.isometry();
        } catch (const Error&) {
          return {};
        }
      };
      note(fit, trial, target_, [&] { return fitOnly(trial, start); });
      note(whole, trial, target_, [&] { return aligned(*registration::makeSurfaceAligner()); });
      note(paper, trial, target_, [&] { return aligned(*peers::makeIcpAligner()); });
      const auto face = toPcl(trial.face.points_mm, {});
      pcl::NormalEstimation<pcl::PointNormal, pcl::PointNormal> normals;
      const auto with_normals = toPcl(trial.face.points_mm, {});
      normals.setInputCloud(face);
      normals.setSearchMethod(pcl::make_shared<pcl::search::KdTree<pcl::PointNormal>>());
      normals.setKSearch(12);
      normals.compute(*with_normals);
      // Largest distance that still works from this start: smaller ones lose it, larger ones let hair attract
      // the fit.
      const double reach_mm = 0.5 * shift_mm + 5;
      icp_.setMaxCorrespondenceDistance(reach_mm);
      plane_.setMaxCorrespondenceDistance(reach_mm);
      gicp_.setMaxCorrespondenceDistance(reach_mm);
      note(icp, trial, target_, [&] { return runPcl(icp_, face, trial.guess.isometry()); });
      note(plane, trial, target_, [&] { return runPcl(plane_, with_normals, trial.guess.isometry()); });
      note(gicp, trial, target_, [&] { return runPcl(gicp_, face, trial.guess.isometry()); });
    }
    std::printf(
        "\nStart %.0f deg, %.0f mm off; %d trials of 20 000 points; processor time (ours uses a second core "
        "where there is one).\n\n",
        turn_deg, shift_mm, trials);
    std::printf(
        "| method | median ms | max ms | times ours | elapsed, median ms | error at the cortex, median mm | "
        "max mm | "
        "within 3 mm and 3 deg |\n|---|---|---|---|---|---|---|---|\n");
    const double ours_ms = quantile(fit.time_ms, 0.5);
    print("ours: robust fit and least squares", fit, ours_ms);
    print("ours with misfit model, error bound and all refusals", whole, ours_ms);
    print("ours `icp` (the paper's)", paper, ours_ms);
    print("pcl::IterativeClosestPoint", icp, ours_ms);
    print("pcl::IterativeClosestPointWithNormals", plane, ours_ms);
    print("pcl::GeneralizedIterativeClosestPoint", gicp, ours_ms);
  }

  /// Counts how often our alignment is lost from many random starts. Misfit moves even the best pose by
  /// millimetres, so the result is compared with the fit that starts from the true pose.
  void starts(double turn_deg, double shift_mm, int trials) {
    const Eigen::Vector3d nose = anatomy::findNoseTip(skin_.points.points_mm);
    Outcome fit;
    int same = 0;
    for (int t = 0; t < trials; ++t) {
      const Trial trial = makeTrial(skin_, nose, turn_deg, shift_mm, std::uint32_t(9000 + 17 * t));
      registration::AlignmentStart start, best_start;
      start.guess = trial.guess;
      best_start.guess = trial.truth;
      const PoseMaybe best = fitOnly(trial, best_start);
      PoseMaybe pose;
      note(fit, trial, target_, [&] { return pose = fitOnly(trial, start); });
      same +=
          best && pose && !registration::areDistinct(best->inverse(), pose->inverse(), target_.mm, 0.017, 1);
    }
    std::printf(
        "\nOurs from %d random starts %.0f deg, %.0f mm off: %d end within 1 mm and 1 deg of where the true "
        "pose leads to, %d within 3 mm and 3 deg of the truth; median %.1f ms, max %.1f ms on one core; it "
        "uses "
        "no second one.\n",
        fit.trials, turn_deg, shift_mm, same, fit.found, quantile(fit.time_ms, 0.5),
        quantile(fit.time_ms, 1.0), quantile(fit.elapsed_ms, 0.5), quantile(fit.elapsed_ms, 1.0));
  }

 private:
  /// Runs only the registration, which is what the peers do.
  PoseMaybe fitOnly(const Trial& trial, const registration::AlignmentStart& start) const {
    const auto fit = registration::fitFromGuess(*scalp_, trial.face, start);
    if (!fit) return {};
    const registration::FieldFitter points(*scalp_, trial.face, fit->points);
    return registration::leastSquares(*scalp_, points, fit->mri_T_camera, fit->limit_mm).inverse();
  }

  registration::SkinModel skin_;
  Point<Mri> target_;
  std::unique_ptr<ScalpField> scalp_;
  pcl::IterativeClosestPoint<pcl::PointNormal, pcl::PointNormal> icp_;
  pcl::IterativeClosestPointWithNormals<pcl::PointNormal, pcl::PointNormal> plane_;
  pcl::GeneralizedIterativeClosestPoint<pcl::PointNormal, pcl::PointNormal> gicp_;
};

}  // namespace
}  // namespace facenav::testing

int main() {
  using namespace facenav::testing;
  std::printf("# Alignment\n\nHead in closed form, live skin off by all kinds of misfit at once (halved).\n");
  AlignmentBenchmark benchmark(ModelHead().skin());
  benchmark.run(15, 30, 8);
  benchmark.run(30, 60, 8);
  benchmark.starts(30, 60, 100);
  return 0;
}
