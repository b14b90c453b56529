#include "worn.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "facenav/geometry/rotation.h"
#include "optics/noise_field.h"
#include "optics/shapes.h"
#include "patient/head_outline.h"
#include "patient/skin_mesh.h"

namespace facenav::room {
namespace {

/// Grid of points as a mesh, seen from both sides.
surface::TriangleMesh sheet(int rows, int columns, const std::function<Eigen::Vector3d(double, double)>& at) {
  surface::TriangleMesh mesh;
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column <= columns; ++column)
      mesh.vertices_mm.push_back(at(double(row) / rows, double(column) / columns));
  const auto number = [columns](int row, int column) { return row * (columns + 1) + column; };
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const int a = number(row, column), b = number(row, column + 1), c = number(row + 1, column),
                d = number(row + 1, column + 1);
      mesh.triangles.push_back({a, c, b});
      mesh.triangles.push_back({b, c, d});
    }
  mesh.normals = vertexNormals(mesh.vertices_mm, mesh.triangles);
  return mesh;
}

/// Turns a sheet's normals away from a point behind it.
surface::TriangleMesh outwards(surface::TriangleMesh mesh, const Eigen::Vector3d& inside_mm) {
  double sum = 0.0;
  for (std::size_t i = 0; i < mesh.normals.size(); ++i)
    sum += mesh.normals[i].dot(mesh.vertices_mm[i] - inside_mm);
  if (sum >= 0.0) return mesh;
  for (auto& normal : mesh.normals) normal = -normal;
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

/// Middle of the collar, below the chin.
Eigen::Vector3d collarOf(const VirtualPatient& patient) {
  const Eigen::Vector3d& centre_mm = patient.head_centre.mm;
  const double chin_mm =
      patient.landmarks68_mm.empty() ? centre_mm.z() - 105.0 : patient.landmarks68_mm[8].z();
  return {centre_mm.x(), centre_mm.y() - 15.0, chin_mm - 45.0};
}

class FabricLook : public Look {
 public:
  FabricLook(Pattern pattern, double period_mm, double albedo, double contrast, double turn_deg)
      : pattern_(pattern),
        period_mm_(period_mm),
        albedo_(albedo),
        contrast_(contrast),
        cosine_(std::cos(turn_deg * kRadPerDeg)),
        sine_(std::sin(turn_deg * kRadPerDeg)) {}
  Reflectance at(const SurfacePoint& point) const override {
    const Eigen::Vector3d& p = point.p_object_mm;
    const double printed = contrast_ * patternAt(pattern_, period_mm_, cosine_ * p.x() + sine_ * p.z(),
                                                 cosine_ * p.z() - sine_ * p.x());
    const double weave = 0.04 * sharedNoise().at(p, 1.5);
    return {float(albedo_ * std::max(0.05, 1.0 + printed + weave)), 0.005f};
  }

 private:
  Pattern pattern_;
  double period_mm_, albedo_, contrast_, cosine_, sine_;
};

class StrandLook : public Look {
 public:
  explicit StrandLook(float albedo) : albedo_(albedo) {}
  Reflectance at(const SurfacePoint& point) const override {
    const Eigen::Vector3d combed(point.p_object_mm.x(), point.p_object_mm.y(), 0.15 * point.p_object_mm.z());
    const float strands = sharedNoise().at(combed, 0.8), locks = sharedNoise().at(combed, 5.0);
    return {albedo_ * std::max(0.25f, 1.f + 0.3f * strands + 0.3f * locks), 0.02f};
  }
  float redness(const SurfacePoint&) const override { return 0.25f; }

 private:
  float albedo_;
};

}  // namespace

surface::TriangleMesh capMesh(const VirtualPatient& patient, double above_brows_mm) {
  if (patient.landmarks68_mm.empty()) return {};
  constexpr double kOff_mm = 4.0, kVisor_mm = 65.0, kVisorHalf = 0.75;
  const HeadOutline outline(patient);
  const auto& l = patient.landmarks68_mm;
  const double brow_mm = 0.5 * (l[19].z() + l[24].z()) + above_brows_mm - outline.centre_mm().z();
  // The rim lies in a plane from the forehead down to the nape.
  const auto rim = [&](double azimuth) {
    const double drop = 0.25 * (1.0 - std::cos(azimuth));
    return std::atan2(brow_mm, outline.reach_mm(0.0, std::atan2(brow_mm, 95.0))) - drop;
  };
  const auto dome = sheet(24, 72, [&](double up, double around) {
    const double azimuth = 2.0 * M_PI * around - M_PI, from = rim(azimuth);
    return outline.at(azimuth, from + up * (0.5 * M_PI - from), kOff_mm + 6.0 * std::sin(M_PI * up));
  });
  const auto visor = sheet(10, 30, [&](double out, double across) {
    const double azimuth = kVisorHalf * (2.0 * across - 1.0), aside = azimuth / kVisorHalf;
    Eigen::Vector3d p_mm = outline.at(azimuth, rim(azimuth), kOff_mm);
    p_mm.y() += out * kVisor_mm * (1.0 - aside * aside);
    p_mm.z() -= 12.0 * out + 8.0 * aside * aside;
    return p_mm;
  });
  const Eigen::Vector3d& centre_mm = outline.centre_mm();
  return joined(outwards(dome, centre_mm), outwards(visor, centre_mm - Eigen::Vector3d(0, 0, 300)));
}

