#include "part_fits.h"

#include <algorithm>
#include <cmath>

#include "skin_likelihood.h"

namespace facenav::registration {
namespace {

/// A part: between these quantiles of the points, from the patient's left to right and from below to above.
struct Part {
  double left, right, below, above;
};
constexpr Part kParts[] = {{0, 1, 0, 1},   {0, 1, 0, 0.8}, {0, 1, 0, 0.6},      {0, 1, 0, 0.45},
                           {0, 1, 0.3, 1}, {0, 1, 0.5, 1}, {0, 1, 0.6, 0.95},   {0, 1, 0.7, 1},
                           {0, 0.5, 0, 1}, {0.5, 1, 0, 1}, {0.15, 0.85, 0, 0.7}};

constexpr double kNearby_rad = 0.045, kNearby_mm = 2.5;
constexpr float kSettled_mm = 0.02f;  // a fifth of what the best pose is uncertain by
constexpr double kSame_rad = 0.002, kSame_mm = 0.2;
constexpr double kMet = 0.2;       // of these: as far as fits settle
constexpr double kRuledOut = 8.0;  // logarithm of odds

float quantile(const std::vector<float>& sorted, double fraction) {
  return sorted[std::size_t(fraction * double(sorted.size() - 1))];
}

/// Where the points lie, from left to right and from below to above.
class Extent {
 public:
  explicit Extent(const std::vector<PointMatch>& matches) : matches_(matches) {
    for (const PointMatch& m : matches)
      if (m.is_valid) x_.push_back(m.at_mri_mm.x()), z_.push_back(m.at_mri_mm.z());
    std::sort(x_.begin(), x_.end());
    std::sort(z_.begin(), z_.end());
  }
  /// Those of `points`, in the order of the matches, that belong to the part.
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

}  // namespace

std::vector<PartFit> fitParts(const ScalpField& scalp, const PointCloud<Camera>& face,
                              const std::vector<int>& points, const Eigen::Isometry3d& mri_T_camera) {
  const FieldFitter all(scalp, face, points);
  const SkinLikelihood logLikelihood(scalp, face, points);
  const auto matches = all.match(mri_T_camera);
  const Extent extent(matches);
  // Where several lead to the same place, one of them is followed to its end; where ends meet, one is judged.
  std::vector<PartFit> poses;
  const auto isNew = [&](const std::vector<Eigen::Isometry3d>& met, const Eigen::Isometry3d& pose,
                         double of_same) {
    return std::all_of(met.begin(), met.end(), [&](const Eigen::Isometry3d& m) {
      return areDistinct(m, pose, scalp.middle_mm(), of_same * kSame_rad, of_same * kSame_mm);
    });
  };
  std::vector<Eigen::Isometry3d> begun, between, ended;
  const auto closeIn = [&](Eigen::Isometry3d pose) {
    if (!isNew(begun, pose, 1)) return;
    begun.push_back(pose);
    pose = all.fit(pose, {1.6f, 0.67f * 1.6f, 4, true, kSettled_mm});
    if (!isNew(between, pose, 1)) return;
    between.push_back(pose);
    pose = all.fit(pose, {1.2f, 0.67f * 1.2f, 4, true, kSettled_mm});
    if (!isNew(ended, pose, kMet)) return;
    ended.push_back(pose);
    poses.push_back({pose, logLikelihood(all.match(pose))});
  };
  for (const Part& part : kParts) {
    const FieldFitter alone(scalp, face, extent.members(part, points));
    Eigen::Isometry3d pose = mri_T_camera;
    for (const float reach_mm : {6.0f, 4.0f, 2.5f, 1.5f})
      pose = alone.fit(pose, {reach_mm, 0.67f * reach_mm, 4, true, kSettled_mm});
    closeIn(pose);
  }
  const auto likeliest_first = [](const PartFit& a, const PartFit& b) {
    return a.log_likelihood > b.log_likelihood;
  };
  std::sort(poses.begin(), poses.end(), likeliest_first);
  // On a forehead alone every part may lead to a neighbour of the best pose.
  const Eigen::Isometry3d centre = poses.front().mri_T_camera;
  for (int axis = 0; axis < 6; ++axis)
    for (const double side : {-1.0, 1.0}) {
      Vector6d off = Vector6d::Zero();
      off[axis] = side * (axis < 3 ? kNearby_rad : kNearby_mm);
      closeIn(all.fit(increment(off, scalp.noseTip_mm(), centre), {2.5f, 1.7f, 3, true, kSettled_mm}));
    }
  std::sort(poses.begin(), poses.end(), likeliest_first);
  std::vector<PartFit> left;
  std::vector<Eigen::Isometry3d> places;
  for (const PartFit& pose : poses) {
    if (pose.log_likelihood < poses.front().log_likelihood - kRuledOut) break;
    if (!isNew(places, pose.mri_T_camera, 1)) continue;
    places.push_back(pose.mri_T_camera);
    left.push_back(pose);
  }
  return left;
}

}  // namespace facenav::registration
