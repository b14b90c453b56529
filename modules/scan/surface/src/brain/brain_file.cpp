#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/surface/brain_model.h"
#include "mesh/mesh_polydata.h"

namespace facenav::surface {
namespace {

constexpr const char* kCentre = "centre_mm";
constexpr const char* kRadius = "radius_mm";
constexpr int kMostBins = 1 << 14;  // greatest number of bins per side

/// The map's row 0 is the image's top row; VTK's row 0 is the bottom one.
vtkSmartPointer<vtkImageData> picture(const SphericalMap& map) {
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(map.columns, map.rows, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  for (int r = 0; r < map.rows; ++r)
    std::copy_n(&map.colour[std::size_t(r) * map.columns], map.columns,
                static_cast<std::uint8_t*>(image->GetScalarPointer(0, map.rows - 1 - r, 0)));
  return image;
}

void addField(vtkPolyData& poly_data, const char* name, int components, const double* values,
              std::size_t count) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(vtkIdType(count));
  std::copy_n(values, count * components, array->GetPointer(0));
  poly_data.GetFieldData()->AddArray(array);
}

SphericalMap readPicture(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) throw Error("no such texture file", path.string());
  vtkNew<vtkPNGReader> reader;
  if (!reader->CanReadFile(path.c_str()))
    throw Error("not a PNG picture", path.string(), "prepare the case again");
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  int size[3];
  image->GetDimensions(size);
  if (reader->GetErrorCode() != 0 || image->GetScalarType() != VTK_UNSIGNED_CHAR || size[0] < 4 ||
      size[1] < 4 || size[0] > kMostBins || size[1] > kMostBins || !image->GetScalarPointer())
    throw Error("damaged texture picture", path.string(), "prepare the case again");
  SphericalMap map;
  map.columns = size[0], map.rows = size[1];
  for (int r = 0; r < map.rows; ++r)
    for (int c = 0; c < map.columns; ++c)
      map.colour.push_back(*static_cast<std::uint8_t*>(image->GetScalarPointer(c, map.rows - 1 - r, 0)));
  return map;
}

vtkDataArray& field(vtkPolyData& poly_data, const char* name, vtkIdType values,
                    const std::filesystem::path& path) {
  vtkDataArray* array = poly_data.GetFieldData()->GetArray(name);
  if (!array || array->GetNumberOfValues() != values)
    throw Error(std::string("the brain surface has no field '") + name + "' that fits its texture",
                path.string(), "prepare the case again");
  return *array;
}

}  // namespace

void writeBrain(const BrainModel& brain, const std::filesystem::path& vtp,
                const std::filesystem::path& texture_png, FileAccess access) {
  const auto poly_data = toPolyData(brain.mesh);
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("TextureCoordinates");
  coordinates->SetNumberOfComponents(2);
  for (const auto& t : brain.texture_coordinates) coordinates->InsertNextTuple2(t.x(), t.y());
  poly_data->GetPointData()->SetTCoords(coordinates);
  addField(*poly_data, kCentre, 3, brain.map.centre.mm.data(), 1);
  addField(*poly_data, kRadius, 1, brain.map.radius_mm.data(), brain.map.radius_mm.size());
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(picture(brain.map));
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* png = writer->GetResult();
  WholeFile texture(texture_png, access);  // appears after the surface
  std::ofstream stream(texture.temporaryPath(), std::ios::binary);
  stream.write(reinterpret_cast<const char*>(png->GetPointer(0)), std::streamsize(png->GetNumberOfValues()));
  stream.close();
  if (!stream) throw Error("the texture could not be written", texture_png.string(), "is the disk full?");
  writePolyData(*poly_data, vtp, access);
  texture.commit();
}

BrainModel readBrain(const std::filesystem::path& vtp, const std::filesystem::path& texture_png) {
  BrainModel brain;
  brain.map = readPicture(texture_png);
  const auto poly_data = readPolyData(vtp);
  field(*poly_data, kCentre, 3, vtp).GetTuple(0, brain.map.centre.mm.data());
  vtkDataArray& radius = field(*poly_data, kRadius, vtkIdType(brain.map.colour.size()), vtp);
  for (vtkIdType i = 0; i < radius.GetNumberOfValues(); ++i)
    brain.map.radius_mm.push_back(radius.GetTuple1(i));
  vtkDataArray* coordinates = poly_data->GetPointData()->GetTCoords();
  if (!coordinates || coordinates->GetNumberOfComponents() != 2)
    throw Error("the brain surface has no texture coordinates", vtp.string(), "prepare the case again");
  for (vtkIdType i = 0; i < coordinates->GetNumberOfTuples(); ++i)
    brain.texture_coordinates.emplace_back(float(coordinates->GetComponent(i, 0)),
                                           float(coordinates->GetComponent(i, 1)));
  brain.mesh = toTriangleMesh(*poly_data);
  return brain;
}

}  // namespace facenav::surface
