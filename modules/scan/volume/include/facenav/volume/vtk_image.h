#pragma once
// Conversion to VTK: vtkImageData in voxel coordinates (spacing 1, origin 0), with mri_from_voxel as a matrix
// for the actor or the points. VTK then needs no support for obliquity and flips.

#include <vtkSmartPointer.h>

#include "facenav/volume/volume.h"

class vtkImageData;
class vtkMatrix4x4;

namespace facenav::volume {

vtkSmartPointer<vtkImageData> toVtkImage(const Volume& volume);  // float
vtkSmartPointer<vtkImageData> toVtkImage(const Mask& mask);      // unsigned char 0/1
vtkSmartPointer<vtkMatrix4x4> toVtkMatrix(const Eigen::Matrix4d& matrix);

}  // namespace facenav::volume
