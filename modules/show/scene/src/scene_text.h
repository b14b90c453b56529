#pragma once
// Gives a text of a scene the font in force. Private to scene.

class vtkTextProperty;

namespace facenav::scene {

void useTextFont(vtkTextProperty& style);

}  // namespace facenav::scene
