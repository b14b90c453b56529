#include "facenav/surface/closest_point.h"

#include <embree3/rtcore.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "facenav/core/error.h"
#include "facenav/geometry/nearest_on_triangle.h"

namespace facenav::surface {
using Eigen::Vector3f;

/// Embree's tree over the mesh. VTK's cell locator takes five times as long, from far away ten times.
struct ClosestPoint::Tree {
  struct Search;

  std::vector<Vector3f> vertices_mm;
  std::vector<Eigen::Vector3i> triangles;
  std::unique_ptr<RTCDeviceTy, void (*)(RTCDevice)> device{nullptr, rtcReleaseDevice};
  std::unique_ptr<RTCSceneTy, void (*)(RTCScene)> scene{nullptr, rtcReleaseScene};  // reads the mesh above

  const Vector3f& corner(int triangle, int c) const {
    return vertices_mm[std::size_t(triangles[std::size_t(triangle)][c])];
  }
  Vector3f normal(int t) const {
    return (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0)).normalized();
  }
  static bool consider(RTCPointQueryFunctionArguments* found);
};

/// The nearest place of the triangles considered so far. Where several share it (an edge, a corner), the one
/// that faces the point most is kept: its side decides between inside and outside.
struct ClosestPoint::Tree::Search {
  static constexpr float kSame = 1e-5f;  // of the squared distance: two triangles share one nearest place

  const Tree& mesh;
  Vector3f p_mm, place_mm = Vector3f::Zero();
  float squared_mm2 = std::numeric_limits<float>::infinity();
  int triangle = -1;

  float radius_mm() const { return std::sqrt(squared_mm2 * (1 + kSame)); }
  float facing(int t, const Vector3f& at) const { return std::abs(mesh.normal(t).dot(p_mm - at)); }

  /// True where it lies nearer than those before.
  bool consider(int t) {
    const Vector3f at =
        nearestOnTriangle(p_mm, mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)).point;
    const float squared = (p_mm - at).squaredNorm();
    if (squared > squared_mm2 * (1 + kSame)) return false;
    const bool is_nearer = squared < squared_mm2 * (1 - kSame);
    if (!is_nearer && facing(t, at) <= facing(triangle, place_mm)) return false;
    place_mm = at, squared_mm2 = std::min(squared, squared_mm2), triangle = t;
    return is_nearer;
  }
};

bool ClosestPoint::Tree::consider(RTCPointQueryFunctionArguments* found) {
  auto& search = *static_cast<Search*>(found->userPtr);
  if (!search.consider(int(found->primID))) return false;
  found->query->radius = search.radius_mm();
  return true;
}

ClosestPoint::ClosestPoint(const TriangleMesh& mesh) : tree_(std::make_unique<Tree>()) {
  if (mesh.triangles.empty()) throw Error("a surface without triangles has no nearest point");
  auto& own = *tree_;
  own.vertices_mm.reserve(mesh.vertices_mm.size() + 1);  // Embree reads 16 bytes of each
  for (const auto& v : mesh.vertices_mm) own.vertices_mm.push_back(v.cast<float>());
  own.triangles = mesh.triangles;
  own.device.reset(rtcNewDevice(nullptr));
  FACENAV_EXPECT(own.device, "Embree gives no device");
  own.scene.reset(rtcNewScene(own.device.get()));
  const RTCGeometry geometry = rtcNewGeometry(own.device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, own.vertices_mm.data(),
                             0, sizeof(Vector3f), own.vertices_mm.size());
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, own.triangles.data(), 0,
                             sizeof(Eigen::Vector3i), own.triangles.size());
  rtcSetGeometryPointQueryFunction(geometry, Tree::consider);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(own.scene.get(), geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(own.scene.get());
}

ClosestPoint::~ClosestPoint() = default;
ClosestPoint::ClosestPoint(ClosestPoint&&) noexcept = default;
ClosestPoint& ClosestPoint::operator=(ClosestPoint&&) noexcept = default;

SurfacePoint ClosestPoint::nearest(const Point<Mri>& p, std::optional<int> near) const {
  Tree::Search search{*tree_, p.mm.cast<float>()};
  if (near) search.consider(*near);
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  RTCPointQuery query{search.p_mm.x(), search.p_mm.y(), search.p_mm.z(), 0.f, search.radius_mm()};
  rtcPointQuery(tree_->scene.get(), &query, &context, nullptr, &search);
  FACENAV_EXPECT(search.triangle >= 0, "a mesh with triangles has a nearest one");
  SurfacePoint out;
  out.point = Point<Mri>(search.place_mm.cast<double>());
  out.normal = Direction<Mri>(tree_->normal(search.triangle).cast<double>());
  out.distance_mm = (p.mm - out.point.mm).norm();
  out.is_outside = (p.mm - out.point.mm).dot(out.normal.v) >= 0;
  out.triangle = search.triangle;
  return out;
}

}  // namespace facenav::surface
