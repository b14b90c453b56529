// atlas.vti. Displacements are stored as 16-bit integers in steps of 0.01 mm: a quarter of the size; the step
// is far below any registration's accuracy.

#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkShortArray.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLImageDataWriter.h>

#include <algorithm>
#include <cmath>

#include "facenav/atlas/atlas_map.h"
#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/volume/fast_compressor.h"

namespace facenav::atlas {
namespace {

constexpr char kAffine[] = "mri_from_mni", kDisplacement[] = "displacement_0.01mm";
constexpr double kStep_mm = 0.01;

Error malformed(const std::filesystem::path& path, const std::string& what) {
  return Error("not an atlas registration: " + what, path.string(), "run 'facenav prepare' again");
}

vtkSmartPointer<vtkDoubleArray> affineArray(const Eigen::Affine3d& affine) {
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(kAffine);
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) array->InsertNextValue(affine.matrix()(r, c));
  return array;
}

vtkSmartPointer<vtkShortArray> displacementArray(const std::vector<Eigen::Vector3f>& displacement_mm) {
  auto array = vtkSmartPointer<vtkShortArray>::New();
  array->SetName(kDisplacement);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(vtkIdType(displacement_mm.size()));
  short* out = array->GetPointer(0);
  for (const auto& d_mm : displacement_mm)
    for (int c = 0; c < 3; ++c)
      *out++ = short(std::lround(std::clamp(double(d_mm[c]) / kStep_mm, -32767.0, 32767.0)));
  return array;
}

Eigen::Affine3d readAffine(vtkImageData& image, const std::filesystem::path& path) {
  auto* array = vtkDataArray::SafeDownCast(image.GetFieldData()->GetAbstractArray(kAffine));
  if (!array || array->GetNumberOfValues() != 16) throw malformed(path, "no 4 x 4 field mri_from_mni");
  Eigen::Affine3d affine;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) affine.matrix()(r, c) = array->GetVariantValue(4 * r + c).ToDouble();
  if (!affine.matrix().allFinite() || affine.linear().determinant() <= 0)
    throw malformed(path, "mri_from_mni is mirrored or no affine");
  return affine;
}

}  // namespace

void writeAtlasMap(const AtlasMap& map, const std::filesystem::path& path) {
  const auto& grid = map.grid();
  const Eigen::Vector3d origin_mm = grid.mri_from_voxel.translation(), spacing_mm = grid.spacing_mm();
  vtkNew<vtkImageData> image;
  image->SetDimensions(grid.size.data());
  image->SetOrigin(origin_mm.data());
  image->SetSpacing(spacing_mm.data());
  image->GetPointData()->AddArray(displacementArray(map.displacement_mm()));
  image->GetFieldData()->AddArray(affineArray(map.affine()));
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(image);
  writer->WriteToOutputStringOn();  // on a full disk VTK would write many lines to the terminal
  writer->SetCompressor(volume::fastCompressor());
  writer->EncodeAppendedDataOff();
  if (writer->Write() != 1) throw Error("the atlas registration could not be encoded", path.string());
  writeWholeFile(path, writer->GetOutputString());
}

AtlasMap readAtlasMap(const std::filesystem::path& path) {
  vtkNew<vtkXMLImageDataReader> reader;
  if (!std::filesystem::is_regular_file(path))
    throw Error("no such file", path.string(), "run 'facenav prepare' again");
  if (!reader->CanReadFile(path.c_str())) throw malformed(path, "no .vti file");
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkImageData& image = *reader->GetOutput();
  auto* displacement = vtkShortArray::SafeDownCast(image.GetPointData()->GetAbstractArray(kDisplacement));
  if (reader->GetErrorCode() != vtkErrorCode::NoError || !displacement ||
      displacement->GetNumberOfComponents() != 3)
    throw malformed(path, "no displacement");
  volume::VoxelGrid grid;
  image.GetDimensions(grid.size.data());
  grid.mri_from_voxel = Eigen::Translation3d(Eigen::Vector3d(image.GetOrigin())) *
                        Eigen::Scaling(Eigen::Vector3d(image.GetSpacing()));
  std::vector<Eigen::Vector3f> displacement_mm(grid.count());
  const short* in = displacement->GetPointer(0);
  for (auto& d_mm : displacement_mm)
    for (int c = 0; c < 3; ++c) d_mm[c] = float(*in++ * kStep_mm);
  return AtlasMap(readAffine(image, path), grid, std::move(displacement_mm));
}

}  // namespace facenav::atlas
