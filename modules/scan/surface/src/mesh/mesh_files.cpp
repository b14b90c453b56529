#include "facenav/surface/mesh_files.h"

#include <vtkOBJWriter.h>
#include <vtkPLYWriter.h>
#include <vtkPolyData.h>
#include <vtkSTLWriter.h>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "gifti_file.h"
#include "mesh_polydata.h"

namespace facenav::surface {
namespace {

constexpr char kComment[] = "FaceNav SPACE=RAS UNITS=mm";

template <class Writer>
bool write(Writer& writer, const TriangleMesh& mesh, const std::filesystem::path& path) {
  writer.SetInputData(toPolyData(mesh));
  writer.SetFileName(path.c_str());
  return writer.Write() == 1 && writer.GetErrorCode() == 0;
}

bool writeStl(const TriangleMesh& mesh, const std::filesystem::path& path) {
  vtkNew<vtkSTLWriter> writer;
  writer->SetFileTypeToBinary();
  writer->SetHeader(kComment);
  return write(*writer, mesh, path);
}

bool writePly(const TriangleMesh& mesh, const std::filesystem::path& path) {
  vtkNew<vtkPLYWriter> writer;
  writer->AddComment(kComment);
  return write(*writer, mesh, path);
}

bool writeObj(const TriangleMesh& mesh, const std::filesystem::path& path) {
  vtkNew<vtkOBJWriter> writer;
  return write(*writer, mesh, path);
}

bool writeAs(MeshFormat format, const TriangleMesh& mesh, const std::filesystem::path& path) {
  switch (format) {
    case MeshFormat::stl:
      return writeStl(mesh, path);
    case MeshFormat::ply:
      return writePly(mesh, path);
    case MeshFormat::obj:
      return writeObj(mesh, path);
    case MeshFormat::gifti:
      return writeGifti(mesh, path);
    case MeshFormat::vtp:
      break;
  }
  return false;
}

}  // namespace

std::string extensionOf(MeshFormat format) {
  switch (format) {
    case MeshFormat::stl:
      return ".stl";
    case MeshFormat::ply:
      return ".ply";
    case MeshFormat::obj:
      return ".obj";
    case MeshFormat::vtp:
      return ".vtp";
    case MeshFormat::gifti:
      return ".gii";
  }
  return {};
}

void writeMesh(const TriangleMesh& mesh, MeshFormat format, const std::filesystem::path& path,
               FileAccess access) {
  if (mesh.triangles.empty()) throw Error("the surface is empty, nothing to write", path.string());
  if (format == MeshFormat::vtp) return writePolyData(*toPolyData(mesh), path, access);
  WholeFile file(path, access);
  if (!writeAs(format, mesh, file.temporaryPath()))
    throw Error("the surface could not be written", path.string(), "check disk space and permissions");
  file.commit();
}

}  // namespace facenav::surface
