#include "scene_setting.h"

#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

namespace facenav::scene {

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
