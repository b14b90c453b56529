#pragma once
// Common parts of every 3-D scene: lights, and the banner's text over it. Private to scene.

class vtkRenderer;
class vtkTextActor;

namespace facenav::scene {

void setUpBanner(vtkTextActor* banner);
void addLights(vtkRenderer* renderer);

}  // namespace facenav::scene
