#include "start_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "cloud/cloud_sampling.h"
#include "cloud/skin_patches.h"
#include "facenav/core/error.h"
#include "facenav/core/robust_statistics.h"
#include "start_poses.h"

namespace facenav::registration {
namespace {

/// For each seed, the points of the cloud within the size of a head.
struct Seeds {
  std::vector<Eigen::Vector3d> at_mm;
  std::vector<std::vector<Eigen::Vector3f>> around_mm;
};

Seeds seedsOf(const PointCloud<Camera>& face, const std::vector<int>& sparse) {
  constexpr double kReach_mm = 150.0;
  Seeds seeds;
  seeds.at_mm = pick(face, thinOut(face, sparse, 32.0, 120)).points_mm;
  const auto points = pick(face, thinOut(face, sparse, 22.0, 400)).points_mm;
  for (const auto& seed : seeds.at_mm) {
    seeds.around_mm.emplace_back();
    for (const auto& p : points)
      if ((p - seed).squaredNorm() < kReach_mm * kReach_mm) seeds.around_mm.back().push_back(p.cast<float>());
  }
  return seeds;
}

/// Sum over points of how well the skin explains them: 1 for a point on the skin, 0 for one far outside, down
/// to -0.3 for one deep inside (necks bend).
float gain(const ScalpField& scalp, const std::vector<Eigen::Vector3f>& points_mm,
           const Eigen::Isometry3d& mri_T_camera) {
  constexpr float kReach_mm = 22.f;
  const Eigen::Matrix3f r = mri_T_camera.linear().cast<float>();
  const Eigen::Vector3f t = mri_T_camera.translation().cast<float>();
  float sum = 0;
  for (const auto& p : points_mm) {
    const float u = scalp.coarse(r * p + t).distance_mm / kReach_mm;
    if (u < 1) sum += std::max(-0.3f, 1 - (u < 0 ? 2 : 1) * u * u);
  }
  return sum;
}

/// Places the skin's foremost point at each seed; keeps the best `most` that are distinct.
void addPlacements(const ScalpField& scalp, const Seeds& seeds, const Eigen::Matrix3d& camera_R_mri,
                   std::size_t most, std::vector<Candidate>& out) {
  const double apart_mm = 100.0 / double(most);
  const Eigen::Vector3d foremost = foremostSkin(scalp, camera_R_mri.transpose() * Eigen::Vector3d(0, 0, -1));
  std::vector<std::pair<float, std::size_t>> order;
  for (std::size_t s = 0; s < seeds.at_mm.size(); ++s)
    order.emplace_back(-gain(scalp, seeds.around_mm[s], placed(camera_R_mri, foremost, seeds.at_mm[s])), s);
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> best;
  for (const auto& [loss, s] : order) {
    if (best.size() >= most) break;
    const bool is_apart = std::all_of(best.begin(), best.end(), [&, seed = s](std::size_t b) {
      return (seeds.at_mm[b] - seeds.at_mm[seed]).norm() > apart_mm;
    });
    if (!is_apart) continue;
    best.push_back(s);
    out.push_back({placed(camera_R_mri, foremost, seeds.at_mm[s]), double(loss)});
  }
}

/// Orientations to try, and the guess unchanged.
std::vector<Candidate> roughPoses(const ScalpField& scalp, const PointCloud<Camera>& face,
                                  const std::vector<int>& sparse, const AlignmentStart& start,
                                  SearchWidth width, TaskMonitor& monitor) {
  std::vector<Candidate> out;
  std::vector<Eigen::Matrix3d> turns;
  const auto hinted = hintedOrientation(start);
  const bool is_near = width == SearchWidth::near && (start.guess || hinted);
  if (is_near && start.guess) {
    turns = orientationsAround(start.guess->rotation(), 24.0);
    for (const auto& turn : turns)
      out.push_back({placed(turn, scalp.middle_mm(), (*start.guess * Point<Mri>(scalp.middle_mm())).mm), 0});
  } else {
    turns = is_near ? orientationsAround(*hinted, 24.0) : facingOrientations(width == SearchWidth::thorough);
  }
  const Seeds seeds = seedsOf(face, sparse);
  for (std::size_t r = 0; r < turns.size(); ++r) {
    monitor.report("searching the head", double(r) / double(turns.size()));
    addPlacements(scalp, seeds, turns[r], width == SearchWidth::thorough ? 4 : 2, out);
    if (start.nose_tip && is_near)
      out.push_back({placed(turns[r], scalp.noseTip_mm(), start.nose_tip->mm), 0});
  }
  return out;
}

void keepDistinct(std::vector<Candidate>& candidates, const Eigen::Vector3d& pivot, std::size_t most) {
  std::sort(candidates.begin(), candidates.end(),
            [](const auto& a, const auto& b) { return a.cost < b.cost; });
  std::vector<Candidate> kept;
  for (const Candidate& c : candidates) {
    if (kept.size() >= most) break;
    const bool is_new = std::all_of(kept.begin(), kept.end(), [&](const Candidate& k) {
      return areDistinct(k.mri_T_camera, c.mri_T_camera, pivot, 6 * kRadPerDeg, 12.0);
    });
    if (is_new && seesTheFace(c.mri_T_camera, pivot)) kept.push_back(c);
  }
  candidates = std::move(kept);
}

void refine(std::vector<Candidate>& candidates, const FieldFitter& fitter,
            std::initializer_list<FitStage> stages, double truncation_mm) {
  for (Candidate& c : candidates) {
    for (const FitStage& stage : stages) c.mri_T_camera = fitter.fit(c.mri_T_camera, stage);
    c.cost = fitter.cost(c.mri_T_camera, truncation_mm);
  }
}

std::vector<int> sparsePoints(const PointCloud<Camera>& face) {
  constexpr std::size_t kMostLooked = 8000;
  return thinOut(face, someOf(finitePoints(face), kMostLooked), 5.0, 4000);
}

/// True if most of the cloud lies on the skin, by a coarse measure.
bool isExplained(const ScalpField& scalp, const FieldFitter& fitter, const Eigen::Isometry3d& mri_T_camera) {
  constexpr double kReach_mm = 4.0, kUnexplained = 0.4;
  return seesTheFace(mri_T_camera, scalp.middle_mm()) &&
         fitter.cost(mri_T_camera, kReach_mm) < kUnexplained * kReach_mm * kReach_mm;
}

/// Median of the points, and mean of the nearest fiftieth.
std::pair<Eigen::Vector3d, Eigen::Vector3d> middleAndForemost(const PointCloud<Camera>& face,
                                                              const std::vector<int>& points) {
  constexpr std::size_t kShare = 50;
  std::vector<double> axis[3];
  for (const int p : points)
    for (int a = 0; a < 3; ++a) axis[a].push_back(face.points_mm[std::size_t(p)][a]);
  if (points.empty()) return {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  std::vector<int> near = points;
  const std::size_t count = std::min(near.size(), near.size() / kShare + 1);
  std::nth_element(near.begin(), near.begin() + std::ptrdiff_t(count) - 1, near.end(), [&](int p, int q) {
    return face.points_mm[std::size_t(p)].z() < face.points_mm[std::size_t(q)].z();
  });
  Eigen::Vector3d foremost = Eigen::Vector3d::Zero();
  for (std::size_t n = 0; n < count; ++n) foremost += face.points_mm[std::size_t(near[n])] / double(count);
  return {Eigen::Vector3d(upperMedian(axis[0]), upperMedian(axis[1]), upperMedian(axis[2])), foremost};
}

/// The best fit from starts turned about `begun_ended[0]`. The head stays at its place, or its nose is placed
/// in front of the cloud's middle, or at the cloud's nearest part.
Candidate fromAround(const ScalpField& scalp, const PointCloud<Camera>& face, const std::vector<int>& points,
                     const FieldFitter& coarse, const std::array<Eigen::Isometry3d, 2>& begun_ended) {
  constexpr double kTurn_deg = 24.0, kNose_mm = 25.0;
  const FieldFitter coarsest(scalp, face, thinOut(face, points, 15.0, 400));
  const Eigen::Isometry3d camera_T_mri = begun_ended[0].inverse();
  const auto [middle, foremost] = middleAndForemost(face, points);
  std::vector<Candidate> candidates{{begun_ended[1], 0.0}};
  for (const auto& turn : orientationsAround(camera_T_mri.linear(), kTurn_deg)) {
    candidates.push_back({placed(turn, scalp.middle_mm(), camera_T_mri * scalp.middle_mm()), 0.0});
    candidates.push_back({placed(turn, scalp.noseTip_mm(), (1 - kNose_mm / middle.norm()) * middle), 0.0});
    candidates.push_back({placed(turn, scalp.noseTip_mm(), foremost), 0.0});
  }
  refine(candidates, coarsest, {{40, 28, 4, false}, {20, 14, 4, false}}, 12.0);
  keepDistinct(candidates, scalp.middle_mm(), 8);
  refine(candidates, coarse, {{16, 11, 5, false}, {10, 7, 4, false}}, 6.0);
  keepDistinct(candidates, scalp.middle_mm(), 3);
  refine(candidates, coarse, {{8, 5, 4, false}}, 4.0);
  keepDistinct(candidates, scalp.middle_mm(), 1);
  return candidates.empty() ? Candidate{begun_ended[1], 0.0} : candidates.front();
}

}  // namespace

std::vector<int> nearHead(const ScalpField& scalp, const PointCloud<Camera>& face,
                          const std::vector<int>& points, const Eigen::Isometry3d& mri_T_camera,
                          double reach_mm) {
  std::vector<int> near = FieldFitter(scalp, face, points).within(mri_T_camera, reach_mm);
  for (int& p : near) p = points[std::size_t(p)];
  return near;
}

std::vector<Candidate> findStarts(const ScalpField& scalp, const PointCloud<Camera>& face,
                                  const AlignmentStart& start, SearchWidth width, std::size_t most,
                                  TaskMonitor& monitor) {
  const std::vector<int> dense = sparsePoints(face);
  const FieldFitter coarsest(scalp, face, thinOut(face, dense, 15.0, 400)),
      coarse(scalp, face, thinOut(face, dense, 9.0, 1200)), denser(scalp, face, dense);
  const Eigen::Vector3d pivot = scalp.middle_mm();
  auto candidates = roughPoses(scalp, face, dense, start, width, monitor);
  refine(candidates, coarsest, {{40, 28, 4, false}, {20, 14, 4, false}}, 12.0);
  keepDistinct(candidates, pivot, 6 * most);
  refine(candidates, coarse, {{16, 11, 5, false}, {10, 7, 4, false}}, 6.0);
  keepDistinct(candidates, pivot, 2 * most);
  refine(candidates, denser, {{8, 5, 5, false}, {5, 3, 5, false}}, 4.0);
  keepDistinct(candidates, pivot, most);
  if (candidates.empty())
    throw NotEnoughFace("not aligned: nothing like a face was measured", {},
                        "show the whole face to both cameras");
  return candidates;
}

std::optional<Candidate> descend(const ScalpField& scalp, const PointCloud<Camera>& face,
                                 const AlignmentStart& start) {
  const auto hinted = hintedOrientation(start);
  Candidate c;
  if (start.guess)
    c.mri_T_camera = start.guess->isometry().inverse();
  else if (hinted && start.nose_tip)
    c.mri_T_camera = placed(*hinted, scalp.noseTip_mm(), start.nose_tip->mm);
  else
    return {};
  const std::vector<int> dense = sparsePoints(face);
  const FieldFitter coarse(scalp, face, thinOut(face, dense, 12.0, 600)), denser(scalp, face, dense);
  const Eigen::Isometry3d begun = c.mri_T_camera;
  for (const FitStage& stage : {FitStage{70, 60, 5, false}, FitStage{40, 30, 5, false},
                                FitStage{20, 14, 6, false}, FitStage{10, 7, 5, false}})
    c.mri_T_camera = coarse.fit(c.mri_T_camera, stage);
  // The person who gave the start knew which way is up. A fit that turned the head upside down did not follow
  // it.
  constexpr double kFarthestTurn = 60 * kRadPerDeg;
  const Eigen::Isometry3d led = begun * c.mri_T_camera.inverse();
  if (rotationAngle(led.linear()) > kFarthestTurn || !isExplained(scalp, coarse, c.mri_T_camera))
    c = fromAround(scalp, face, dense, coarse, {begun, c.mri_T_camera});
  c.mri_T_camera = denser.fit(c.mri_T_camera, {6, 4, 6, false});
  c.cost = denser.cost(c.mri_T_camera, 4.0);
  if (!seesTheFace(c.mri_T_camera, scalp.middle_mm())) return {};
  return c;
}

}  // namespace facenav::registration
