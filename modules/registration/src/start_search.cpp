#include "start_search.h"

#include <algorithm>
#include <cmath>

#include "cloud_sampling.h"
#include "facenav/core/error.h"

namespace facenav::registration {
namespace {

constexpr double kDeg = M_PI / 180.0;

/// camera_R_mri of a patient who looks at the camera, upright in the image.
Eigen::Matrix3d facingCamera() {
  Eigen::Matrix3d r;
  r << -1, 0, 0, 0, 0, -1, 0, -1, 0;
  return r;
}

/// Orientation with the hinted up and right directions; nothing when there is no hint.
std::optional<Eigen::Matrix3d> hintedOrientation(const AlignmentStart& start) {
  const auto frame = [](const Eigen::Vector3d& right, const Eigen::Vector3d& up) {
    Eigen::Matrix3d r;
    r.col(2) = up.normalized();
    r.col(0) = (right - right.dot(r.col(2)) * r.col(2)).normalized();
    r.col(1) = r.col(2).cross(r.col(0));
    return r;
  };
  const Eigen::Vector3d towards_camera(0, 0, -1);
  if (start.patient_right && start.patient_superior) {
    if (std::abs(start.patient_right->v.dot(start.patient_superior->v)) > 0.9) return {};
    return frame(start.patient_right->v, start.patient_superior->v);
  }
  // anterior = superior x right
  if (start.patient_superior && std::abs(start.patient_superior->v.z()) < 0.9)
    return frame(towards_camera.cross(start.patient_superior->v), start.patient_superior->v);
  if (start.patient_right && std::abs(start.patient_right->v.z()) < 0.9)
    return frame(start.patient_right->v, start.patient_right->v.cross(towards_camera));
  return {};
}

std::vector<Eigen::Matrix3d> orientations(const AlignmentStart& start, const SearchExtent& extent) {
  std::vector<Eigen::Matrix3d> out;
  const auto around = [&](const Eigen::Matrix3d& base, std::initializer_list<double> yaws,
                          std::initializer_list<double> pitches) {
    for (const double yaw : yaws)
      for (const double pitch : pitches)
        out.push_back(base * (Eigen::AngleAxisd(yaw * kDeg, Eigen::Vector3d::UnitZ()) *
                              Eigen::AngleAxisd(pitch * kDeg, Eigen::Vector3d::UnitX()))
                                 .toRotationMatrix());
  };
  if (const auto hinted = hintedOrientation(start); hinted && extent.use_hints) {
    around(*hinted, {-30, 0, 30}, {-25, 0, 25});
    return out;
  }
  for (int roll = 0; roll < 360; roll += extent.is_thorough ? 20 : 30) {
    const Eigen::Matrix3d rolled = Eigen::AngleAxisd(roll * kDeg, Eigen::Vector3d::UnitZ()) * facingCamera();
    if (extent.is_thorough)
      around(rolled, {-50, -25, 0, 25, 50}, {-40, -20, 0, 20, 40});
    else
      around(rolled, {-45, -15, 15, 45}, {-25, 5, 30});
  }
  return out;
}

/// The skin nearest to a camera in direction `towards_camera`, at the height of the face: it lies on the
/// cloud when the pose is right.
Eigen::Vector3d foremostSkin(const SkinField& skin, const Eigen::Vector3d& towards_camera) {
  // Mean of the most advanced hundredth: one vertex could be a ghost.
  std::vector<std::pair<double, int>> advance;
  const std::size_t stride = std::max<std::size_t>(1, skin.vertices().size() / 8000);
  for (std::size_t v = 0; v < skin.vertices().size(); v += stride)
    advance.emplace_back(-skin.vertices()[v].dot(towards_camera), int(v));
  const std::size_t most = std::max<std::size_t>(1, advance.size() / 100);
  std::nth_element(advance.begin(), advance.begin() + most, advance.end());
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t a = 0; a < most; ++a) sum += skin.vertices()[advance[a].second];
  return sum / double(most);
}

/// The most anterior vertex near the midline: the nose, or what the scan has of it.
Eigen::Vector3d noseOf(const SkinField& skin) {
  const double middle = 0.5 * (skin.low().x() + skin.high().x());
  Eigen::Vector3d nose = skin.vertices().front();
  for (const auto& v : skin.vertices())
    if (std::abs(v.x() - middle) < 30 && v.y() > nose.y()) nose = v;
  return nose;
}

Eigen::Isometry3d placed(const Eigen::Matrix3d& camera_R_mri, const Eigen::Vector3d& p_mri,
                         const Eigen::Vector3d& p_camera) {
  Eigen::Isometry3d camera_T_mri = Eigen::Isometry3d::Identity();
  camera_T_mri.linear() = camera_R_mri;
  camera_T_mri.translation() = p_camera - camera_R_mri * p_mri;
  return camera_T_mri.inverse();
}

/// Which points of the cloud lie within a head's reach of each seed.
struct Seeds {
  std::vector<Eigen::Vector3d> at_mm;
  std::vector<std::vector<Eigen::Vector3d>> around_mm;
};
Seeds seedsOf(const PointCloud<Camera>& face) {
  constexpr double kReach_mm = 170.0;
  Seeds seeds;
  seeds.at_mm = pick(face, thinOut(face, 22.0, 300)).points_mm;
  const auto points = pick(face, thinOut(face, 12.0, 1200)).points_mm;
  for (const auto& seed : seeds.at_mm) {
    seeds.around_mm.emplace_back();
    for (const auto& p : points)
      if ((p - seed).squaredNorm() < kReach_mm * kReach_mm) seeds.around_mm.back().push_back(p);
  }
  return seeds;
}

/// How much of the cloud the skin explains: 1 for a point on it, 0 for one far outside, down to -0.3 for one
/// deep inside (necks bend).
double gain(const SkinField& skin, const std::vector<Eigen::Vector3d>& points_mm,
            const Eigen::Isometry3d& mri_T_camera) {
  constexpr float kReach_mm = 18.f;
  float sum = 0;
  for (const auto& p : points_mm) {
    const float u = skin.roughDistance_mm(mri_T_camera * p) / kReach_mm;
    if (u < 1) sum += std::max(-0.3f, 1 - (u < 0 ? 2 : 1) * u * u);
  }
  return sum;
}

struct Placement {
  Eigen::Isometry3d mri_T_camera;
  double gain;
  std::size_t seed;
};

/// Climbs the gain by single steps along and about the three axes, halved when none helps.
void climb(const SkinField& skin, const Seeds& seeds, Placement& placement) {
  const Eigen::Vector3d pivot = 0.5 * (skin.low() + skin.high());
  double step_mm = 16, turn_rad = 12 * kDeg;
  for (int level = 0; level < 3; ++level, step_mm /= 2, turn_rad /= 2)
    for (int sweep = 0; sweep < 3; ++sweep) {
      bool has_moved = false;
      for (int axis = 0; axis < 6; ++axis)
        for (const double sign : {-1.0, 1.0}) {
          Vector6d xi = Vector6d::Zero();
          xi[axis] = sign * (axis < 3 ? turn_rad : step_mm);
          const Eigen::Isometry3d step = expRigid(xi);
          Eigen::Isometry3d moved = step * placement.mri_T_camera;
          if (axis < 3) moved.translation() += pivot - step.linear() * pivot;
          const double moved_gain = gain(skin, seeds.around_mm[placement.seed], moved);
          if (moved_gain <= placement.gain) continue;
          placement.mri_T_camera = moved;
          placement.gain = moved_gain;
          has_moved = true;
        }
      if (!has_moved) break;
    }
}

/// The skin's foremost point on each seed; the best `most` that lie apart, climbed.
std::vector<Placement> placementsAt(const SkinField& skin, const Seeds& seeds,
                                    const Eigen::Matrix3d& camera_R_mri, std::size_t most) {
  const double apart_mm = 100.0 / double(most);
  const Eigen::Vector3d foremost = foremostSkin(skin, camera_R_mri.transpose() * Eigen::Vector3d(0, 0, -1));
  std::vector<Placement> all, best;
  for (std::size_t s = 0; s < seeds.at_mm.size(); ++s) {
    const Eigen::Isometry3d pose = placed(camera_R_mri, foremost, seeds.at_mm[s]);
    all.push_back({pose, gain(skin, seeds.around_mm[s], pose), s});
  }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.gain > b.gain; });
  for (const Placement& p : all) {
    if (best.size() >= most) break;
    if (std::all_of(best.begin(), best.end(), [&](const Placement& b) {
          return (seeds.at_mm[b.seed] - seeds.at_mm[p.seed]).norm() > apart_mm;
        }))
      best.push_back(p);
  }
  for (Placement& p : best) climb(skin, seeds, p);
  return best;
}

