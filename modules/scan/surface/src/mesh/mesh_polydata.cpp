#include "mesh_polydata.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/volume/fast_compressor.h"
#include "vtk_errors.h"

namespace facenav::surface {
namespace {

std::vector<Eigen::Vector3d> normalsOf(vtkPolyData& poly_data) {
  std::vector<Eigen::Vector3d> normals;
  vtkDataArray* array = poly_data.GetPointData()->GetNormals();
  if (!array || array->GetNumberOfComponents() != 3) return normals;
  normals.resize(array->GetNumberOfTuples());
  for (std::size_t i = 0; i < normals.size(); ++i) array->GetTuple(vtkIdType(i), normals[i].data());
  return normals;
}

}  // namespace

vtkSmartPointer<vtkPolyData> toPolyData(const TriangleMesh& mesh) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(vtkIdType(mesh.vertices_mm.size()));
  for (std::size_t i = 0; i < mesh.vertices_mm.size(); ++i)
    points->SetPoint(vtkIdType(i), mesh.vertices_mm[i].data());
  vtkNew<vtkCellArray> triangles;
  triangles->Use32BitStorage();
  triangles->AllocateEstimate(vtkIdType(mesh.triangles.size()), 3);
  for (const auto& t : mesh.triangles) triangles->InsertNextCell({t[0], t[1], t[2]});
  auto poly_data = vtkSmartPointer<vtkPolyData>::New();
  poly_data->SetPoints(points);
  poly_data->SetPolys(triangles);
  if (mesh.normals.size() == mesh.vertices_mm.size()) {
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(vtkIdType(mesh.normals.size()));
    for (std::size_t i = 0; i < mesh.normals.size(); ++i)
      normals->SetTuple(vtkIdType(i), mesh.normals[i].data());
    poly_data->GetPointData()->SetNormals(normals);
  }
  return poly_data;
}

TriangleMesh toTriangleMesh(vtkPolyData& poly_data) {
  TriangleMesh mesh;
  mesh.vertices_mm.resize(poly_data.GetNumberOfPoints());
  for (std::size_t i = 0; i < mesh.vertices_mm.size(); ++i)
    poly_data.GetPoint(vtkIdType(i), mesh.vertices_mm[i].data());
  auto cell = vtk::TakeSmartPointer(poly_data.GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell()) {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(size, ids);
    if (size != 3)
      throw Error("a mesh of triangles was expected, a polygon of " + std::to_string(size) +
                  " corners found");
    for (int c = 0; c < 3; ++c)
      if (ids[c] < 0 || ids[c] >= poly_data.GetNumberOfPoints())
        throw Error("a triangle names a point that is not there");
    mesh.triangles.emplace_back(int(ids[0]), int(ids[1]), int(ids[2]));
  }
  mesh.normals = normalsOf(poly_data);
  if (mesh.normals.size() != mesh.vertices_mm.size()) mesh.normals = vertexNormals(mesh);
  return mesh;
}

void addPointValues(vtkPolyData& poly_data, const char* name, const std::vector<float>& values) {
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(vtkIdType(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  poly_data.GetPointData()->AddArray(array);
}

std::vector<Eigen::Vector3d> vertexNormals(const TriangleMesh& mesh) {
  std::vector<Eigen::Vector3d> normals(mesh.vertices_mm.size(), Eigen::Vector3d::Zero());
  for (const auto& t : mesh.triangles) {
    const auto& a = mesh.vertices_mm[t[0]];
    const Eigen::Vector3d doubled_area = (mesh.vertices_mm[t[1]] - a).cross(mesh.vertices_mm[t[2]] - a);
    for (int c = 0; c < 3; ++c) normals[t[c]] += doubled_area;
  }
  for (auto& n : normals) n = n.norm() > 0 ? Eigen::Vector3d(n.normalized()) : Eigen::Vector3d::UnitZ();
  return normals;
}

void writePolyData(vtkPolyData& poly_data, const std::filesystem::path& path, FileAccess access) {
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(&poly_data);
  writer->WriteToOutputStringOn();  // on a full disk VTK would write many lines to the terminal
  writer->EncodeAppendedDataOff();
  writer->SetCompressor(volume::fastCompressor());
  if (writer->Write() != 1) throw Error("the surface could not be encoded", path.string());
  writeWholeFile(path, writer->GetOutputString(), access);
}

vtkSmartPointer<vtkPolyData> readPolyData(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) throw Error("no such surface file", path.string());
  vtkNew<vtkXMLPolyDataReader> reader;
  vtkNew<ErrorListener> listener;
  reader->AddObserver(vtkCommand::ErrorEvent, listener);
  reader->SetFileName(path.c_str());
  if (!reader->CanReadFile(path.c_str())) throw Error("not a VTK surface (.vtp)", path.string());
  reader->Update();
  if (listener->has_error || reader->GetErrorCode() != 0)
    throw Error("damaged surface file", path.string(), "prepare the case again");
  return reader->GetOutput();
}

}  // namespace facenav::surface
