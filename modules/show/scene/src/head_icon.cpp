#include "head_icon.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkConeSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkTextProperty.h>

#include <cmath>

#include "facenav/scene/palette.h"
#include "scene_text.h"

namespace facenav::scene {
namespace {

constexpr int kLetter = 15;  // font size

vtkSmartPointer<vtkActor> ellipsoid(double x, double y, double z, double rx, double ry, double rz) {
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(32);
  sphere->SetPhiResolution(24);
  sphere->SetRadius(1.0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->SetScale(rx, ry, rz);
  actor->SetPosition(x, y, z);
  actor->GetProperty()->SetColor(0.66, 0.69, 0.73);
  actor->GetProperty()->SetAmbient(0.2);
  return actor;
}

}  // namespace

HeadIcon::HeadIcon() {
  renderer_->InteractiveOff();
  renderer_->SetLayer(2);
  renderer_->GetActiveCamera()->ParallelProjectionOn();
  renderer_->GetActiveCamera()->SetParallelScale(1.95);
  renderer_->AddActor(ellipsoid(0, 0, 0.1, 0.76, 0.95, 1.0));        // skull
  renderer_->AddActor(ellipsoid(0, 0.28, -0.5, 0.52, 0.62, 0.62));   // jaw
  renderer_->AddActor(ellipsoid(0, 0.98, -0.22, 0.13, 0.22, 0.22));  // nose
  for (double side : {-1.0, 1.0}) {
    renderer_->AddActor(ellipsoid(side * 0.78, -0.05, -0.12, 0.08, 0.17, 0.25));  // ears
    auto eye = ellipsoid(side * 0.28, 0.86, 0.05, 0.11, 0.07, 0.07);
    eye->GetProperty()->SetColor(0.12, 0.14, 0.18);
    renderer_->AddActor(eye);
  }
  addLetter("R", 1.45, 0, 0);
  addLetter("L", -1.45, 0, 0);
  addLetter("A", 0, 1.62, 0);
  addLetter("P", 0, -1.55, 0);
  addLetter("S", 0, 0, 1.5);
}

void HeadIcon::addLetter(const char* letter, double x, double y, double z) {
  auto text = vtkSmartPointer<vtkBillboardTextActor3D>::New();
  setWords(*text, letter);
  text->SetPosition(x, y, z);
  text->GetTextProperty()->SetFontSize(kLetter);
  text->GetTextProperty()->BoldOn();
  text->GetTextProperty()->SetJustificationToCentered();
  text->GetTextProperty()->SetVerticalJustificationToCentered();
  text->GetTextProperty()->SetColor(palette::kText[0], palette::kText[1], palette::kText[2]);
  renderer_->AddActor(text);
  letters_.push_back(text);
}

void HeadIcon::setTextScale(double scale) {
  for (auto& text : letters_) text->GetTextProperty()->SetFontSize(int(std::lround(kLetter * scale)));
}

void HeadIcon::follow(vtkRenderer* main, const double world_R_mri[3][3]) {
  vtkCamera* camera = main->GetActiveCamera();
  const double* direction = camera->GetDirectionOfProjection();
  const double* up = camera->GetViewUp();
  double position[3], up_mri[3];
  for (int i = 0; i < 3; ++i) {  // transpose: rotation into Mri
    position[i] = up_mri[i] = 0;
    for (int j = 0; j < 3; ++j) {
      position[i] -= 6.0 * world_R_mri[j][i] * direction[j];
      up_mri[i] += world_R_mri[j][i] * up[j];
    }
  }
  vtkCamera* own = renderer_->GetActiveCamera();
  own->SetFocalPoint(0, 0, 0);
  own->SetPosition(position);
  own->SetViewUp(up_mri);
  renderer_->ResetCameraClippingRange();
}

}  // namespace facenav::scene
