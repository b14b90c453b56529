#include "part_fits.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/parallel_for.h"
#include "skin_likelihood.h"

namespace facenav::registration {
namespace {

/// A part of the face: quantiles of the points from the patient's left to right and from below to above.
struct Part {
  double left, right, below, above;
};
constexpr Part kParts[] = {{0, 1, 0, 1},   {0, 1, 0, 0.8}, {0, 1, 0, 0.6},      {0, 1, 0, 0.45},
                           {0, 1, 0.3, 1}, {0, 1, 0.5, 1}, {0, 1, 0.6, 0.95},   {0, 1, 0.7, 1},
                           {0, 0.5, 0, 1}, {0.5, 1, 0, 1}, {0.15, 0.85, 0, 0.7}};

constexpr double kNearby_rad = 0.045, kNearby_mm = 2.5;
constexpr float kSettled_mm = 0.02f;  // a fifth of the best pose's standard error
constexpr double kSamePart_rad = 0.002, kSamePart_mm = 0.2;
constexpr double kMet = 0.2;       // share of kSamePart_*; fits to one place end within it
constexpr double kRuledOut = 8.0;  // difference of log likelihoods
constexpr std::size_t kCores = 2;

float quantile(const std::vector<float>& sorted, double fraction) {
  return sorted[std::size_t(fraction * double(sorted.size() - 1))];
}

/// Extent of the points from left to right and from below to above.
class Extent {
 public:
  explicit Extent(const std::vector<PointMatch>& matches) : matches_(matches) {
    for (const PointMatch& m : matches)
      if (m.is_valid) x_.push_back(m.at_mri_mm.x()), z_.push_back(m.at_mri_mm.z());
    std::sort(x_.begin(), x_.end());
    std::sort(z_.begin(), z_.end());
  }
  /// Indices among `points`, in the order of the matches, that belong to the part.
  std::vector<int> members(const Part& part, const std::vector<int>& points) const {
    std::vector<int> out;
    if (x_.empty()) return out;
    const float left = quantile(x_, part.left), right = quantile(x_, part.right),
                below = quantile(z_, part.below), above = quantile(z_, part.above);
    for (std::size_t p = 0; p < matches_.size(); ++p) {
      const Eigen::Vector3f& at = matches_[p].at_mri_mm;
      if (at.x() >= left && at.x() <= right && at.z() >= below && at.z() <= above) out.push_back(points[p]);
    }
    return out;
  }

 private:
  const std::vector<PointMatch>& matches_;
  std::vector<float> x_, z_;
};

/// Fits poses with all points until they settle. Only one of several poses that meet on the way is fitted
/// further, and only one of those that end at the same place is judged.
class Followed {
 public:
  using Poses = std::vector<Eigen::Isometry3d>;

  Followed(const ScalpField& scalp, const FieldFitter& all, const SkinLikelihood& log_likelihood,
           double noise_mm)
      : scalp_(scalp), all_(all), log_likelihood_(log_likelihood), noise_mm_(float(noise_mm)) {}

  void add(Poses poses) {
    keepNew(poses, begun_, 1);
    fitAll(poses, std::max(1.6f, kNoiseReach * noise_mm_));
    keepNew(poses, between_, 1);
    fitAll(poses, std::max(1.2f, kNoiseReach * noise_mm_));
    keepNew(poses, ended_, kMet);
    std::vector<PartFit> judged(poses.size());
    parallelFor(poses.size(), kCores, [&](std::size_t p, std::size_t) {
      judged[p] = {poses[p], log_likelihood_(all_.match(poses[p]))};
    });
    fits_.insert(fits_.end(), judged.begin(), judged.end());
  }

  const std::vector<PartFit>& likeliestFirst() {
    std::sort(fits_.begin(), fits_.end(),
              [](const PartFit& a, const PartFit& b) { return a.log_likelihood > b.log_likelihood; });
    return fits_;
  }

  bool isNew(const Poses& met, const Eigen::Isometry3d& pose, double of_same) const {
    return std::all_of(met.begin(), met.end(), [&](const Eigen::Isometry3d& m) {
      return areDistinct(m, pose, scalp_.middle_mm(), of_same * kSamePart_rad, of_same * kSamePart_mm);
    });
  }

 private:
  void fitAll(Poses& poses, float reach_mm) const {
    parallelFor(poses.size(), kCores, [&](std::size_t p, std::size_t) {
      poses[p] = all_.fit(poses[p], {reach_mm, 0.67f * reach_mm, 4, true, kSettled_mm});
    });
  }

  /// Keeps those of `poses` that differ from all in `met` and from each other, and adds them to `met`.
  void keepNew(Poses& poses, Poses& met, double of_same) const {
    Poses kept;
    for (const auto& pose : poses) {
      if (!isNew(met, pose, of_same)) continue;
      met.push_back(pose);
      kept.push_back(pose);
    }
    poses = std::move(kept);
  }

  const ScalpField& scalp_;
  const FieldFitter& all_;
  const SkinLikelihood& log_likelihood_;
  const float noise_mm_;
  Poses begun_, between_, ended_;
  std::vector<PartFit> fits_;
};

}  // namespace

std::vector<PartFit> fitParts(const ScalpField& scalp, const PointCloud<Camera>& face,
                              const std::vector<int>& points, const Eigen::Isometry3d& mri_T_camera,
                              double noise_mm) {
  const FieldFitter all(scalp, face, points);
  const SkinLikelihood logLikelihood(scalp, face, points, noise_mm);
  const float least_mm = kNoiseReach * float(noise_mm);
  const auto matches = all.match(mri_T_camera);
  const Extent extent(matches);
  Followed followed(scalp, all, logLikelihood, noise_mm);
  std::vector<Eigen::Isometry3d> starts(std::size(kParts), mri_T_camera);
  parallelFor(starts.size(), kCores, [&](std::size_t part, std::size_t) {
    const FieldFitter alone(scalp, face, extent.members(kParts[part], points));
    for (const float reach_mm : {6.0f, 4.0f, std::max(2.5f, least_mm), std::max(1.5f, least_mm)})
      starts[part] = alone.fit(starts[part], {reach_mm, 0.67f * reach_mm, 4, true, kSettled_mm});
  });
  followed.add(std::move(starts));
  // On a forehead alone every part may lead to a local optimum beside the best pose.
  starts.assign(12, followed.likeliestFirst().front().mri_T_camera);
  parallelFor(starts.size(), kCores, [&](std::size_t side, std::size_t) {
    Vector6d off = Vector6d::Zero();
    const std::size_t axis = side / 2;
    off[Eigen::Index(axis)] = (side % 2 ? 1.0 : -1.0) * (axis < 3 ? kNearby_rad : kNearby_mm);
    starts[side] =
        all.fit(increment(off, scalp.noseTip_mm(), starts[side]),
                {std::max(2.5f, least_mm), std::max(1.7f, 0.67f * least_mm), 3, true, kSettled_mm});
  });
  followed.add(std::move(starts));
  const std::vector<PartFit>& poses = followed.likeliestFirst();
  std::vector<PartFit> left;
  std::vector<Eigen::Isometry3d> places;
  for (const PartFit& pose : poses) {
    if (pose.log_likelihood < poses.front().log_likelihood - kRuledOut) break;
    if (!followed.isNew(places, pose.mri_T_camera, 1)) continue;
    places.push_back(pose.mri_T_camera);
    left.push_back(pose);
  }
  return left;
}

}  // namespace facenav::registration
