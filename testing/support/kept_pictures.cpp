#include "support/kept_pictures.h"

#include <QFile>
#include <QPainter>
#include <QRegularExpression>
#include <QWidget>
#include <algorithm>
#include <cstdlib>

#include "shell/users_words.h"

namespace facenav::testing {
namespace {

constexpr int kWidth_px = 342, kHeight_px = 192, kBlock_px = 8;
constexpr int kColouredWidth_px = 228, kColouredHeight_px = 128;
constexpr double kLeastNoise =
    2.5;                          // grey levels: focus and mouse of other programs changed blocks by up to 12
constexpr double kTolerance = 6;  // times the noise
const char* const kNoise = "noise";  // text in the PNG

bool changes(const QWidget& part, const QStringList& hidden) {
  static const QRegularExpression kMoment("[0-9]{8}T[0-9]{6}Z");
  return hidden.contains(part.objectName()) || hidden.contains(part.accessibleName()) ||
         ui::holdsUsersWords(part) || part.accessibleName().contains(kMoment);
}

QImage shrunkPicture(QWidget& window, const QStringList& hidden, const QSize& size) {
  QImage picture = window.grab().toImage();
  QPainter painter(&picture);
  for (const auto* part : window.findChildren<QWidget*>())
    if (part->isVisible() && changes(*part, hidden))
      painter.fillRect(QRect(part->mapTo(&window, QPoint()), part->size()), Qt::gray);
  painter.end();
  return picture.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

/// Largest mean difference of a block, over every `channels` bytes from the first one.
double largestDifference(const QImage& a, const QImage& b, int channels, int first) {
  double largest = 0;
  for (int top = 0; top + kBlock_px <= a.height(); top += kBlock_px)
    for (int left = 0; left + kBlock_px <= a.width(); left += kBlock_px) {
      int sum = 0;
      for (int y = top; y < top + kBlock_px; ++y)
        for (int x = left; x < left + kBlock_px; ++x) {
          const int at = channels * x + first;
          sum += std::abs(int(a.constScanLine(y)[at]) - int(b.constScanLine(y)[at]));
        }
      largest = std::max(largest, double(sum) / (kBlock_px * kBlock_px));
    }
  return largest;
}

}  // namespace

QImage smallPicture(QWidget& window, const QStringList& hidden) {
  return shrunkPicture(window, hidden, {kWidth_px, kHeight_px}).convertToFormat(QImage::Format_Grayscale8);
}

QImage smallColouredPicture(QWidget& window, const QStringList& hidden) {
  return shrunkPicture(window, hidden, {kColouredWidth_px, kColouredHeight_px})
      .convertToFormat(QImage::Format_RGB888);
}

double difference(const QImage& a, const QImage& b) {
  if (a.isNull() || a.size() != b.size()) return 255;
  const bool is_grey = a.isGrayscale() && b.isGrayscale();
  const auto format = is_grey ? QImage::Format_Grayscale8 : QImage::Format_RGB888;
  const QImage alike_a = a.convertToFormat(format), alike_b = b.convertToFormat(format);
  const int channels = is_grey ? 1 : 3;
  double largest = 0;
  for (int first = 0; first < channels; ++first)
    largest = std::max(largest, largestDifference(alike_a, alike_b, channels, first));
  return largest;
}

KeptPictures::Use KeptPictures::useFromEnvironment() {
  const QByteArray wanted = qgetenv("FACENAV_WALK_PICTURES");
  return wanted == "new" ? Use::renew : wanted == "noise" ? Use::measure_noise : Use::compare;
}

QString KeptPictures::file(const QString& name) const {
  return QString::fromStdString((folder_ / name.toStdString()).string()) + ".png";
}

double KeptPictures::tolerance(const QString& name) const {
  return kTolerance * std::max(kLeastNoise, QImage(file(name)).text(kNoise).toDouble());
}

double KeptPictures::differenceFrom(const QString& name, const QImage& picture) const {
  return difference(QImage(file(name)), picture);
}

QString KeptPictures::show(const QString& name, const QImage& picture) const {
  if (use_ == Use::renew) {
    std::filesystem::create_directories(folder_);
    return picture.save(file(name), "PNG", 0) ? QString() : "cannot be written: " + file(name);
  }
  QImage kept(file(name));
  if (kept.isNull()) return "there is no kept picture of " + name;
  const double found = difference(kept, picture);
  if (use_ == Use::measure_noise) {
    kept.setText(kNoise, QString::number(std::max(found, kept.text(kNoise).toDouble()), 'f', 2));
    return kept.save(file(name), "PNG", 0) ? QString() : "cannot be written: " + file(name);
  }
  if (found <= tolerance(name)) return {};
  return QString("%1 differs from the kept picture by %2 grey levels; %3 are allowed")
      .arg(name)
      .arg(found, 0, 'f', 1)
      .arg(tolerance(name), 0, 'f', 1);
}

}  // namespace facenav::testing
