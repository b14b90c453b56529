#pragma once
// The lights of every 3-D scene. Private to scene.

class vtkRenderer;

namespace facenav::scene {

void addLights(vtkRenderer* renderer);

}  // namespace facenav::scene
