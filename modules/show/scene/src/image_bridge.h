#pragma once
// Converts RgbImage <-> vtkImageData (bottom row first) and meshes -> vtkPolyData. Private to scene.

#include <vtkSmartPointer.h>

#include "facenav/core/rgb_image.h"
#include "facenav/surface/triangle_mesh.h"

class vtkImageData;
class vtkPolyData;
class vtkRenderWindow;

namespace facenav::scene {

vtkSmartPointer<vtkImageData> toVtkImage(const RgbImage& image);
/// Copies the image into `target`; allocates only if the size changed.
void copyInto(const RgbImage& image, vtkImageData* target);
vtkSmartPointer<vtkPolyData> toPolyData(const surface::TriangleMesh& mesh);
/// Renders and reads the window's pixels.
RgbImage grab(vtkRenderWindow* window);

}  // namespace facenav::scene
