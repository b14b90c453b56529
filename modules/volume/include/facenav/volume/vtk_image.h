#pragma once
// The bridge to VTK: voxels as vtkImageData in voxel coordinates (spacing 1, origin 0, so that obliquity and
// flips need no VTK feature), with mri_from_voxel as a matrix for the actor or the points.

#include <vtkSmartPointer.h>

#include "facenav/volume/volume.h"

class vtkImageData;
class vtkMatrix4x4;

namespace facenav::volume {

vtkSmartPointer<vtkImageData> toVtkImage(const Volume& volume);  // float
vtkSmartPointer<vtkImageData> toVtkImage(const Mask& mask);      // unsigned char 0/1
vtkSmartPointer<vtkMatrix4x4> toVtkMatrix(const Eigen::Matrix4d& matrix);

}  // namespace facenav::volume
