#pragma once
// Is there anything to render on? VTK here uses GLX and aborts the program without an X display; ask before
// making a NavigationScene picture (SliceScene needs none).

namespace facenav::scene {

/// True when the X display that DISPLAY names can be opened.
bool hasDisplay();

}  // namespace facenav::scene
