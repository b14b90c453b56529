#include "facenav/surface/brain_model.h"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkDelaunay2D.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <Eigen/Geometry>
#include <array>
#include <fstream>
#include <map>
#include <random>
#include <set>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "support/matchers.h"
#include "support/test_data.h"

// The phi-theta brain on an ellipsoid with bright marks, with surface and texture known in closed form.

namespace facenav {
namespace {

using Eigen::Vector3d;
using surface::BrainModel;
using surface::BrainModelOptions;

const Vector3d kCentre_mm(7, -12, 21), kRadii_mm(62, 80, 55);

struct Ellipsoid {
  volume::Volume volume;
  volume::Mask brain;
};

/// Ellipsoid with value 100 inside, 10 outside, 250 in balls of 9 mm around the marks.
Ellipsoid makeEllipsoid(const std::vector<Vector3d>& marks_mm, double oblique_rad = 0.3) {
  Ellipsoid e;
  e.volume.grid.size = {120, 140, 110};
  e.volume.grid.mri_from_voxel =
      Eigen::Translation3d(kCentre_mm) * Eigen::AngleAxisd(oblique_rad, Vector3d(1, 2, 3).normalized()) *
      Eigen::Scaling(Vector3d(1.3, -1.4, 1.5)) * Eigen::Translation3d(-59.5, -69.5, -54.5);
  e.brain.grid = e.volume.grid;
  for (int k = 0; k < 110; ++k)
    for (int j = 0; j < 140; ++j)
      for (int i = 0; i < 120; ++i) {
        const Vector3d p = e.volume.grid.toMri({double(i), double(j), double(k)}).mm;
        const bool is_inside = (p - kCentre_mm).cwiseQuotient(kRadii_mm).norm() <= 1;
        float value = is_inside ? 100 : 10;
        for (const auto& mark : marks_mm)
          if (is_inside && (p - mark).norm() < 9) value = 250;
        e.volume.voxels.push_back(value);
        e.brain.voxels.push_back(is_inside);
      }
  return e;
}

BrainModel modelOf(const Ellipsoid& e, int rows = 180, int columns = 180) {
  BrainModelOptions options;
  options.rows = rows, options.columns = columns;
  TaskMonitor monitor;
  return surface::buildBrainModel(e.volume, e.brain, options, monitor);
}

const BrainModel& plainModel() {
  static const BrainModel model = modelOf(makeEllipsoid({}));
  return model;
}

double ellipsoidRadius(const Vector3d& direction) { return 1 / direction.cwiseQuotient(kRadii_mm).norm(); }

/// Counts vertices at identical positions as one.
std::vector<int> welded(const surface::TriangleMesh& mesh) {
  std::map<std::array<double, 3>, int> seen;
  std::vector<int> index;
  for (const auto& v : mesh.vertices_mm)
    index.push_back(seen.emplace(std::array<double, 3>{v.x(), v.y(), v.z()}, int(seen.size())).first->second);
  return index;
}

int colourAt(const BrainModel& model, const Vector3d& p_mm) {
  const auto angles = surface::toAngles(Point<Mri>(p_mm), model.map.centre);
  const int row = std::min(model.map.rows - 1, int(angles.phi_rad / M_PI * model.map.rows));
  const int column =
      std::min(model.map.columns - 1, int((angles.theta_rad + M_PI) / (2 * M_PI) * model.map.columns));
  return model.map.colour[std::size_t(row) * model.map.columns + column];
}

TEST(BrainModel, AnglesAndDirectionsUndoEachOther) {
  for (const Vector3d& p :
       {Vector3d(1, 2, 3), Vector3d(-4, 1, -2), Vector3d(3, -1, 5), Vector3d(-2, -2, 1)}) {
    const auto angles = surface::toAngles(Point<Mri>(p + kCentre_mm), Point<Mri>(kCentre_mm));
    EXPECT_THAT(surface::toDirection(angles).v, testing::EigenNear(p.normalized(), 1e-12));
  }
}

TEST(BrainModel, RadiusFollowsTheEllipsoidToSubVoxel) {
  const auto& map = plainModel().map;
  EXPECT_THAT(map.centre.mm, testing::EigenNear(kCentre_mm, 0.1));
  double worst = 0, sum = 0;
  for (int r = 0; r < map.rows; ++r)
    for (int c = 0; c < map.columns; ++c) {
      const auto d =
          surface::toDirection({(r + 0.5) * M_PI / map.rows, -M_PI + (c + 0.5) * 2 * M_PI / map.columns}).v;
      const double error = map.radius_mm[std::size_t(r) * map.columns + c] - ellipsoidRadius(d);
      worst = std::max(worst, std::abs(error)), sum += error;
    }
  EXPECT_LT(worst, 1.0);  // voxels are 1.3 to 1.5 mm
  EXPECT_NEAR(sum / (map.rows * map.columns), 0, 0.15);
}

TEST(BrainModel, IsClosedOutwardAndWithoutDegenerateTriangles) {
  for (const auto& size : {std::array<int, 2>{180, 180}, {17, 31}, {360, 360}, {720, 720}}) {
    const BrainModel model = size[0] == 180 ? plainModel() : modelOf(makeEllipsoid({}), size[0], size[1]);
    const auto index = welded(model.mesh);
    std::map<std::pair<int, int>, int> directed;
    double volume_mm3 = 0;
    for (const auto& t : model.mesh.triangles) {
      const Vector3d a = model.mesh.vertices_mm[t[0]], b = model.mesh.vertices_mm[t[1]],
                     c = model.mesh.vertices_mm[t[2]];
      EXPECT_GT((b - a).cross(c - a).norm(), 1e-9);
      EXPECT_GT((b - a).cross(c - a).dot((a + b + c) / 3 - model.map.centre.mm), 0);
      volume_mm3 += a.dot(b.cross(c)) / 6;
      for (int e = 0; e < 3; ++e) ++directed[{index[t[e]], index[t[(e + 1) % 3]]}];
    }
    for (const auto& [edge, count] : directed) {
      ASSERT_EQ(count, 1);
      ASSERT_TRUE(
          directed.count({edge.second, edge.first}));  // its neighbour runs along it in the other direction
    }
    const std::set<int> vertices(index.begin(), index.end());
    EXPECT_EQ(int(vertices.size()) - int(directed.size()) / 2 + int(model.mesh.triangles.size()),
              2);  // Euler: one sphere
    EXPECT_NEAR(volume_mm3 / (4 * M_PI / 3 * kRadii_mm.prod()), 1, size[0] == 17 ? 0.06 : 0.01);
  }
}

/// Folded brain: gyri, deep folds, a cut at the base. Radii change abruptly from bin to bin.
surface::SphericalMap crumpled(int rows, int columns) {
  surface::SphericalMap map;
  map.rows = rows, map.columns = columns;
  map.centre = Point<Mri>(kCentre_mm);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> jump(-6, 6);
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      const double phi = (r + 0.5) * M_PI / rows, theta = 2 * M_PI * (c + 0.5) / columns;
      const double fold = std::sin(40 * phi) * std::cos(23 * theta) > 0.8 ? -25 : 0;
      map.radius_mm.push_back(60 + 12 * std::sin(9 * theta) * std::sin(phi) + fold + jump(random));
      map.colour.push_back(100);
    }
  return map;
}

/// Solid angle of a triangle seen from the origin (van Oosterom and Strackee 1983), > 0 when
/// counter-clockwise from outside.
double solidAngle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const double x = a.norm(), y = b.norm(), z = c.norm();
  return 2 * std::atan2(a.dot(b.cross(c)), x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y);
}

