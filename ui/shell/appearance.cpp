#include "shell/appearance.h"

#include <QVTKOpenGLNativeWidget.h>

#include <QApplication>
#include <QFile>
#include <QPalette>
#include <QRegularExpression>
#include <QScreen>
#include <QSettings>
#include <QStyleFactory>
#include <QSurfaceFormat>
#include <QVariant>
#include <algorithm>
#include <cmath>

#include "shell/theme.h"

/// The linker drops a static library's resources unless they are initialised (the macro needs the global
/// namespace).
static void initialiseResources() { Q_INIT_RESOURCE(facenav); }

namespace facenav::ui {

void prepareSurfaceFormat() {
  auto format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);  // the scenes do their own anti-aliasing
  QSurfaceFormat::setDefaultFormat(format);
}

namespace {

const char* const kTextScale = "text_scale";  // property of the application
const char* const kRememberedTextScale = "appearance/text_scale";

QString withTextScaled(QString sheet, double scale) {
  static const QRegularExpression kSize("font-size:\\s*([0-9.]+)pt");
  QString scaled;
  int done = 0;
  for (auto it = kSize.globalMatch(sheet); it.hasNext();) {
    const auto match = it.next();
    scaled += sheet.mid(done, match.capturedStart() - done) +
              QString("font-size: %1pt").arg(match.captured(1).toDouble() * scale);
    done = match.capturedEnd();
  }
  return scaled + sheet.mid(done);
}

/// Colours of what the style sheet has no rule for.
QPalette themePalette() {
  QPalette palette;
  palette.setColor(QPalette::Window, themeColour(Colour::window));
  palette.setColor(QPalette::WindowText, themeColour(Colour::text));
  palette.setColor(QPalette::Base, themeColour(Colour::field));
  palette.setColor(QPalette::AlternateBase, themeColour(Colour::panel));
  palette.setColor(QPalette::Text, themeColour(Colour::text));
  palette.setColor(QPalette::PlaceholderText, themeColour(Colour::muted));
  palette.setColor(QPalette::Button, themeColour(Colour::button));
  palette.setColor(QPalette::ButtonText, themeColour(Colour::text));
  palette.setColor(QPalette::Highlight, themeColour(Colour::menu_chosen));
  palette.setColor(QPalette::HighlightedText, themeColour(Colour::on_accent));
  palette.setColor(QPalette::Link, themeColour(Colour::link));
  palette.setColor(QPalette::ToolTipBase, themeColour(Colour::button));
  palette.setColor(QPalette::ToolTipText, themeColour(Colour::text));
  for (const auto role : {QPalette::ButtonText, QPalette::Text})
    palette.setColor(QPalette::Disabled, role, themeColour(Colour::disabled));
  return palette;
}

}  // namespace

double textScale() {
  const QVariant scale = qApp->property(kTextScale);
  return scale.isValid() ? scale.toDouble() : 1.0;
}

double rememberedTextScale() {
  return std::clamp(QSettings().value(kRememberedTextScale, 1.0).toDouble(), kLeastTextScale, kMostTextScale);
}

void rememberTextScale(double text_scale) { QSettings().setValue(kRememberedTextScale, text_scale); }

TextScaleNotice& TextScaleNotice::instance() {
  static TextScaleNotice notice;
  return notice;
}

void whenTextScales(QObject* owner, std::function<void()> apply) {
  apply();
  QObject::connect(&TextScaleNotice::instance(), &TextScaleNotice::changed, owner, std::move(apply));
}

void changeTextScale(QApplication& application, double text_scale) {
  if (text_scale == textScale()) return;
  applyAppearance(application, text_scale);
  emit TextScaleNotice::instance().changed();
}

int sized(int usual_px) {
  const QScreen* screen = QApplication::primaryScreen();
  const double dots = screen ? screen->logicalDotsPerInch() / 96.0 : 1.0;
  return int(std::lround(usual_px * textScale() * dots));
}

void applyAppearance(QApplication& application, double text_scale) {
  application.setProperty(kTextScale, text_scale);
  theme();  // looks at the desktop's colours before they are replaced
  QApplication::setStyle(QStyleFactory::create("Fusion"));
  QApplication::setPalette(themePalette());
  initialiseResources();
  QFile sheet(":/facenav/facenav.qss");
  if (sheet.open(QIODevice::ReadOnly))
    application.setStyleSheet(
        withTextScaled(withColours(QString::fromUtf8(sheet.readAll()), theme()), text_scale));
}

}  // namespace facenav::ui
