#pragma once
// Appearance: dark palette, style sheet, and the surface format that VTK's widgets need. Set it before
// QApplication.

class QApplication;

namespace facenav::ui {

/// Call before making the QApplication.
void prepareSurfaceFormat();
/// Sets palette, style sheet and the size of all text. `text_scale`: factor of the text size.
void applyAppearance(QApplication& application, double text_scale = 1.0);
double textScale();
constexpr double kLeastTextScale = 0.75, kMostTextScale = 3.0;
/// The factor that the next start uses; 1 unless one was remembered.
double rememberedTextScale();
void rememberTextScale(double text_scale);
/// Scales a length that contains text: from pixels at normal text size and 96 dpi to pixels here.
int sized(int usual_px);

}  // namespace facenav::ui
