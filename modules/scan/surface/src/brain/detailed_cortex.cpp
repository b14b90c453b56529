#include "facenav/surface/detailed_cortex.h"

#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "facenav/core/error.h"
#include "mesh/mesh_polydata.h"

namespace facenav::surface {
namespace {

constexpr const char* kDistance = "distance_mm";

}  // namespace

ModelDistance distanceBetween(const DetailedCortex& cortex, const BrainModel& model) {
  return {summarise(cortex.distance_mm), summarise(signedDistances_mm(model.mesh, cortex.mesh))};
}

void writeCortex(const DetailedCortex& cortex, const std::filesystem::path& vtp, FileAccess access) {
  FACENAV_EXPECT(cortex.distance_mm.size() == cortex.mesh.vertices_mm.size(), "one distance per vertex");
  const auto poly_data = toPolyData(cortex.mesh);
  addPointValues(*poly_data, kDistance, cortex.distance_mm);
  writePolyData(*poly_data, vtp, access);
}

DetailedCortex readCortex(const std::filesystem::path& vtp) {
  const auto poly_data = readPolyData(vtp);
  DetailedCortex cortex{toTriangleMesh(*poly_data), {}};
  vtkDataArray* distance = poly_data->GetPointData()->GetArray(kDistance);
  if (!distance || distance->GetNumberOfComponents() != 1 ||
      distance->GetNumberOfTuples() != vtkIdType(cortex.mesh.vertices_mm.size()))
    throw Error("the cortex has no distances to the phi-theta surface", vtp.string(),
                "prepare the case again");
  for (vtkIdType i = 0; i < distance->GetNumberOfTuples(); ++i)
    cortex.distance_mm.push_back(float(distance->GetTuple1(i)));
  return cortex;
}

}  // namespace facenav::surface
