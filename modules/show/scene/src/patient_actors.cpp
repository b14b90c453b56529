#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkImageProperty.h>
#include <vtkImageSlice.h>
#include <vtkImageSliceMapper.h>
#include <vtkLookupTable.h>
#include <vtkMatrix4x4.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkTexture.h>
#include <vtkTransform.h>

#include "actors.h"
#include "facenav/volume/vtk_image.h"
#include "image_bridge.h"

namespace facenav::scene {

vtkSmartPointer<vtkPolyData> makeRectangle(const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(low.x(), low.y(), 0);
  plane->SetPoint1(high.x(), low.y(), 0);
  plane->SetPoint2(low.x(), high.y(), 0);
  plane->Update();
  return plane->GetOutput();
}

vtkSmartPointer<vtkActor> makeActor(vtkPolyData* poly, const palette::Rgb& colour) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(poly);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  setColour(actor, colour);
  return actor;
}

void setColour(vtkActor* actor, const palette::Rgb& colour) {
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
}

vtkSmartPointer<vtkActor> makeBrainActor(const surface::BrainModel& brain) {
  auto poly = toPolyData(brain.mesh);
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  for (const auto& t : brain.texture_coordinates) coordinates->InsertNextTuple2(t.x(), t.y());
  poly->GetPointData()->SetTCoords(coordinates);
  auto actor = makeActor(poly, {1.0, 0.93, 0.88});
  vtkNew<vtkImageData> image;
  image->SetDimensions(brain.map.columns, brain.map.rows, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int row = 0; row < brain.map.rows; ++row)
    for (int column = 0; column < brain.map.columns; ++column) {
      auto* p = static_cast<std::uint8_t*>(image->GetScalarPointer(column, brain.map.rows - 1 - row, 0));
      p[0] = p[1] = p[2] = brain.map.colour[std::size_t(row) * brain.map.columns + column];
    }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->InterpolateOn();
  texture->MipmapOff();
  actor->SetTexture(texture);
  actor->GetProperty()->SetAmbient(0.28);
  actor->GetProperty()->SetDiffuse(0.85);
  actor->GetProperty()->SetSpecular(0.12);
  actor->GetProperty()->SetSpecularPower(18);
  actor->GetProperty()->BackfaceCullingOn();  // closed surface: hides half of the triangles
  return actor;
}

vtkSmartPointer<vtkActor> makeScalpActor(vtkPolyData* scalp) {
  auto actor = makeActor(scalp, palette::kSkin);
  actor->GetProperty()->SetAmbient(0.30);
  actor->GetProperty()->SetDiffuse(0.85);
  actor->GetProperty()->BackfaceCullingOn();  // one layer of skin only, so triangles need no sorting
  actor->ForceTranslucentOn();
  actor->GetShaderProperty()->AddFragmentShaderReplacement(
      "//VTK::Light::Impl", true,
      "//VTK::Light::Impl\n"
      "  float facing = abs(normalVCVSOutput.z);\n"
      "  fragOutput0.a = opacity * mix(1.0, 0.30, smoothstep(0.10, 0.80, facing));\n",
      false);
  return actor;
}

vtkSmartPointer<vtkImageSlice> makeSliceActor(const volume::Volume& mri, int axis, vtkLinearTransform* head) {
  vtkNew<vtkImageSliceMapper> mapper;
  mapper->SetInputData(volume::toVtkImage(mri));
  mapper->SetOrientation(axis);
  vtkNew<vtkTransform> transform;
  transform->SetInput(head);  // head * mri_from_voxel: keeps the orientation of the scan
  transform->Concatenate(volume::toVtkMatrix(mri.grid.mri_from_voxel.matrix()));
  auto slice = vtkSmartPointer<vtkImageSlice>::New();
  slice->SetMapper(mapper);
  slice->SetUserTransform(transform);
  const double white = std::max(1e-6f, volume::percentile(mri, 0.995));
  vtkNew<vtkLookupTable> grey;
  grey->SetNumberOfTableValues(256);
  for (int i = 0; i < 256; ++i) grey->SetTableValue(i, i / 255.0, i / 255.0, i / 255.0, i < 18 ? 0.0 : 1.0);
  grey->SetRange(0.0, white);
  slice->GetProperty()->SetLookupTable(grey);
  slice->GetProperty()->UseLookupTableScalarRangeOn();
  slice->GetProperty()->SetInterpolationTypeToLinear();
  slice->GetProperty()->SetAmbient(1.0);
  slice->GetProperty()->SetDiffuse(0.0);
  return slice;
}

void setSliceIndex(vtkImageSlice* slice, int index) {
  vtkImageSliceMapper::SafeDownCast(slice->GetMapper())->SetSliceNumber(index);
}

}  // namespace facenav::scene
