// The coil's pose in a view of gmsh, as SimNIBS writes it beside a field's mesh.

#include <cmath>
#include <cstdio>
#include <sstream>

#include "facenav/core/whole_file.h"
#include "imported_samples.h"

namespace facenav::steps {
namespace {

namespace fs = std::filesystem;

struct GeoView {
  std::vector<Eigen::Vector3d> vector_places, vectors;  // VP(..){..}
  std::vector<Eigen::Vector3d> points;                  // SP(..){..}
};

GeoView readView(const std::string& content) {
  GeoView view;
  std::istringstream lines(content);
  for (std::string line; std::getline(lines, line);) {
    Eigen::Vector3d p, v;
    if (std::sscanf(line.c_str(), " VP ( %lf , %lf , %lf ) { %lf , %lf , %lf", &p[0], &p[1], &p[2], &v[0],
                    &v[1], &v[2]) == 6) {
      view.vector_places.push_back(p);
      view.vectors.push_back(v);
    } else if (std::sscanf(line.c_str(), " SP ( %lf , %lf , %lf )", &p[0], &p[1], &p[2]) == 3) {
      view.points.push_back(p);
    }
  }
  return view;
}

/// Pose from two directions, which must be about perpendicular.
std::optional<Eigen::Matrix4d> poseFrom(const Eigen::Vector3d& origin_mm, const Eigen::Vector3d& along_y,
                                        const Eigen::Vector3d& along_z) {
  const Eigen::Vector3d z = along_z.normalized(), y = along_y.normalized();
  if (!z.allFinite() || !y.allFinite() || std::abs(y.dot(z)) > 0.05) return std::nullopt;
  Eigen::Matrix4d pose = Eigen::Matrix4d::Identity();
  const Eigen::Vector3d x = y.cross(z).normalized();
  pose.block<3, 1>(0, 0) = x;
  pose.block<3, 1>(0, 1) = z.cross(x);
  pose.block<3, 1>(0, 2) = z;
  pose.block<3, 1>(0, 3) = origin_mm;
  return pose;
}

/// Three vectors at one place: the axes x, y, z.
std::optional<Eigen::Matrix4d> fromVectors(const GeoView& view) {
  if (view.vectors.size() != 3) return std::nullopt;
  for (const auto& place : view.vector_places)
    if ((place - view.vector_places[0]).norm() > 0.01) return std::nullopt;
  auto pose = poseFrom(view.vector_places[0], view.vectors[1], view.vectors[2]);
  if (pose && pose->block<3, 1>(0, 0).dot(view.vectors[0].normalized()) < 0.99) return std::nullopt;
  return pose;
}

/// Balls: the coil's centre, then some along y, then some along z.
std::optional<Eigen::Matrix4d> fromBalls(const GeoView& view) {
  if (view.points.size() < 3) return std::nullopt;
  const Eigen::Vector3d origin = view.points[0], y = (view.points[1] - origin).normalized();
  std::optional<Eigen::Vector3d> z;
  for (std::size_t i = 1; i < view.points.size(); ++i) {
    const Eigen::Vector3d to = (view.points[i] - origin).normalized();
    if (!z && to.dot(y) > 0.999) continue;  // still along y
    if (!z) z = to;
    if (to.dot(*z) < 0.999) return std::nullopt;  // no line: the coil's dipoles
  }
  return z ? poseFrom(origin, y, *z) : std::nullopt;
}

/// Every name that the coil's file may have: a field's file adds words to the name of the simulation, and
/// SimNIBS keeps volumes and overlays in a folder of their own.
std::vector<fs::path> namesBeside(const fs::path& file) {
  const std::string name = file.filename().string();
  const fs::path folder = fs::absolute(file).parent_path();
  std::vector<fs::path> names;
  for (std::size_t at = name.find_last_of("_."); at != std::string::npos && at > 0;
       at = name.find_last_of("_.", at - 1))
    for (const auto& place : {folder, folder.parent_path()})
      names.push_back(place / (name.substr(0, at) + "_coil_pos.geo"));
  return names;
}

}  // namespace

std::optional<Eigen::Matrix4d> poseBeside(const fs::path& file) {
  for (const auto& name : namesBeside(file)) {
    if (!fs::is_regular_file(name)) continue;
    const GeoView view = readView(readWholeFile(name));
    const auto pose = fromVectors(view);
    return pose ? pose : fromBalls(view);
  }
  return std::nullopt;
}

}  // namespace facenav::steps
