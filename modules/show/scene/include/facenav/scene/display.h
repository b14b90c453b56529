#pragma once
// Checks for an X display and its OpenGL. VTK here uses GLX and aborts the program without one, so check
// before creating a NavigationScene (SliceScene needs none).

#include <string>

namespace facenav::scene {

/// What the display lacks for VTK's scenes, in words for users; empty if nothing. Remote desktops may offer
/// an OpenGL below 3.2, with which VTK crashes. Needs a display; each is tried once.
std::string openGlProblem();
/// True with a display that has what VTK's scenes need.
bool canDrawScenes();

/// True if the X display named by DISPLAY can be opened.
bool hasDisplay();

}  // namespace facenav::scene
