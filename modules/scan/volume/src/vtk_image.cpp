#include "facenav/volume/vtk_image.h"

#include <vtkImageData.h>
#include <vtkMatrix4x4.h>

#include <algorithm>

namespace facenav::volume {
namespace {

template <class Value>
vtkSmartPointer<vtkImageData> toImage(const VoxelGrid& grid, const std::vector<Value>& voxels, int vtk_type) {
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(grid.size[0], grid.size[1], grid.size[2]);
  image->AllocateScalars(vtk_type, 1);
  std::copy(voxels.begin(), voxels.end(), static_cast<Value*>(image->GetScalarPointer()));
  return image;
}

}  // namespace

vtkSmartPointer<vtkImageData> toVtkImage(const Volume& volume) {
  return toImage(volume.grid, volume.voxels, VTK_FLOAT);
}

vtkSmartPointer<vtkImageData> toVtkImage(const Mask& mask) {
  return toImage(mask.grid, mask.voxels, VTK_UNSIGNED_CHAR);
}

vtkSmartPointer<vtkMatrix4x4> toVtkMatrix(const Eigen::Matrix4d& matrix) {
  auto out = vtkSmartPointer<vtkMatrix4x4>::New();
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) out->SetElement(r, c, matrix(r, c));
  return out;
}

}  // namespace facenav::volume