/// Rough poses, each with the share of the cloud that it does not explain as its cost.
std::vector<Candidate> placements(const SkinField& skin, const PointCloud<Camera>& face,
                                  const AlignmentStart& start, const SearchExtent& extent,
                                  TaskMonitor& monitor) {
  const Seeds seeds = seedsOf(face);
  const Eigen::Vector3d nose = noseOf(skin);
  const auto turns = orientations(start, extent);
  std::vector<Placement> all;
  for (std::size_t r = 0; r < turns.size(); ++r) {
    monitor.report("searching the head", double(r) / double(turns.size()));
    const auto here = placementsAt(skin, seeds, turns[r], extent.is_thorough ? 4 : 2);
    all.insert(all.end(), here.begin(), here.end());
    if (!start.nose_tip || !extent.use_hints || seeds.at_mm.empty()) continue;
    std::size_t nearest = 0;
    for (std::size_t s = 0; s < seeds.at_mm.size(); ++s)
      if ((seeds.at_mm[s] - start.nose_tip->mm).norm() < (seeds.at_mm[nearest] - start.nose_tip->mm).norm())
        nearest = s;
    const Eigen::Isometry3d pose = placed(turns[r], nose, start.nose_tip->mm);
    all.push_back({pose, gain(skin, seeds.around_mm[nearest], pose), nearest});
    climb(skin, seeds, all.back());
  }
  std::vector<Candidate> out;
  for (const Placement& p : all) out.push_back({p.mri_T_camera, -p.gain});
  if (start.guess && extent.use_hints) out.push_back({start.guess->isometry().inverse(), -1e9});
  return out;
}

