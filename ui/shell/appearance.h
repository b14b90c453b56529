#pragma once
// Appearance: palette, style sheet, and the surface format that VTK's widgets need. Set it before
// QApplication.

#include <QObject>
#include <functional>

class QApplication;

namespace facenav::ui {

/// Call before making the QApplication.
void prepareSurfaceFormat();
/// Sets palette, style sheet and the size of all text. `text_scale`: factor of the text size.
void applyAppearance(QApplication& application, double text_scale = 1.0);
double textScale();
constexpr double kLeastTextScale = 0.75, kMostTextScale = 3.0;
/// Changes the size of all text while the program runs, and what depends on it.
void changeTextScale(QApplication& application, double text_scale);
/// Runs `apply` now, and again whenever the text size changes while `owner` lives: for lengths by sized().
void whenTextScales(QObject* owner, std::function<void()> apply);
/// The factor that the next start uses; 1 unless one was remembered.
double rememberedTextScale();
void rememberTextScale(double text_scale);
/// Scales a length that contains text: from pixels at normal text size and 96 dpi to pixels here.
int sized(int usual_px);

/// Tells that the text size has changed; see whenTextScales().
class TextScaleNotice : public QObject {
  Q_OBJECT

 public:
  static TextScaleNotice& instance();

 signals:
  void changed();
};

}  // namespace facenav::ui
