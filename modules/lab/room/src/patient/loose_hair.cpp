#include "loose_hair.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "optics/noise_field.h"
#include "optics/ray_scene.h"
#include "skin_mesh.h"
#include "smooth_step.h"

namespace facenav::room {
namespace {

// Chosen by eye beside photographs of curly hair: strands about 2 mm thick, 10-25 mm long over the forehead
// and up to 90 mm at the sides.
constexpr int kLocks = 160, kSides = 5;
constexpr double kStep_mm = 2.5, kThick_mm = 1.0, kThin_mm = 0.3, kCurl_mm = 3.0, kCurlPitch_mm = 17.0;
constexpr double kShort_mm = 13.0, kLonger_mm = 60.0, kClear_mm = 1.5;

/// Vertices just inside the hairline, at the front half of the head.
std::vector<int> hairline(const VirtualPatient& patient) {
  std::vector<int> found;
  const Eigen::Vector3d& centre = patient.head_centre.mm;
  for (std::size_t i = 0; i < patient.hair.size(); ++i) {
    const Eigen::Vector3d& p = patient.skin.vertices_mm[i];
    const double rise_mm = (patient.visible.vertices_mm[i] - p).norm();
    if (patient.hair[i] > 0.98f && rise_mm > 0.3 && rise_mm < 2.0 && p.y() > centre.y() - 25.0 &&
        p.z() > centre.z() - 70.0)
      found.push_back(int(i));
  }
  return found;
}

/// Moves points out of the head, away from its vertical axis.
class Outside {
 public:
  explicit Outside(const VirtualPatient& patient) : axis_mm_(patient.head_centre.mm) {
    scene_.add(patient.visible);
    scene_.commit();
  }
  Eigen::Vector3d operator()(const Eigen::Vector3d& p_mm) const {
    const Eigen::Vector3d axis_mm(axis_mm_.x(), axis_mm_.y(), p_mm.z());
    const Eigen::Vector3d out = (p_mm - axis_mm).normalized();
    const auto hit = scene_.intersect(axis_mm + kFar_mm * out, -out);
    if (!hit) return p_mm;
    const double skin_mm = kFar_mm - hit->distance + kClear_mm;
    return (p_mm - axis_mm).norm() < skin_mm ? Eigen::Vector3d(axis_mm + skin_mm * out) : p_mm;
  }

 private:
  static constexpr double kFar_mm = 250.0;
  Eigen::Vector3d axis_mm_;
  RayScene scene_;
};

double uniform(std::mt19937_64& random) { return double(random() >> 11) * 0x1p-53; }

/// Path of a lock: from the root outwards, then down, with a growing curl.
std::vector<Eigen::Vector3d> path(const Eigen::Vector3d& root_mm, const Eigen::Vector3d& normal,
                                  double length_mm, const Outside& outside, std::mt19937_64& random) {
  const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ(), across = normal.cross(down).normalized();
  const double turn = 2.0 * M_PI * uniform(random), curl_mm = kCurl_mm * (0.3 + 0.7 * uniform(random));
  Eigen::Vector3d along = (0.6 * normal + 0.7 * down + 0.8 * (uniform(random) - 0.5) * across).normalized();
  Eigen::Vector3d middle = root_mm;
  std::vector<Eigen::Vector3d> points;
  for (double s_mm = 0.0; s_mm <= length_mm; s_mm += kStep_mm) {
    const double angle = turn + 2.0 * M_PI * s_mm / kCurlPitch_mm, grown = curl_mm * smoothStep(s_mm / 20.0);
    points.push_back(outside(middle + grown * (std::cos(angle) * across + std::sin(angle) * normal)));
    middle = outside(middle + kStep_mm * along);
    along = (along + 0.25 * down).normalized();
  }
  points.front() = root_mm;
  return points;
}

class LockLook : public Look {
 public:
  explicit LockLook(const surface::TriangleMesh& rest) : rest_(rest) {}

  Reflectance at(const SurfacePoint& point) const override {
    const Eigen::Vector3i& t = rest_.triangles[std::size_t(point.triangle)];
    const Eigen::Vector3d p = (1.0 - point.u - point.v) * rest_.vertices_mm[std::size_t(t[0])] +
                              double(point.u) * rest_.vertices_mm[std::size_t(t[1])] +
                              double(point.v) * rest_.vertices_mm[std::size_t(t[2])];
    const float strands = sharedNoise().at(p, 0.6), locks = sharedNoise().at(p, 8.0);
    return {kAlbedo * std::max(0.3f, 1.f + 0.25f * strands + 0.35f * locks), 0.03f};
  }
  float redness(const SurfacePoint&) const override { return kRedness; }

 private:
  static constexpr float kAlbedo = 0.11f, kRedness = 0.25f;
  const surface::TriangleMesh& rest_;
};

}  // namespace

LooseHair::LooseHair(const VirtualPatient& patient, std::uint64_t seed) {
  const auto roots = hairline(patient);
  if (roots.empty()) return;
  const Outside outside(patient);
  std::mt19937_64 random(seed * 4447 + 23);
  for (int lock = 0; lock < kLocks; ++lock) {
    const auto vertex = std::size_t(roots[random() % roots.size()]);
    const Root root{patient.visible.vertices_mm[vertex], patient.skin.normals[vertex]};
    const double aside = std::abs(root.p_mm.x() - patient.head_centre.mm.x());
    const double length_mm =
        (kShort_mm + kLonger_mm * smoothStep((aside - 40.0) / 25.0)) * (0.6 + 0.8 * uniform(random));
    addLock(root, path(root.p_mm, root.normal, length_mm, outside, random));
  }
  mesh_.normals = vertexNormals(mesh_.vertices_mm, mesh_.triangles);
}

void LooseHair::addLock(const Root& root, const std::vector<Eigen::Vector3d>& path) {
  const int first = int(mesh_.vertices_mm.size()), rings = int(path.size());
  for (int ring = 0; ring < rings; ++ring) {
    const double share = rings > 1 ? double(ring) / (rings - 1) : 0.0;
    const Eigen::Vector3d along =
        path[std::size_t(std::min(ring + 1, rings - 1))] - path[std::size_t(std::max(ring - 1, 0))];
    const Eigen::Vector3d a = along.unitOrthogonal(), b = along.normalized().cross(a);
    const double radius_mm = kThick_mm + share * (kThin_mm - kThick_mm);
    for (int side = 0; side < kSides; ++side) {
      const double angle = 2.0 * M_PI * side / kSides;
      mesh_.vertices_mm.push_back(path[std::size_t(ring)] +
                                  radius_mm * (std::cos(angle) * a + std::sin(angle) * b));
      roots_.push_back(root);
      from_root_.push_back(share);
    }
  }
  for (int ring = 0; ring + 1 < rings; ++ring)
    for (int side = 0; side < kSides; ++side) {
      const int a = first + ring * kSides + side, b = first + ring * kSides + (side + 1) % kSides;
      mesh_.triangles.push_back({a, b, a + kSides});
      mesh_.triangles.push_back({b, b + kSides, a + kSides});
    }
}

std::vector<Eigen::Vector3d> LooseHair::vertices_mm(const HairPose& pose) const {
  std::vector<Eigen::Vector3d> moved = mesh_.vertices_mm;
  for (std::size_t i = 0; i < moved.size(); ++i)
    moved[i] += 1.5 * from_root_[i] * hairShift_mm(pose, roots_[i].p_mm, roots_[i].normal);
  return moved;
}

std::shared_ptr<const Look> makeLockLook(const surface::TriangleMesh& rest) {
  return std::make_shared<LockLook>(rest);
}

}  // namespace facenav::room