/// The camera stands before the face, not behind the head: its direction from the head's middle has an
/// anterior part.
bool seesTheFace(const Eigen::Isometry3d& mri_T_camera, const Eigen::Vector3d& pivot_mri_mm) {
  constexpr double kLeastAnterior = 0.17;  // cosine: up to 80 degrees from straight ahead
  return (mri_T_camera.translation() - pivot_mri_mm).normalized().y() > kLeastAnterior;
}

void keepDistinct(std::vector<Candidate>& candidates, const Eigen::Vector3d& pivot, std::size_t most) {
  std::sort(candidates.begin(), candidates.end(),
            [](const auto& a, const auto& b) { return a.cost < b.cost; });
  std::vector<Candidate> kept;
  for (const Candidate& c : candidates) {
    const bool is_new = std::all_of(kept.begin(), kept.end(), [&](const Candidate& k) {
      return areDistinct(k.mri_T_camera, c.mri_T_camera, pivot, 6 * kDeg, 12.0);
    });
    if (is_new && kept.size() < most && seesTheFace(c.mri_T_camera, pivot)) kept.push_back(c);
  }
  candidates = kept;
}

}  // namespace

std::vector<int> nearHead(const SkinField& skin, const PointCloud<Camera>& face,
                          const Eigen::Isometry3d& mri_T_camera, double reach_mm) {
  std::vector<int> near;
  for (std::size_t p = 0; p < face.size(); ++p) {
    if (!face.points_mm[p].allFinite()) continue;
    if (std::abs(skin.roughDistance_mm(mri_T_camera * face.points_mm[p])) < reach_mm) near.push_back(int(p));
  }
  return near;
}

bool areDistinct(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, const Eigen::Vector3d& pivot_mri_mm,
                 double rotation_rad, double distance_mm) {
  const Eigen::Isometry3d change = a * b.inverse();
  return rotationAngle(change.linear()) > rotation_rad ||
         (change * pivot_mri_mm - pivot_mri_mm).norm() > distance_mm;
}

std::vector<Candidate> findStarts(const SkinField& skin, const PointCloud<Camera>& face,
                                  const AlignmentStart& start, const SearchExtent& extent,
                                  TaskMonitor& monitor) {
  const PoseFitter sparse(skin, pick(face, thinOut(face, 8.0, 1500)));
  const PoseFitter denser(skin, pick(face, thinOut(face, 5.0, 4000)));
  auto candidates = placements(skin, face, start, extent, monitor);
  keepDistinct(candidates, sparse.pivot_mri_mm(), extent.is_refined ? 20 * extent.most : extent.most);
  if (candidates.empty())
    throw Error("not aligned: nothing like a face was measured", {}, "show the whole face to both cameras");
  if (!extent.is_refined) return candidates;
  for (Candidate& c : candidates) {
    for (const FitStage& stage : {FitStage{20, 14, 5, false}, FitStage{12, 8, 5, false}})
      c.mri_T_camera = sparse.fit(c.mri_T_camera, stage);
    c.cost = sparse.cost(c.mri_T_camera, 6.0);
  }
  keepDistinct(candidates, sparse.pivot_mri_mm(), 2 * extent.most);
  for (Candidate& c : candidates) {
    c.mri_T_camera = denser.fit(c.mri_T_camera, {14, 9, 8, false});
    c.mri_T_camera = denser.fit(c.mri_T_camera, {8, 5, 8, false});
    c.mri_T_camera = denser.fit(c.mri_T_camera, {5, 3, 8, false});
    c.cost = denser.cost(c.mri_T_camera, 4.0);
  }
  keepDistinct(candidates, sparse.pivot_mri_mm(), extent.most);
  if (candidates.empty())
    throw Error("not aligned: nothing like a face was measured", {}, "show the whole face to both cameras");
  return candidates;
}

}  // namespace facenav::registration
