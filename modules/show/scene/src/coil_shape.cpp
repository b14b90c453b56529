#include "facenav/scene/coil_shape.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkSTLReader.h>

#include <cmath>

#include "facenav/core/error.h"

namespace facenav::scene {
namespace {

using Profile = std::vector<Eigen::Vector2d>;  // closed polygon (radius or offset, z), counter-clockwise

/// Makes a rectangle with rounded corners.
Profile roundedProfile(double low, double high, double z_low, double z_high, double radius) {
  Profile profile;
  const Eigen::Vector2d corners[4] = {{high - radius, z_low + radius},
                                      {high - radius, z_high - radius},
                                      {low + radius, z_high - radius},
                                      {low + radius, z_low + radius}};
  for (int c = 0; c < 4; ++c)
    for (int i = 0; i <= 4; ++i) {
      const double angle = (c - 1) * M_PI / 2 + i * M_PI / 8;
      profile.push_back(corners[c] + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
  return profile;
}

void addQuads(surface::TriangleMesh& mesh, int rings, int per_ring, bool is_closed, std::size_t base) {
  for (int r = 0; r + (is_closed ? 0 : 1) < rings; ++r)
    for (int i = 0; i < per_ring; ++i) {
      const int next_ring = (r + 1) % rings, next = (i + 1) % per_ring;
      const int a = int(base) + r * per_ring + i, b = int(base) + r * per_ring + next;
      const int c = int(base) + next_ring * per_ring + next, d = int(base) + next_ring * per_ring + i;
      mesh.triangles.emplace_back(a, d, b);
      mesh.triangles.emplace_back(b, d, c);
    }
}

void addRing(surface::TriangleMesh& mesh, const Eigen::Vector2d& centre, const Profile& profile, int steps) {
  const std::size_t base = mesh.vertices_mm.size();
  for (int s = 0; s < steps; ++s) {
    const double angle = 2 * M_PI * s / steps;
    for (const auto& p : profile)
      mesh.vertices_mm.emplace_back(centre.x() + p.x() * std::cos(angle),
                                    centre.y() + p.x() * std::sin(angle), p.y());
  }
  addQuads(mesh, steps, int(profile.size()), true, base);
}

void addHandle(surface::TriangleMesh& mesh, const Profile& profile, double y_start, double y_end) {
  const std::size_t base = mesh.vertices_mm.size();
  const int per_ring = int(profile.size());
  for (double y : {y_start, y_end})
    for (const auto& p : profile) mesh.vertices_mm.emplace_back(p.x(), y, p.y());
  addQuads(mesh, 2, per_ring, false, base);
  const int end = int(base) + per_ring;
  for (int i = 1; i + 1 < per_ring; ++i) mesh.triangles.emplace_back(end, end + i, end + i + 1);
}

/// Splits vertices at creases; normals point outward.
surface::TriangleMesh withNormals(vtkPolyData* poly);

vtkSmartPointer<vtkPolyData> toPoly(const surface::TriangleMesh& mesh) {
  vtkNew<vtkPoints> points;
  for (const auto& v : mesh.vertices_mm) points->InsertNextPoint(v.data());
  vtkNew<vtkCellArray> cells;
  for (const auto& t : mesh.triangles) {
    const vtkIdType ids[3] = {t[0], t[1], t[2]};
    cells->InsertNextCell(3, ids);
  }
  auto poly = vtkSmartPointer<vtkPolyData>::New();
  poly->SetPoints(points);
  poly->SetPolys(cells);
  return poly;
}

surface::TriangleMesh withNormals(vtkPolyData* poly) {
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(poly);
  normals->SetFeatureAngle(35.0);
  normals->ConsistencyOn();
  normals->AutoOrientNormalsOn();
  normals->Update();
  vtkPolyData* out = normals->GetOutput();
  surface::TriangleMesh mesh;
  for (vtkIdType i = 0; i < out->GetNumberOfPoints(); ++i) {
    mesh.vertices_mm.emplace_back(Eigen::Map<const Eigen::Vector3d>(out->GetPoint(i)));
    mesh.normals.emplace_back(
        Eigen::Map<const Eigen::Vector3d>(out->GetPointData()->GetNormals()->GetTuple(i)));
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < out->GetNumberOfCells(); ++c) {
    out->GetCellPoints(c, ids);
    if (ids->GetNumberOfIds() == 3)
      mesh.triangles.emplace_back(int(ids->GetId(0)), int(ids->GetId(1)), int(ids->GetId(2)));
  }
  return mesh;
}

}  // namespace

CoilShape makeCoilShape(const CoilShapeOptions& o) {
  const double centre_x = o.wing_outer_radius_mm - 1.5;
  surface::TriangleMesh body, windings;
  const Profile plate = roundedProfile(0.0, o.wing_outer_radius_mm + 4.0, -o.thickness_mm, 0.0, 3.0);
  const Profile copper = roundedProfile(o.wing_inner_radius_mm, o.wing_outer_radius_mm - 2.0,
                                        -o.thickness_mm * 0.78, -o.thickness_mm * 0.22, 2.5);
  for (double side : {-1.0, 1.0}) {
    addRing(body, {side * centre_x, 0.0}, plate, 64);
    addRing(windings, {side * centre_x, 0.0}, copper, 72);
  }
  addHandle(body, roundedProfile(-13.0, 13.0, -o.thickness_mm - 6.0, 0.0, 6.0), -20.0,
            -20.0 - o.handle_length_mm);
  return {withNormals(toPoly(body)), withNormals(toPoly(windings))};
}

CoilShape readCoilShape(const std::filesystem::path& stl) {
  if (!std::filesystem::exists(stl))
    throw Error("the coil's mesh is missing", stl.string(), "see \"mesh\" in coil.json");
  vtkNew<vtkSTLReader> reader;
  reader->SetFileName(stl.c_str());
  reader->Update();
  CoilShape shape;
  shape.body = withNormals(reader->GetOutput());
  if (shape.body.triangles.empty())
    throw Error("no triangles in the coil's mesh", stl.string(), "export it as STL");
  return shape;
}

}  // namespace facenav::scene
