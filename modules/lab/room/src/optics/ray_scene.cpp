#include "ray_scene.h"

#include <embree3/rtcore.h>

#include <cmath>
#include <limits>
#include <vector>

#include "facenav/core/error.h"

namespace facenav::room {
namespace {

struct Object {
  surface::TriangleMesh mesh;
  RTCScene scene = nullptr;
  RTCGeometry geometry = nullptr, instance = nullptr;
  Eigen::Isometry3d world_T_object = Eigen::Isometry3d::Identity();
  Eigen::AlignedBox3d bounds;
  bool is_shown = true;
};

void writeVertices(RTCGeometry geometry, const std::vector<Eigen::Vector3d>& vertices_mm, bool is_new) {
  auto* out = static_cast<float*>(is_new ? rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                                   RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                                   vertices_mm.size())
                                         : rtcGetGeometryBufferData(geometry, RTC_BUFFER_TYPE_VERTEX, 0));
  for (const auto& p_mm : vertices_mm)
    for (int axis = 0; axis < 3; ++axis) *out++ = float(p_mm[axis]);
}

void writeTriangles(RTCGeometry geometry, const std::vector<Eigen::Vector3i>& triangles) {
  auto* out = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), triangles.size()));
  for (const auto& triangle : triangles)
    for (int corner = 0; corner < 3; ++corner) *out++ = unsigned(triangle[corner]);
}

Eigen::AlignedBox3d boundsOf(const std::vector<Eigen::Vector3d>& vertices_mm) {
  Eigen::AlignedBox3d box;
  for (const auto& p_mm : vertices_mm) box.extend(p_mm);
  return box;
}

void setTransform(RTCGeometry instance, const Eigen::Isometry3d& pose) {
  const Eigen::Matrix4f columns = pose.matrix().cast<float>();
  rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, columns.data());
}

}  // namespace

struct RayScene::Implementation {
  RTCDevice device = rtcNewDevice(nullptr);
  RTCScene world = nullptr;
  std::vector<Object> objects;
};

RayScene::RayScene() : implementation_(std::make_unique<Implementation>()) {
  FACENAV_EXPECT(implementation_->device, "Embree gives no device");
  implementation_->world = rtcNewScene(implementation_->device);
  rtcSetSceneFlags(implementation_->world, RTC_SCENE_FLAG_DYNAMIC | RTC_SCENE_FLAG_ROBUST);
}

RayScene::~RayScene() {
  for (auto& object : implementation_->objects) {
    rtcReleaseGeometry(object.geometry);
    rtcReleaseGeometry(object.instance);
    rtcReleaseScene(object.scene);
  }
  rtcReleaseScene(implementation_->world);
  rtcReleaseDevice(implementation_->device);
}

int RayScene::add(const surface::TriangleMesh& mesh) {
  auto& all = *implementation_;
  Object object;
  object.mesh = mesh;
  object.bounds = boundsOf(mesh.vertices_mm);
  object.geometry = rtcNewGeometry(all.device, RTC_GEOMETRY_TYPE_TRIANGLE);
  writeVertices(object.geometry, mesh.vertices_mm, true);
  writeTriangles(object.geometry, mesh.triangles);
  rtcCommitGeometry(object.geometry);
  object.scene = rtcNewScene(all.device);
  rtcSetSceneFlags(object.scene, RTC_SCENE_FLAG_ROBUST);
  rtcAttachGeometry(object.scene, object.geometry);
  rtcCommitScene(object.scene);
  object.instance = rtcNewGeometry(all.device, RTC_GEOMETRY_TYPE_INSTANCE);
  rtcSetGeometryInstancedScene(object.instance, object.scene);
  setTransform(object.instance, object.world_T_object);
  rtcCommitGeometry(object.instance);
  rtcAttachGeometryByID(all.world, object.instance, unsigned(all.objects.size()));
  all.objects.push_back(std::move(object));
  return int(all.objects.size()) - 1;
}

void RayScene::setPose(int number, const Eigen::Isometry3d& world_T_object) {
  auto& object = implementation_->objects.at(number);
  object.world_T_object = world_T_object;
  setTransform(object.instance, world_T_object);
  rtcCommitGeometry(object.instance);
}

const Eigen::Isometry3d& RayScene::pose(int object) const {
  return implementation_->objects.at(object).world_T_object;
}

void RayScene::setShown(int number, bool is_shown) {
  auto& object = implementation_->objects.at(number);
  if (object.is_shown == is_shown) return;
  object.is_shown = is_shown;
  is_shown ? rtcEnableGeometry(object.instance) : rtcDisableGeometry(object.instance);
}