TEST(BrainModel, DoesNotCutItselfOnAnyGridHoweverCrumpled) {
  // Every triangle faces away from the centre, and together they cover the sphere of directions once. So no
  // direction meets two triangles, and no two of them can intersect.
  for (const int size : {180, 360, 720}) {
    const auto model = surface::meshOf(crumpled(size, size));
    double covered = 0, least = 1;
    for (const auto& t : model.mesh.triangles) {
      const auto corner = [&](int c) -> Vector3d {
        return model.mesh.vertices_mm[std::size_t(t[c])] - kCentre_mm;
      };
      const double angle = solidAngle(corner(0), corner(1), corner(2));
      least = std::min(least, angle);
      covered += angle;
    }
    EXPECT_GT(least, 0) << size;
    EXPECT_NEAR(covered, 4 * M_PI, 1e-6) << size;
  }
}

TEST(BrainModel, ShowsMarksAboveAndBelowAtTheirOwnPlaces) {
  // Equation 8 of the paper, as printed, would map +z and -z to one place: a mark at one must not appear at
  // the other.
  const Vector3d up = kCentre_mm + Vector3d(0, 0, 55), down = kCentre_mm - Vector3d(0, 0, 55);
  const auto above = modelOf(makeEllipsoid({up})), below = modelOf(makeEllipsoid({down}));
  EXPECT_GE(colourAt(above, up), 250);
  EXPECT_LE(colourAt(above, down), colourAt(above, up) - 50);
  EXPECT_GE(colourAt(below, down), 250);
  EXPECT_LE(colourAt(below, up), colourAt(below, down) - 50);
}

TEST(BrainModel, ShowsMarksAcrossSeamAndPoles) {
  const Vector3d left = kCentre_mm - Vector3d(62, 0, 0), front = kCentre_mm + Vector3d(0, 80, 0),
                 back = kCentre_mm - Vector3d(0, 80, 0);
  const auto model = modelOf(makeEllipsoid({left, front, back}));
  for (const Vector3d& offset :
       {Vector3d(0, 2, 2), Vector3d(0, 2, -2), Vector3d(0, -2, 2), Vector3d(0, -2, -2)})
    EXPECT_GE(colourAt(model, left + offset), 250);
  for (const Vector3d& offset :
       {Vector3d(2, 0, 2), Vector3d(-2, 0, 2), Vector3d(2, 0, -2), Vector3d(-2, 0, -2)}) {
    EXPECT_GE(colourAt(model, front + offset), 250);
    EXPECT_GE(colourAt(model, back + offset), 250);
  }
}

