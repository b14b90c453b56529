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
  QApplication::setStyle(QStyleFactory::create("Fusion"));
  QPalette palette;
  palette.setColor(QPalette::Window, QColor(16, 20, 26));
  palette.setColor(QPalette::WindowText, QColor(237, 241, 245));
  palette.setColor(QPalette::Base, QColor(11, 13, 16));
  palette.setColor(QPalette::AlternateBase, QColor(21, 25, 31));
  palette.setColor(QPalette::Text, QColor(237, 241, 245));
  palette.setColor(QPalette::PlaceholderText, QColor(158, 171, 184));
  palette.setColor(QPalette::Button, QColor(32, 39, 48));
  palette.setColor(QPalette::ButtonText, QColor(237, 241, 245));
  palette.setColor(QPalette::Highlight, QColor(38, 92, 140));
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, QColor(120, 190, 255));
  palette.setColor(QPalette::ToolTipBase, QColor(32, 39, 48));
  palette.setColor(QPalette::ToolTipText, QColor(237, 241, 245));
  palette.setColor(QPalette::Disabled, QPalette::ButtonText, QColor(110, 118, 128));
  palette.setColor(QPalette::Disabled, QPalette::Text, QColor(110, 118, 128));
  QApplication::setPalette(palette);
  initialiseResources();
  QFile sheet(":/facenav/dark.qss");
  if (sheet.open(QIODevice::ReadOnly))
    application.setStyleSheet(withTextScaled(QString::fromUtf8(sheet.readAll()), text_scale));
}

}  // namespace facenav::ui
