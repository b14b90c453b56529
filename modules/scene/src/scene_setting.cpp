#include "scene_setting.h"

#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include "facenav/scene/palette.h"

namespace facenav::scene {

void setUpBanner(vtkTextActor* banner) {
  vtkTextProperty* words = banner->GetTextProperty();
  words->SetFontSize(22);
  words->BoldOn();
  words->SetJustificationToCentered();
  words->SetVerticalJustificationToCentered();
  words->SetColor(palette::kText[0], palette::kText[1], palette::kText[2]);
  words->SetBackgroundColor(0.02, 0.02, 0.025);
  words->SetBackgroundOpacity(0.82);
  banner->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  banner->SetPosition(0.5, 0.90);
  banner->VisibilityOff();
}

void addLights(vtkRenderer* renderer) {
  vtkNew<vtkLight> key, fill;
  key->SetLightTypeToHeadlight();
  key->SetIntensity(0.8);
  fill->SetLightTypeToCameraLight();
  fill->SetPosition(-0.8, 0.9, 0.6);
  fill->SetIntensity(0.35);
  renderer->AddLight(key);
  renderer->AddLight(fill);
}

}  // namespace facenav::scene
