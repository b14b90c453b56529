#include "facenav/surface/vector_file.h"

#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "facenav/core/error.h"
#include "mesh_polydata.h"

namespace facenav::surface {

void writeVectors(const VectorSurface& surface, const std::string& name, const std::filesystem::path& path,
                  FileAccess access) {
  FACENAV_EXPECT(surface.vectors.size() == surface.mesh.vertices_mm.size(), "one vector a vertex");
  const auto poly_data = toPolyData(surface.mesh);
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName(name.c_str());
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(vtkIdType(surface.vectors.size()));
  std::vector<float> lengths;
  for (std::size_t i = 0; i < surface.vectors.size(); ++i) {
    vectors->SetTuple(vtkIdType(i), surface.vectors[i].data());
    lengths.push_back(surface.vectors[i].norm());
  }
  poly_data->GetPointData()->AddArray(vectors);
  addPointValues(*poly_data, ("magn" + name).c_str(), lengths);
  writePolyData(*poly_data, path, access);
}

VectorSurface readVectors(const std::filesystem::path& path, const std::string& name) {
  const auto poly_data = readPolyData(path);
  vtkDataArray* array = poly_data->GetPointData()->GetArray(name.c_str());
  if (!array || array->GetNumberOfComponents() != 3 ||
      array->GetNumberOfTuples() != poly_data->GetNumberOfPoints())
    throw Error("holds no point data '" + name + "' of three components", path.string(),
                "export the field with the surface");
  VectorSurface surface{toTriangleMesh(*poly_data), {}};
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) {
    Eigen::Vector3d vector;
    array->GetTuple(i, vector.data());
    if (!vector.allFinite()) throw Error("holds a value that is no number", path.string(), "export it again");
    surface.vectors.push_back(vector.cast<float>());
  }
  return surface;
}

}  // namespace facenav::surface
