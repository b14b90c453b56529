// The misfit model on an ellipsoid whose patches are known in closed form: a pose error must be recovered
// from the residuals, and the bound must hold for misfit drawn from the model's own prior.

#include "confidence/misfit_model.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <random>

#include "facenav/geometry/normal_equations.h"
#include "facenav/registration/pose_uncertainty.h"
#include "support/changed_settings.h"
#include "support/model_head.h"

namespace facenav::registration {
namespace {

using facenav::testing::ChangedSettings;
using facenav::testing::towards;

const Eigen::Vector3d kRadii_mm(75, 95, 110), kPivot(0, 0, 20), kTarget_mm(-40, -10, 60);
const anatomy::FaceRegions kRegions(Eigen::Vector3d(0, 112, -25));

/// Patches about 14 mm apart on the ellipsoid's front, without misfit.
std::vector<SkinPatch> face(double least_up_deg = -35, double most_up_deg = 45, double most_right_deg = 55,
                            double step_deg = 8) {
  std::vector<SkinPatch> patches;
  for (double up = least_up_deg; up <= most_up_deg; up += step_deg)
    for (double right = -most_right_deg; right <= most_right_deg; right += 1.25 * step_deg) {
      const Eigen::Vector3d direction = towards(right, up);
      SkinPatch patch;
      patch.at_mri_mm = direction / direction.cwiseQuotient(kRadii_mm).norm();
      patch.normal = patch.at_mri_mm.cwiseQuotient(kRadii_mm.cwiseProduct(kRadii_mm)).normalized();
      patch.jacobian << (patch.at_mri_mm - kPivot).cross(patch.normal), patch.normal;
      patch.noise_mm = 0.05;
      patch.points = 100;
      patches.push_back(patch);
    }
  return patches;
}

void addPoseError(std::vector<SkinPatch>& patches, const Vector6d& error) {
  for (auto& patch : patches) patch.residual_mm += patch.jacobian.dot(error);
}

Vector6d someError() {
  Vector6d error;
  error << 0.004, -0.006, 0.003, 0.5, -0.8, 0.3;
  return error;
}

/// Adds smooth misfit of that size and reach, and white noise, drawn from `random`.
void addField(std::vector<SkinPatch>& patches, double size_mm, double reach_mm, double soft,
              std::mt19937& random) {
  std::normal_distribution<double> normal;
  const auto n = Eigen::Index(patches.size());
  Eigen::MatrixXd k(n, n);
  const auto sizeAt = [&](const SkinPatch& p) {
    return size_mm * (1 + (soft - 1) * kRegions.softness(p.at_mri_mm));
  };
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) {
      const SkinPatch &a = patches[std::size_t(i)], &b = patches[std::size_t(j)];
      const double u = std::sqrt(3.0) * (a.at_mri_mm - b.at_mri_mm).norm() / reach_mm;
      k(i, j) = sizeAt(a) * sizeAt(b) * (1 + u) * std::exp(-u) + (i == j ? 1e-9 : 0.0);
    }
  const Eigen::MatrixXd root = k.llt().matrixL();
  Eigen::VectorXd white(n);
  for (Eigen::Index i = 0; i < n; ++i) white[i] = normal(random);
  const Eigen::VectorXd field = root * white;
  for (Eigen::Index i = 0; i < n; ++i)
    patches[std::size_t(i)].residual_mm += field[i] + patches[std::size_t(i)].noise_mm * normal(random);
}

double bound_mm(const PosePosterior& posterior, const Eigen::Vector3d& target = kTarget_mm) {
  // Camera is Mri here. The model's shift is that of the pivot, the uncertainty's that of the origin.
  Matrix6d at_origin = Matrix6d::Identity();
  at_origin.bottomLeftCorner<3, 3>() = skew(kPivot);
  return PoseUncertainty{at_origin * posterior.covariance * at_origin.transpose(), posterior.freedom}
      .errorBound_mm({}, Point<Mri>(target));
}

TEST(MisfitModel, FindsAPoseErrorAmongResidualsWithoutMisfit) {
  auto patches = face();
  addPoseError(patches, someError());
  const Vector6d found = poseError(patches, kRegions, kPivot);
  EXPECT_LT((found - someError()).head<3>().norm(), 1e-4);
  EXPECT_LT((found - someError()).tail<3>().norm(), 5e-3);
  const PosePosterior posterior = posteriorOf(patches, kRegions, kPivot, MisfitPrior());
  EXPECT_LT((posterior.error - someError()).tail<3>().norm(), 5e-3);
}

TEST(MisfitModel, TheCovarianceIsSymmetricAndPositive) {
  std::mt19937 random(3);
  auto patches = face();
  addField(patches, 0.3, 25, 2.5, random);
  const PosePosterior posterior = posteriorOf(patches, kRegions, kPivot, MisfitPrior());
  EXPECT_LT((posterior.covariance - posterior.covariance.transpose()).norm(),
            1e-9 * posterior.covariance.norm());
  EXPECT_GT(principalAxes(posterior.covariance).values[0], 0.0);
  EXPECT_GE(posterior.freedom, 5.0);
  EXPECT_LE(posterior.freedom, 60.0);
  EXPECT_GT(posterior.scale_sigma, 0.0);
}

/// The bound grows on average: the size of the misfit is estimated from each sample.
TEST(MisfitModel, TheBoundGrowsAsLessOfTheFaceIsSeen) {
  constexpr std::uint32_t kSeeds = 12;
  double last = 0;
  for (const auto& [low, high, side] :
       {std::array{-35.0, 45.0, 55.0}, std::array{-3.0, 45.0, 45.0}, std::array{13.0, 45.0, 35.0}}) {
    double mean = 0;
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
      auto patches = face(low, high, side);
      std::mt19937 random(seed);
      addField(patches, 0.3, 25, 1, random);
      mean += bound_mm(posteriorOf(patches, kRegions, kPivot, MisfitPrior())) / kSeeds;
    }
    EXPECT_GT(mean, last) << "from " << low << " degrees up";
    last = mean;
  }
}

