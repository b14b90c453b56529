#pragma once
// Appearance: dark palette, style sheet, and the surface format that VTK's widgets need (before
// QApplication).

class QApplication;

namespace facenav::ui {

/// Call before the QApplication is made.
void prepareSurfaceFormat();
/// `text_scale`: all text so much larger than usual.
void applyAppearance(QApplication& application, double text_scale = 1.0);
double textScale();
/// A length that holds text: pixels at the usual text size on a screen of 96 dots an inch, as pixels here.
int sized(int usual_px);

}  // namespace facenav::ui