surface::TriangleMesh longHairMesh(const VirtualPatient& patient, double below_chin_mm, double aside_rad) {
  if (patient.landmarks68_mm.empty()) return {};
  constexpr double kOff_mm = 7.0, kTop_mm = 85.0, kTuft_mm = 4.0;
  const HeadOutline outline(patient);
  const double chin_mm = patient.landmarks68_mm[8].z() - outline.centre_mm().z();
  const int rows = 60, columns = 90;
  // Hair hangs straight from where the head is widest.
  std::vector<double> widest(std::size_t(columns) + 1, 0.0);
  const auto curtain = sheet(rows, columns, [&](double down, double around) {
    const double azimuth = aside_rad + around * 2.0 * (M_PI - aside_rad);
    const double up_mm = kTop_mm + down * (chin_mm - below_chin_mm - kTop_mm);
    double& width = widest[std::size_t(std::lround(around * columns))];
    width = std::max(width, outline.width_mm(azimuth, up_mm) + kOff_mm * std::min(1.0, 4.0 * down));
    const double tuft_mm =
        kTuft_mm * sharedNoise().at({40.0 * azimuth, 0.1 * up_mm, 0.0}, 4.0) * std::min(1.0, 3.0 * down);
    return Eigen::Vector3d(outline.centre_mm() + Eigen::Vector3d((width + tuft_mm) * std::sin(azimuth),
                                                                 (width + tuft_mm) * std::cos(azimuth),
                                                                 up_mm));
  });
  return outwards(curtain, outline.centre_mm());
}

surface::TriangleMesh neckMesh(const VirtualPatient& patient) {
  constexpr double kRadius_mm = 52.0, kLong_mm = 75.0;
  const Eigen::Vector3d collar_mm = collarOf(patient);
  return outwards(sheet(10, 60,
                        [&](double down, double around) {
                          const double azimuth = 2.0 * M_PI * around;
                          return Eigen::Vector3d(collar_mm + Eigen::Vector3d(kRadius_mm * std::sin(azimuth),
                                                                             kRadius_mm * std::cos(azimuth),
                                                                             kLong_mm * (0.8 - down)));
                        }),
                  collar_mm);
}

surface::TriangleMesh clothesMesh(const VirtualPatient& patient) {
  constexpr double kNeck_mm = 58.0, kHalf_mm = 220.0, kDepth_mm = 105.0;
  const Eigen::Vector3d neck_mm = collarOf(patient);
  // From the collar over sloping shoulders down the chest: rings that widen from the neck's circle to an
  // oval.
  return outwards(
      sheet(50, 96,
            [&](double down, double around) {
              const double azimuth = 2.0 * M_PI * around, wide = std::sqrt(std::min(1.0, 2.2 * down));
              const double half_mm = kNeck_mm + wide * (kHalf_mm - kNeck_mm),
                           depth_mm = kNeck_mm + wide * (kDepth_mm - kNeck_mm);
              const double drop_mm = 90.0 * wide * wide + 750.0 * std::max(0.0, down - 0.25);
              return Eigen::Vector3d(neck_mm + Eigen::Vector3d(half_mm * std::sin(azimuth),
                                                               depth_mm * std::cos(azimuth), -drop_mm));
            }),
      neck_mm - Eigen::Vector3d(0, 0, 200));
}

std::shared_ptr<const Look> makeFabricLook(Pattern pattern, double period_mm, double albedo, double contrast,
                                           double turn_deg) {
  return std::make_shared<FabricLook>(pattern, period_mm, albedo, contrast, turn_deg);
}

std::shared_ptr<const Look> makeStrandLook(float albedo) { return std::make_shared<StrandLook>(albedo); }

}  // namespace facenav::room
