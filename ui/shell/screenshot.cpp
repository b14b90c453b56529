#include "shell/screenshot.h"

#include <QBuffer>
#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QPixmap>
#include <QStandardPaths>
#include <QWidget>

#include "facenav/core/whole_file.h"

namespace facenav::ui {
namespace {

void writePicture(const QPixmap& picture, const QString& path) {
  QBuffer png;
  png.open(QIODevice::WriteOnly);
  picture.save(&png, "PNG");
  writeWholeFile(path.toStdString(), png.data().toStdString());
}

}  // namespace

void writeScreenshot(QWidget& window, const QString& path) { writePicture(window.grab(), path); }

QString keepScreenshot(QWidget& window) {
  const QPixmap picture = window.grab();  // before the dialog covers it
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
  const QString name = QDateTime::currentDateTime().toString("'facenav' yyyy-MM-dd HH.mm.ss'.png'");
  const QString path =
      QFileDialog::getSaveFileName(&window, QObject::tr("Keep the picture (it may show a patient)"),
                                   QDir(folder).filePath(name), QObject::tr("Picture (*.png)"));
  if (path.isEmpty()) return {};
  writePicture(picture, path);
  return QObject::tr("picture kept: %1").arg(path);
}

}  // namespace facenav::ui
