#include "coarse_mesh.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkQuadricClustering.h>
#include <vtkStaticPointLocator.h>

#include <algorithm>

#include "facenav/core/error.h"
#include "image_bridge.h"

namespace facenav::scene {
namespace {

surface::TriangleMesh toMesh(vtkPolyData* poly) {
  surface::TriangleMesh mesh;
  for (vtkIdType i = 0; i < poly->GetNumberOfPoints(); ++i) {
    mesh.vertices_mm.emplace_back(Eigen::Map<const Eigen::Vector3d>(poly->GetPoint(i)));
    mesh.normals.emplace_back(
        Eigen::Map<const Eigen::Vector3d>(poly->GetPointData()->GetNormals()->GetTuple3(i)));
  }
  auto cell = vtk::TakeSmartPointer(poly->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell()) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(count, ids);
    if (count == 3) mesh.triangles.emplace_back(int(ids[0]), int(ids[1]), int(ids[2]));
  }
  return mesh;
}

}  // namespace

surface::TriangleMesh coarsened(const surface::TriangleMesh& mesh, double cell_mm) {
  vtkNew<vtkQuadricClustering> clusters;
  auto poly = toPolyData(mesh);
  clusters->SetInputData(poly);
  clusters->AutoAdjustNumberOfDivisionsOff();
  double box[6];
  poly->GetBounds(box);
  const auto divisions = [&](int axis) {
    return std::max(8, int((box[2 * axis + 1] - box[2 * axis]) / cell_mm));
  };
  clusters->SetNumberOfDivisions(divisions(0), divisions(1), divisions(2));
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(clusters->GetOutputPort());
  normals->SplittingOff();
  normals->ConsistencyOff();
  normals->Update();
  return toMesh(normals->GetOutput());
}

std::vector<float> valuesAtNearest(const surface::TriangleMesh& fine, const std::vector<float>& values,
                                   const surface::TriangleMesh& coarse) {
  FACENAV_EXPECT(fine.vertices_mm.size() == values.size(), "one value a vertex");
  vtkNew<vtkStaticPointLocator> locator;
  auto poly = toPolyData(fine);
  locator->SetDataSet(poly);
  locator->BuildLocator();
  std::vector<float> nearest(coarse.vertices_mm.size());
  for (std::size_t i = 0; i < nearest.size(); ++i)
    nearest[i] = values[std::size_t(locator->FindClosestPoint(coarse.vertices_mm[i].data()))];
  return nearest;
}

}  // namespace facenav::scene