bool RayScene::isShown(int object) const { return implementation_->objects.at(object).is_shown; }

void RayScene::setVertices(int number, const std::vector<Eigen::Vector3d>& vertices_mm,
                           const std::vector<Eigen::Vector3d>& normals) {
  auto& object = implementation_->objects.at(number);
  FACENAV_EXPECT(vertices_mm.size() == object.mesh.vertices_mm.size(),
                 "a deformation keeps the vertex count");
  object.mesh.vertices_mm = vertices_mm;
  object.bounds = boundsOf(vertices_mm);
  object.mesh.normals = normals;
  writeVertices(object.geometry, vertices_mm, false);
  rtcUpdateGeometryBuffer(object.geometry, RTC_BUFFER_TYPE_VERTEX, 0);
  rtcSetGeometryBuildQuality(object.geometry, RTC_BUILD_QUALITY_REFIT);
  rtcCommitGeometry(object.geometry);
  rtcCommitScene(object.scene);
  rtcCommitGeometry(object.instance);
}

const surface::TriangleMesh& RayScene::mesh(int object) const {
  return implementation_->objects.at(object).mesh;
}

const Eigen::AlignedBox3d& RayScene::bounds(int object) const {
  return implementation_->objects.at(object).bounds;
}

void RayScene::commit() { rtcCommitScene(implementation_->world); }

Sight RayScene::look(const Eigen::Vector3d& origin_mm, const Eigen::Vector3d& direction) const {
  RTCRayHit query{};
  query.ray = {float(origin_mm.x()),
               float(origin_mm.y()),
               float(origin_mm.z()),
               0.f,
               float(direction.x()),
               float(direction.y()),
               float(direction.z()),
               0.f,
               std::numeric_limits<float>::infinity(),
               ~0u,
               0,
               0};
  query.hit.geomID = query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect1(implementation_->world, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  return {int(query.hit.instID[0]), int(query.hit.primID), query.hit.u, query.hit.v, query.ray.tfar};
}

Hit RayScene::refine(const Sight& sight, const Eigen::Vector3d& origin_mm,
                     const Eigen::Vector3d& direction) const {
  const Object& object = implementation_->objects[sight.object];
  const Eigen::Vector3i& corner = object.mesh.triangles[sight.triangle];
  const auto& p = object.mesh.vertices_mm;
  const Eigen::Vector3d a = p[corner[0]], facet = (p[corner[1]] - a).cross(p[corner[2]] - a);
  const Eigen::Matrix3d& rotation = object.world_T_object.linear();
  const Eigen::Vector3d from = rotation.transpose() * (origin_mm - object.world_T_object.translation());
  const Eigen::Vector3d along = rotation.transpose() * direction;
  // In double precision: intersects the ray with the plane of the triangle found by Embree.
  const double slope = facet.dot(along), found = sight.distance;
  Hit hit{sight.object, sight.triangle, sight.u, sight.v, found, {}, {}, {}};
  if (slope != 0.0) hit.distance = facet.dot(a - from) / slope;
  if (std::abs(hit.distance - found) > 1e-3 * std::abs(found)) hit.distance = found;  // a ray along the facet
  hit.p_object_mm = from + hit.distance * along;
  hit.facet_normal = (rotation * facet).normalized();
  const auto& n = object.mesh.normals;
  const double u = sight.u, v = sight.v;
  hit.normal = (rotation * ((1.0 - u - v) * n[corner[0]] + u * n[corner[1]] + v * n[corner[2]])).normalized();
  return hit;
}

std::optional<Hit> RayScene::intersect(const Eigen::Vector3d& origin_mm,
                                       const Eigen::Vector3d& direction) const {
  const Sight sight = look(origin_mm, direction);
  if (sight.object < 0) return std::nullopt;
  return refine(sight, origin_mm, direction);
}

bool RayScene::isBlocked(const Eigen::Vector3d& from_mm, const Eigen::Vector3d& to_mm) const {
  const Eigen::Vector3d along = (to_mm - from_mm).normalized();
  RTCRay ray{float(from_mm.x()),
             float(from_mm.y()),
             float(from_mm.z()),
             0.5f,
             float(along.x()),
             float(along.y()),
             float(along.z()),
             0.f,
             float((to_mm - from_mm).norm()),
             ~0u,
             0,
             0};
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(implementation_->world, &context, &ray);
  return ray.tfar < 0.f;
}

}  // namespace facenav::room
