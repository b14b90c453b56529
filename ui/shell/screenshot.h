#pragma once
// Screenshot: a picture of a window as a file.

#include <QString>

class QWidget;

namespace facenav::ui {

/// Writes a picture of the window as PNG, whole and for its owner alone, since it may show a patient. Throws
/// Error.
void writeScreenshot(QWidget& window, const QString& path);
/// Asks where to keep a picture of the window as it is now, and writes it. Returns what happened, in words;
/// empty if the user gave no file. Throws Error.
QString keepScreenshot(QWidget& window);

}  // namespace facenav::ui