TEST(BrainModel, TextureCoordinatesPointAtTheVertexsBin) {
  const BrainModel& model = plainModel();
  ASSERT_EQ(model.texture_coordinates.size(), model.mesh.vertices_mm.size());
  for (std::size_t i = 0; i < model.mesh.vertices_mm.size(); i += 97) {
    const auto uv = model.texture_coordinates[i];
    ASSERT_GE(uv.minCoeff(), 0);
    ASSERT_LE(uv.maxCoeff(), 1);
    const auto expected = surface::toDirection({(1 - uv.y()) * M_PI, (2.0 * uv.x() - 1) * M_PI}).v;
    ASSERT_THAT((model.mesh.vertices_mm[i] - model.map.centre.mm).normalized(),
                testing::EigenNear(expected, 1e-5));
    ASSERT_GT(model.mesh.normals[i].dot(expected), 0.5);
  }
}

TEST(BrainModel, TriangulatesAsDelaunayDoes) {
  const int rows = 12, columns = 15, ring = columns + 2;
  const BrainModel model = modelOf(makeEllipsoid({}), rows, columns);
  vtkNew<vtkPoints> plane;
  plane->SetDataTypeToDouble();
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < ring; ++c)
      plane->InsertNextPoint((c == 0 ? 0 : c == ring - 1 ? columns : c - 0.5) + 0.2 * r, r, 0);
  vtkNew<vtkPolyData> points;
  points->SetPoints(plane);
  vtkNew<vtkDelaunay2D> delaunay;
  delaunay->SetInputData(points);
  delaunay->SetOffset(10);
  delaunay->Update();
  std::set<std::set<int>> expected, found;
  auto cell = vtk::TakeSmartPointer(delaunay->GetOutput()->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell()) {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(size, ids);
    expected.insert({int(ids[0]), int(ids[1]), int(ids[2])});
  }
  for (const auto& t : model.mesh.triangles)
    if (t.maxCoeff() < rows * ring) found.insert({t[0], t[1], t[2]});
  EXPECT_EQ(found, expected);
}

TEST(BrainModel, FillsBinsWithoutSurfaceFromTheirNeighbours) {
  Ellipsoid e = makeEllipsoid({});
  // A hole from the centre to the right, wider than a bin: rays along it meet no brain.
  for (std::size_t v = 0; v < e.brain.voxels.size(); ++v) {
    const int i = int(v % 120), j = int(v / 120 % 140), k = int(v / (120 * 140));
    const Vector3d p = e.brain.grid.toMri({double(i), double(j), double(k)}).mm - kCentre_mm;
    if (p.x() > -4 && std::hypot(p.y(), p.z()) < 6) e.brain.voxels[v] = 0;
  }
  const auto map = modelOf(e).map;
  for (double r : map.radius_mm) {
    ASSERT_GT(r, 5);
    ASSERT_LT(r, 82);
  }
}

TEST(BrainModel, RefusesAnEmptyMask) {
  Ellipsoid e = makeEllipsoid({});
  std::fill(e.brain.voxels.begin(), e.brain.voxels.end(), 0);
  EXPECT_THROW(modelOf(e), Error);
}

TEST(BrainModelFile, IsReadBackAsItWasWritten) {
  testing::TemporaryFolder folder;
  const auto vtp = folder.path() / "brain.vtp", png = folder.path() / "brain_texture.png";
  surface::writeBrain(plainModel(), vtp, png);
  const BrainModel read = surface::readBrain(vtp, png);
  EXPECT_EQ(read.map.colour, plainModel().map.colour);
  EXPECT_EQ(read.map.rows, 180);
  EXPECT_EQ(read.map.radius_mm, plainModel().map.radius_mm);
  EXPECT_EQ(read.map.centre.mm, plainModel().map.centre.mm);
  EXPECT_EQ(read.mesh.vertices_mm, plainModel().mesh.vertices_mm);
  EXPECT_EQ(read.mesh.triangles, plainModel().mesh.triangles);
  EXPECT_EQ(read.texture_coordinates, plainModel().texture_coordinates);
}

TEST(BrainModelFile, RefusesDamagedOrForeignFiles) {
  testing::TemporaryFolder folder;
  const auto vtp = folder.path() / "brain.vtp", png = folder.path() / "brain_texture.png";
  EXPECT_THROW(surface::readBrain(vtp, png), Error);
  surface::writeBrain(plainModel(), vtp, png);
  surface::writeBrain(modelOf(makeEllipsoid({}), 16, 16), folder.path() / "other.vtp",
                      folder.path() / "other.png");
  EXPECT_THROW(surface::readBrain(folder.path() / "other.vtp", png), Error);
  const std::string whole = readWholeFile(vtp);
  std::ofstream(vtp, std::ios::trunc) << whole.substr(0, whole.size() / 3);
  EXPECT_THROW(surface::readBrain(vtp, png), Error);
}

}  // namespace
}  // namespace facenav
