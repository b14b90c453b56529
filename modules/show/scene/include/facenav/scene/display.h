#pragma once
// Checks for an X display. VTK here uses GLX and aborts the program without one, so check before creating a
// NavigationScene (SliceScene needs none).

namespace facenav::scene {

/// True if the X display named by DISPLAY can be opened.
bool hasDisplay();

}  // namespace facenav::scene