/// A depth error common to the whole face is a shift along the view.
TEST(MisfitModel, AnErrorOfTheCloudThatAllOfItSharesIsAShiftAlongTheView) {
  constexpr double kSigma_mm = 0.4;
  const Eigen::Vector3d view = Eigen::Vector3d(0.2, 1.0, -0.1).normalized();
  auto patches = face();
  std::mt19937 random(3);
  addField(patches, 0.2, 25, 1, random);
  const SeenFrom far{kPivot + 1e7 * view, {kSigma_mm, 1e6}};
  const auto without = posteriorOf(patches, kRegions, kPivot, MisfitPrior());
  const auto with = posteriorOf(patches, kRegions, kPivot, MisfitPrior(), far);
  const Matrix6d added = with.covariance - without.covariance;
  const Eigen::Matrix3d shift = added.bottomRightCorner<3, 3>(), turn = added.topLeftCorner<3, 3>();
  EXPECT_NEAR(view.dot(shift * view), kSigma_mm * kSigma_mm, 1e-4);
  EXPECT_NEAR(shift.trace(), kSigma_mm * kSigma_mm, 1e-4);
  EXPECT_LT(std::abs(turn.trace()), 1e-10) << "rad2; a difference, so that rounding may leave less than 0";
  EXPECT_EQ((with.error - without.error).norm(), 0.0) << "the pose itself does not follow it";
}

TEST(MisfitModel, AnErrorThatNeighboursShareIsCounted) {
  auto patches = face();
  const auto bound = [&](double sigma_mm, double reach_mm) {
    return bound_mm(posteriorOf(patches, kRegions, kPivot, MisfitPrior(),
                                {kPivot + Eigen::Vector3d(0, 600, 0), {sigma_mm, reach_mm}}));
  };
  EXPECT_GT(bound(0.3, 40), 1.2 * bound(0.0, 40));
  EXPECT_GT(bound(0.3, 40), bound(0.3, 10)) << "what fewer share averages out";
}

TEST(MisfitModel, TheBoundAndTheFieldGrowWithTheMisfit) {
  const auto of = [](double size_mm) {
    std::mt19937 random(4);
    auto patches = face();
    addField(patches, size_mm, 25, 1, random);
    return posteriorOf(patches, kRegions, kPivot, MisfitPrior());
  };
  const PosePosterior small = of(0.1), large = of(0.8);
  EXPECT_GT(large.field_mm, 2.5 * small.field_mm);
  EXPECT_GT(bound_mm(large), 1.5 * bound_mm(small));
}

