#include "image_bridge.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>

#include <cstring>

#include "facenav/core/error.h"
#include "facenav/scene/display.h"

namespace facenav::scene {

vtkSmartPointer<vtkImageData> toVtkImage(const RgbImage& image) {
  auto out = vtkSmartPointer<vtkImageData>::New();
  copyInto(image, out);
  return out;
}

void copyInto(const RgbImage& image, vtkImageData* target) {
  int size[3];
  target->GetDimensions(size);
  if (size[0] != image.width_px || size[1] != image.height_px || !target->GetPointData()->GetScalars()) {
    target->SetDimensions(image.width_px, image.height_px, 1);
    target->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  }
  const std::size_t stride = std::size_t(image.width_px) * 3;
  for (int v = 0; v < image.height_px; ++v)
    std::memcpy(target->GetScalarPointer(0, image.height_px - 1 - v, 0), image.rgb.data() + v * stride,
                stride);
  target->Modified();
}

vtkSmartPointer<vtkPolyData> toPolyData(const surface::TriangleMesh& mesh) {
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(vtkIdType(mesh.vertices_mm.size()));
  for (std::size_t i = 0; i < mesh.vertices_mm.size(); ++i)
    points->SetPoint(vtkIdType(i), mesh.vertices_mm[i].data());
  vtkNew<vtkCellArray> triangles;
  for (const auto& t : mesh.triangles) {
    const vtkIdType ids[3] = {t[0], t[1], t[2]};
    triangles->InsertNextCell(3, ids);
  }
  auto out = vtkSmartPointer<vtkPolyData>::New();
  out->SetPoints(points);
  out->SetPolys(triangles);
  if (mesh.normals.size() == mesh.vertices_mm.size()) {
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(vtkIdType(mesh.normals.size()));
    for (std::size_t i = 0; i < mesh.normals.size(); ++i)
      normals->SetTuple(vtkIdType(i), mesh.normals[i].data());
    out->GetPointData()->SetNormals(normals);
  }
  return out;
}

RgbImage grab(vtkRenderWindow* window) {
  if (const std::string problem = openGlProblem(); !problem.empty())
    throw Error("no picture can be drawn: " + problem, {}, "unset DISPLAY, or use another display");
  window->Render();
  const int* size = window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
  RgbImage image(size[0], size[1]);
  const std::size_t stride = std::size_t(size[0]) * 3;
  for (int v = 0; v < size[1]; ++v)
    std::memcpy(image.pixel(0, v), pixels->GetPointer(vtkIdType(size[1] - 1 - v) * vtkIdType(stride)),
                stride);
  return image;
}

}  // namespace facenav::scene
