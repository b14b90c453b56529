#pragma once
// Appearance: dark palette, style sheet, and the surface format that VTK's widgets need (before
// QApplication).

class QApplication;

namespace facenav::ui {

/// Call before the QApplication is made.
void prepareSurfaceFormat();
void applyAppearance(QApplication& application);

}  // namespace facenav::ui
