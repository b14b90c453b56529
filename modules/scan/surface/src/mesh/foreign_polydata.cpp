#include "foreign_polydata.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkSTLReader.h>
#include <vtkTriangleFilter.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "../tracts/tract_formats.h"
#include "facenav/surface/mesh_reader.h"
#include "mesh_polydata.h"
#include "vtk_errors.h"

namespace facenav::surface {
namespace {

std::string endingOf(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return ending;
}

[[noreturn]] void refuseSurface(const std::filesystem::path& path, const std::string& what) {
  throw Error("the surface cannot be read: " + what, path.string(), "copy or export the file again");
}

template <class Reader>
vtkSmartPointer<vtkPolyData> readWith(const std::filesystem::path& path) {
  vtkNew<Reader> reader;
  vtkNew<ErrorListener> listener;
  reader->AddObserver(vtkCommand::ErrorEvent, listener);
  reader->AddObserver(vtkCommand::WarningEvent, listener);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, listener);  // reports a reader's failure
  reader->SetFileName(path.c_str());
  reader->Update();
  if (listener->has_error || reader->GetErrorCode() != 0 || !reader->GetOutput())
    refuseSurface(path, "it is damaged or of another kind");
  return reader->GetOutput();
}

/// True if the file's comment says LPS; 3D Slicer writes it within the first lines.
bool saysLps(const std::filesystem::path& path) {
  std::string start(1024, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(start.data(), std::streamsize(start.size()));
  return start.find("SPACE=LPS") != std::string::npos;
}

void toRas(vtkPolyData& poly, const std::filesystem::path& path) {
  vtkPoints* points = poly.GetPoints();
  if (!points) refuseSurface(path, "it holds no point");
  const bool is_lps = saysLps(path);
  vtkNew<vtkPoints> placed;
  placed->SetDataTypeToDouble();
  placed->SetNumberOfPoints(points->GetNumberOfPoints());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i) {
    double p[3];
    points->GetPoint(i, p);
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
      refuseSurface(path, "a coordinate is no number");
    is_lps ? placed->SetPoint(i, -p[0], -p[1], p[2]) : placed->SetPoint(i, p);
  }
  poly.SetPoints(placed);
}

}  // namespace

vtkSmartPointer<vtkPolyData> readForeignPolyData(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path))
    throw Error("file does not exist", path.string(), "check the path");
  const std::string ending = endingOf(path);
  vtkSmartPointer<vtkPolyData> read;
  if (ending == ".ply") read = readWith<vtkPLYReader>(path);
  if (ending == ".stl") read = readWith<vtkSTLReader>(path);
  if (ending == ".obj") read = readWith<vtkOBJReader>(path);
  if (ending == ".vtk") read = readWith<vtkPolyDataReader>(path);
  if (ending == ".vtp") read = readWith<vtkXMLPolyDataReader>(path);
  if (!read) refuseSurface(path, "its kind '" + ending + "' is not known");
  auto poly = vtkSmartPointer<vtkPolyData>::New();
  poly->DeepCopy(read);
  toRas(*poly, path);
  return poly;
}

bool isMeshName(const std::filesystem::path& path) {
  const std::string ending = endingOf(path);
  for (const char* known : {".ply", ".stl", ".obj", ".vtk", ".vtp"})
    if (ending == known) return true;
  return false;
}

bool holdsLines(const std::filesystem::path& path) {
  const std::string ending = endingOf(path);
  if (ending != ".vtk" && ending != ".vtp") return false;
  const auto poly = readForeignPolyData(path);
  return poly->GetNumberOfLines() > 0 && poly->GetNumberOfPolys() == 0 && poly->GetNumberOfStrips() == 0;
}

TriangleMesh readMesh(const std::filesystem::path& path) {
  const auto poly = readForeignPolyData(path);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(poly);
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->Update();
  TriangleMesh mesh;
  try {
    mesh = toTriangleMesh(*triangles->GetOutput());
  } catch (const Error& fault) {
    refuseSurface(path, fault.what());
  }
  if (mesh.triangles.empty()) refuseSurface(path, "it holds no triangle");
  mesh.normals = vertexNormals(mesh);  // the file's normals may be in the other frame
  return mesh;
}

TractLines readVtkLines(const std::filesystem::path& path) {
  const auto poly = readForeignPolyData(path);
  TractLines tracts;
  auto cell = vtk::TakeSmartPointer(poly->GetLines()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell()) {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(size, ids);
    for (vtkIdType i = 0; i < size; ++i) {
      if (ids[i] < 0 || ids[i] >= poly->GetNumberOfPoints())
        refuseTracts(path, "a line names a missing point");
      tracts.points_mm.push_back(Eigen::Map<const Eigen::Vector3d>(poly->GetPoint(ids[i])).cast<float>());
    }
    tracts.ends.push_back(tracts.points_mm.size());
  }
  return tracts;
}

bool isTractName(const std::filesystem::path& path) {
  const std::string ending = endingOf(path);
  return ending == ".trk" || ending == ".tck" || ending == ".trx";
}

TractLines readTracts(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path))
    throw Error("file does not exist", path.string(), "check the path");
  const std::string ending = endingOf(path);
  TractLines tracts = ending == ".trk"   ? readTrk(path)
                      : ending == ".tck" ? readTck(path)
                      : ending == ".trx" ? readTrx(path)
                                         : readVtkLines(path);
  if (tracts.lines() == 0 || tracts.points_mm.empty()) refuseTracts(path, "it holds no line");
  for (const auto& p : tracts.points_mm)
    if (!p.allFinite()) refuseTracts(path, "a coordinate is no number");
  return tracts;
}

}  // namespace facenav::surface
