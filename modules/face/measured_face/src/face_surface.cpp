#include "facenav/measured_face/face_surface.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/measured_face/shared_depth.h"

namespace facenav::measured_face {
namespace {

constexpr double kCell_mm = 1.5;  // cell of one vertex; contains several points, so that noise averages out
constexpr double kLongestEdge_cells = 4;  // longer edges connect two surfaces, one behind the other
constexpr double kMostSigma = 3;          // relative to the median; points with more are left out
constexpr double kMostGrazing = 0.26;     // least cosine between normal and view: 75 degrees
constexpr double kOnSkin_mm = 2.0;        // largest distance from the MRI's skin
constexpr double kLeastExtent_mm = 90;    // across and down; a whole face has 130 and 180

using FaceCells = std::map<std::pair<int, int>, int>;

/// Points that are measured well, face the camera, and lie on the MRI's skin if that is known.
std::vector<std::size_t> goodPoints(const stereo::FaceCloud& face,
                                    const RigidTransform<Mri, Camera>& mri_T_camera,
                                    const registration::ScalpField* scalp) {
  std::vector<double> sigmas(face.sigma_mm.begin(), face.sigma_mm.end());
  const double most_mm = sigmas.empty() ? 1e9 : kMostSigma * upperMedian(sigmas);
  std::vector<std::size_t> good;
  for (std::size_t i = 0; i < face.cloud.size(); ++i) {
    const Eigen::Vector3d& p = face.cloud.points_mm[i];
    if (!sigmas.empty() && sigmas[i] > most_mm) continue;
    if (-face.cloud.normals[i].dot(p.normalized()) < kMostGrazing) continue;
    if (scalp) {
      const float off_mm = scalp->fine((mri_T_camera * Point<Camera>(p)).mm.cast<float>()).distance_mm;
      if (!(std::abs(off_mm) < kOnSkin_mm)) continue;
    }
    good.push_back(i);
  }
  return good;
}

/// Mean point and normal of each cell of the left picture.
FaceCells addVertices(const stereo::FaceCloud& face, const std::vector<std::size_t>& good, int cell_px,
                      const RigidTransform<Mri, Camera>& mri_T_camera, surface::TriangleMesh& mesh) {
  std::map<std::pair<int, int>, std::vector<std::size_t>> members;
  for (const std::size_t i : good)
    members[{int(face.left_px[i].x()) / cell_px, int(face.left_px[i].y()) / cell_px}].push_back(i);
  FaceCells vertices;
  for (const auto& [cell, points] : members) {
    Eigen::Vector3d p = Eigen::Vector3d::Zero(), normal = p;
    for (const std::size_t i : points) p += face.cloud.points_mm[i], normal += face.cloud.normals[i];
    vertices[cell] = int(mesh.vertices_mm.size());
    mesh.vertices_mm.push_back((mri_T_camera * Point<Camera>(p / double(points.size()))).mm);
    mesh.normals.push_back(mri_T_camera.rotation() * normal.normalized());
  }
  return vertices;
}

void addTriangle(surface::TriangleMesh& mesh, int a, int b, int c) {
  const auto at = [&](int i) { return mesh.vertices_mm[std::size_t(i)]; };
  for (const auto& [i, j] : {std::pair{a, b}, {b, c}, {c, a}})
    if ((at(i) - at(j)).norm() > kLongestEdge_cells * kCell_mm) return;
  const Eigen::Vector3d normal = (at(b) - at(a)).cross(Eigen::Vector3d(at(c) - at(a)));
  if (normal.dot(mesh.normals[std::size_t(a)]) < 0) std::swap(b, c);
  mesh.triangles.push_back({a, b, c});
}

void addTriangles(const FaceCells& cells, surface::TriangleMesh& mesh) {
  for (const auto& [cell, a] : cells) {
    const auto [x, y] = cell;
    const auto right = cells.find({x + 1, y}), down = cells.find({x, y + 1}),
               across = cells.find({x + 1, y + 1});
    if (across == cells.end()) continue;
    if (right != cells.end()) addTriangle(mesh, a, right->second, across->second);
    if (down != cells.end()) addTriangle(mesh, a, across->second, down->second);
  }
}

/// The largest connected part. Hair, a collar or a hand is separate from the face.
surface::TriangleMesh largestPart(const surface::TriangleMesh& mesh) {
  std::vector<int> part(mesh.vertices_mm.size());
  std::iota(part.begin(), part.end(), 0);
  const auto root = [&](int i) {
    while (part[std::size_t(i)] != i) i = part[std::size_t(i)] = part[std::size_t(part[std::size_t(i)])];
    return i;
  };
  for (const auto& t : mesh.triangles)
    part[std::size_t(root(t[1]))] = root(t[0]), part[std::size_t(root(t[2]))] = root(t[0]);
  std::map<int, int> sizes;
  for (const auto& t : mesh.triangles) ++sizes[root(t[0])];
  surface::TriangleMesh kept;
  if (sizes.empty()) return kept;
  const int largest = std::max_element(sizes.begin(), sizes.end(), [](auto& a, auto& b) {
                        return a.second < b.second;
                      })->first;
  std::vector<int> renamed(mesh.vertices_mm.size(), -1);
  for (const auto& t : mesh.triangles) {
    if (root(t[0]) != largest) continue;
    Eigen::Vector3i triangle;
    for (int c = 0; c < 3; ++c) {
      int& name = renamed[std::size_t(t[c])];
      if (name < 0) {
        name = int(kept.vertices_mm.size());
        kept.vertices_mm.push_back(mesh.vertices_mm[std::size_t(t[c])]);
        kept.normals.push_back(mesh.normals[std::size_t(t[c])]);
      }
      triangle[c] = name;
    }
    kept.triangles.push_back(triangle);
  }
  return kept;
}

}  // namespace

surface::ScalpSurface faceSurface(const cameras::StereoRig& rig, const stereo::FaceCloud& face,
                                  const RigidTransform<Mri, Camera>& mri_T_camera,
                                  const registration::ScalpField* scalp) {
  const auto good = goodPoints(face, mri_T_camera, scalp);
  double depth_mm = 0;
  for (const std::size_t i : good) depth_mm += face.cloud.points_mm[i].z() / double(good.size());
  const int cell_px =
      good.empty() ? 1 : std::max(1, int(std::lround(kCell_mm * rig.left.k(0, 0) / depth_mm)));
  surface::TriangleMesh mesh;
  addTriangles(addVertices(face, good, cell_px, mri_T_camera, mesh), mesh);
  surface::ScalpSurface skin;
  skin.mesh = largestPart(mesh);
  skin.has_face = true;
  std::vector<double> sigmas;
  for (const std::size_t i : good)
    if (i < face.sigma_mm.size()) sigmas.push_back(face.sigma_mm[i]);
  const FaceError error = faceErrorOf(rig, face);
  skin.measurement = surface::FaceMeasurement{int(good.size()), sigmas.empty() ? 0.0 : upperMedian(sigmas),
                                              error.sight.sigma_mm, error.whole_mm};
  return skin;
}

void requireWholeFace(const surface::TriangleMesh& mesh) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e9), high = -low;
  for (const auto& v : mesh.vertices_mm) low = low.cwiseMin(v), high = high.cwiseMax(v);
  const Eigen::Vector3d extent =
      mesh.vertices_mm.empty() ? Eigen::Vector3d::Zero() : Eigen::Vector3d(high - low);
  if (extent.x() >= kLeastExtent_mm && extent.z() >= kLeastExtent_mm) return;
  throw Error(formatted("only %.0f x %.0f mm of the face were measured", extent.x(), extent.z()), {},
              "show the whole face to both cameras, hair and hands aside, and take the pictures again");
}

}  // namespace facenav::measured_face