TEST(MisfitModel, NinetyFivePercentOfErrorsLieWithinTheBound) {
  std::mt19937 random(17);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0, 1);
  const MisfitPrior prior;
  const auto drawn = [&](const MisfitPrior::Sizes& sizes) {
    double left = uniform(random);
    for (const auto& [sigma, share] : sizes)
      if ((left -= share) < 0) return sigma * normal(random);
    return sizes.back().first * normal(random);
  };
  constexpr int kDraws = 60;
  int within = 0;
  std::vector<double> used;
  for (int draw = 0; draw < kDraws; ++draw) {
    auto patches = face(-35, 45, 55, 12);
    const double reach_mm = std::array{12.0, 25.0, 50.0, 100.0}[random() % 4];
    addField(patches, prior.field_mm * std::exp(prior.field_spread * normal(random)), reach_mm,
             random() % 2 ? 1.0 : 2.5, random);
    const double offset_mm = drawn(prior.offsets_mm);
    const Eigen::Vector3d scale(drawn(prior.scales), drawn(prior.scales), drawn(prior.scales));
    for (auto& patch : patches)
      patch.residual_mm += offset_mm + patch.normal.cwiseProduct(patch.at_mri_mm - kPivot).dot(scale);
    addPoseError(patches, someError());
    const PosePosterior posterior = posteriorOf(patches, kRegions, kPivot, prior);
    const Vector6d left = posterior.error - someError();
    const double error_mm = (left.head<3>().cross(kTarget_mm - kPivot) + left.tail<3>()).norm();
    within += error_mm <= bound_mm(posterior);
    used.push_back(error_mm / bound_mm(posterior));
  }
  // 57 of 60 are expected, 1.7 one standard deviation.
  EXPECT_GE(within, 52);
  std::sort(used.begin(), used.end());
  EXPECT_GT(used[kDraws / 2], 0.15) << "no use if it says too much";
}

TEST(MisfitModel, AFaceOfAnotherSizeShowsItsScale) {
  for (const double scale : {-0.02, 0.01}) {
    auto patches = face();
    std::mt19937 random(6);
    addField(patches, 0.05, 12, 1, random);
    for (auto& patch : patches) patch.residual_mm += scale * patch.normal.dot(patch.at_mri_mm - kPivot);
    const PosePosterior posterior = posteriorOf(patches, kRegions, kPivot, MisfitPrior());
    EXPECT_NEAR(posterior.scale, scale, 3 * posterior.scale_sigma);
    EXPECT_LT(posterior.scale_sigma, 0.01);
  }
}

TEST(MisfitModel, OnePatchThatNothingExplainsWidensTheNoiseNotThePose) {
  std::mt19937 random(7);
  auto patches = face();
  addField(patches, 0.1, 25, 1, random);
  const PosePosterior without = posteriorOf(patches, kRegions, kPivot, MisfitPrior());
  patches[patches.size() / 3].residual_mm += 1.4;
  const Vector6d simple = poseError(patches, kRegions, kPivot);
  const PosePosterior with = posteriorOf(patches, kRegions, kPivot, MisfitPrior());
  EXPECT_LT((with.error - without.error).tail<3>().norm(), 0.3 * (simple - without.error).tail<3>().norm());
}

TEST(MisfitPrior, AWiderPriorGivesAWiderBound) {
  std::mt19937 random(8);
  auto patches = face();
  addField(patches, 0.2, 25, 1, random);
  MisfitPrior narrow, wide;
  for (auto& size : narrow.offsets_mm) size.first = 0.05;
  for (auto& size : narrow.scales) size.first = 0.0005;
  for (auto& size : wide.offsets_mm) size.first = 2.0;
  for (auto& size : wide.scales) size.first = 0.03;
  EXPECT_GT(bound_mm(posteriorOf(patches, kRegions, kPivot, wide)),
            1.05 * bound_mm(posteriorOf(patches, kRegions, kPivot, narrow)));
}

TEST(MisfitPrior, TheWorkingOffsetDecidesHowMuchAnOffsetOfTheWholeSkinMovesThePose) {
  auto patches = face();
  for (auto& patch : patches) patch.residual_mm = 0.5;
  const auto moved_mm = [&](double working_offset_mm) {
    ChangedSettings<MisfitPrior> settings;
    settings->working_offset_mm = working_offset_mm;
    return poseError(patches, kRegions, kPivot).tail<3>().norm();
  };
  EXPECT_LT(moved_mm(5.0), 0.05) << "an offset explains it all";
  EXPECT_GT(moved_mm(0.01), 0.2) << "the head must have moved";
  EXPECT_EQ(settingsOf<MisfitPrior>().working_offset_mm, MisfitPrior().working_offset_mm);
}

}  // namespace
}  // namespace facenav::registration
