#include "coil_slice_layer.h"

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLinearTransform.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>
#include <vtkTexture.h>

#include <algorithm>

namespace facenav::scene {
namespace {

constexpr std::array<CoilCut, 2> kCuts = {CoilCut::along_handle, CoilCut::across_handle};
constexpr int kCutWidth_px = 150, kCutHeight_px = 110;  // 1 mm a pixel
constexpr double kAir = 0.07;                           // share of the window that is air, not drawn

/// Plane of a slice for a coil at Mri's origin, so that its corners are in Coil coordinates.
volume::SlicePlane planeInCoil(CoilCut cut) {
  return coilPlane(RigidTransform<Mri, Coil>(), cut, kCutWidth_px, kCutHeight_px);
}

vtkSmartPointer<vtkPolyData> rectangleOf(const volume::SlicePlane& plane) {
  auto rectangle = makeRectangle({0, 0}, {1, 1});  // gives the two triangles and texture coordinates
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < rectangle->GetNumberOfPoints(); ++i) {
    double p[3];
    rectangle->GetPoint(i, p);
    const auto corner = plane.toMri(p[0] * plane.width - 0.5, (1 - p[1]) * plane.height - 0.5);
    rectangle->GetPoints()->SetPoint(i, corner.mm.data());
    coordinates->InsertNextTuple2(p[0], p[1]);
  }
  rectangle->GetPointData()->SetTCoords(coordinates);
  rectangle->GetPointData()->SetNormals(nullptr);
  return rectangle;
}

vtkSmartPointer<vtkImageData> emptyImage() {
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(kCutWidth_px, kCutHeight_px, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  return image;
}

/// Makes an unlit slice. Pixels of air are left out rather than blended, so that a slice never hides the
/// other with air.
vtkSmartPointer<vtkActor> sliceActor(CoilCut cut, vtkImageData* image) {
  auto actor = makeActor(rectangleOf(planeInCoil(cut)), {1, 1, 1});
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->SetColorModeToDirectScalars();
  texture->InterpolateOn();
  actor->SetTexture(texture);
  actor->GetProperty()->LightingOff();
  actor->ForceOpaqueOn();
  actor->GetShaderProperty()->AddFragmentShaderReplacement(
      "//VTK::TCoord::Impl", true, "//VTK::TCoord::Impl\n  if (fragOutput0.a < 0.5) discard;\n", false);
  actor->PickableOff();
  actor->VisibilityOff();
  return actor;
}

}  // namespace

CoilSliceLayer::CoilSliceLayer(vtkRenderer* on_top, vtkLinearTransform* coil) {
  for (std::size_t i = 0; i < kCuts.size(); ++i) {
    images_[i] = emptyImage();
    actors_[i] = sliceActor(kCuts[i], images_[i]);
    actors_[i]->SetUserTransform(coil);
    on_top->AddActor(actors_[i]);
  }
}

void CoilSliceLayer::setVolume(std::shared_ptr<const volume::Volume> mri) {
  mri_ = std::move(mri);
  if (mri_) {
    SliceScene window;
    window.mri = mri_;
    setUsualWindow(window);
    black_ = window.black;
    white_ = std::max(window.white, black_ + 1e-6);
  }
  follow(mri_T_coil_);
}

void CoilSliceLayer::follow(const std::optional<RigidTransform<Mri, Coil>>& mri_T_coil) {
  mri_T_coil_ = mri_T_coil;
  is_outdated_ = mri_ && mri_T_coil_;
  for (auto& actor : actors_) actor->SetVisibility(is_outdated_);
}

void CoilSliceLayer::cut() {
  if (!is_outdated_) return;
  for (std::size_t i = 0; i < kCuts.size(); ++i) cutOne(i);
  is_outdated_ = false;
}

bool CoilSliceLayer::isShown() const { return actors_[0]->GetVisibility() != 0; }

void CoilSliceLayer::cutOne(std::size_t which) {
  const auto plane = coilPlane(*mri_T_coil_, kCuts[which], kCutWidth_px, kCutHeight_px);
  const auto values = volume::sampleSlice(*mri_, plane);
  auto* rgba = static_cast<unsigned char*>(images_[which]->GetScalarPointer());
  for (int v = 0; v < kCutHeight_px; ++v) {
    auto* row =
        rgba + std::size_t(kCutHeight_px - 1 - v) * kCutWidth_px * 4;  // VTK's first row is the lowest
    for (int u = 0; u < kCutWidth_px; ++u) {
      const double value = values[std::size_t(v) * kCutWidth_px + std::size_t(u)];
      const double share = std::clamp((value - black_) / (white_ - black_), 0.0, 1.0);
      row[4 * u] = row[4 * u + 1] = row[4 * u + 2] = static_cast<unsigned char>(255 * share);
      row[4 * u + 3] = share < kAir ? 0 : 255;
    }
  }
  images_[which]->Modified();
}

}  // namespace facenav::scene
